# SPDX-License-Identifier: GPL-3.0-or-later
"""heat_petsc.py CASE OUT | verify [options]: PETSc by petsc4py, finite volumes on a DMDA, BDF2 (TS), a direct solver.

    dT/dt = A T + forcing,   A: conductances of the faces of each cell over its heat capacity, 1/s
"""
import numpy as np
import petsc4py

import heatladder

petsc4py.init("-ts_type bdf -ts_adapt_type none -ksp_type preonly -pc_type lu".split())
from petsc4py import PETSc  # noqa: E402


def solve(case):
    if not case.is_plain:
        raise heatladder.NotApplicable
    axes, n, width, volume = "xyz"[:case.dim], case.cells, np.array(case.width), np.prod(case.width)
    A = PETSc.DMDA().create(n, stencil_type=PETSc.DMDA.StencilType.STAR, stencil_width=1).createMatrix()
    number = np.arange(np.prod(n)).reshape(n, order="F")  # x fastest, as in a DMDA
    points = np.array(case.lo) + (np.argwhere(number >= 0)[np.argsort(number.ravel())] + 0.5) * width
    at = heatladder.reference(case, points, "initial_mean,source,rho_c," + ",".join("k_" + a for a in axes), width=width)
    capacity, heat = at["rho_c"] * volume, at["source"] * volume

    def add(cells, others, conductance):
        for i, j, c in zip(cells, others, conductance):
            A.setValue(i, i, -c / capacity[i], addv=True)
            if j is not None:
                A.setValue(i, j, c / capacity[i], addv=True)

    half = [width[d] / 2 / at["k_" + a] for d, a in enumerate(axes)]  # m^2 K/W
    for d in range(case.dim):
        low, high = (np.moveaxis(number, d, 0)[part].ravel() for part in (slice(None, -1), slice(1, None)))
        add(low, high, volume / width[d] / (half[d][low] + half[d][high]))
        add(high, low, volume / width[d] / (half[d][low] + half[d][high]))
    for d, end, place, _ in case.sides:
        cells, area = np.moveaxis(number, d, 0)[0 if end == "lo" else -1].ravel(), volume / width[d]
        feet = points[cells]
        feet[:, d] = place
        kind, value, b = heatladder.reference(case, feet, "wall_" + axes[d]).values()
        g = np.where(kind == 2, 0, area / (half[d][cells] + np.where(kind == 3, 1 / np.fmax(b, 1e-300), 0)))
        add(cells, [None] * len(cells), g)
        heat[cells] += np.where(kind == 2, area, g) * value
    A.assemble()
    T, forcing = A.createVecs()
    T.array, forcing.array = at["initial_mean"], heat / capacity
    J = A.duplicate()  # TS shifts it in place
    ts = PETSc.TS().create()
    ts.setProblemType(PETSc.TS.ProblemType.LINEAR)
    ts.setRHSFunction(lambda ts, t, T, rate: A.multAdd(T, forcing, rate), T.duplicate())
    ts.setRHSJacobian(lambda ts, t, T, J, P: A.copy(P), J, J)
    steps = case.steps(1 / (4 * (sum(at["k_" + a] / w**2 for a, w in zip(axes, width)) / at["rho_c"]).max()))
    ts.setTimeStep(case.t_end / steps)
    ts.setMaxSteps(steps)
    ts.setFromOptions()
    ts.solve(T)
    return points, T.array


heatladder.run(solve)
