# SPDX-License-Identifier: GPL-3.0-or-later
"""heat_fipy.py CASE OUT [arithmetic | tight] | verify [options]: FiPy, finite volumes, implicit steps and the Robin walls
of its manual, n.(a T + b grad T) = g: a = n h, b = k, g = h T_air, or a = 0 and g = flux.

    TransientTerm(rho_c) == DiffusionTerm(k) + source,   k: the harmonic or the arithmetic mean of the cells of a face

Its direct solver leaves T where the residual is below `tolerance`, 1e-5 of its scale by default; tight: 1e-12.
"""
import sys

import fipy
import numpy as np

import heatladder

setting = sys.argv.pop() if sys.argv[-1] in ("arithmetic", "tight") else ""
mean = "arithmetic" if setting == "arithmetic" else "harmonic"


def solve(case):
    if not case.is_plain:
        raise heatladder.NotApplicable
    dims, along = range(case.dim), ["k_" + a for a in "xyz"[:case.dim]]
    # Equal widths as a list: a grid of one number has no cellDistanceVectors, which the recipe of Robin walls needs.
    widths = {"d" + "xyz"[d]: [case.width[d]] * case.cells[d] for d in dims}
    mesh = (fipy.Grid1D, fipy.Grid2D, fipy.Grid3D)[case.dim - 1](**widths) + [[lo] for lo in case.lo]
    points, faces, n = mesh.cellCenters.value.T, mesh.faceCenters.value.T, mesh.faceNormals
    at = heatladder.reference(case, points, ",".join(["initial_mean,source,rho_c", *along]), width=case.width)
    cells = {name: fipy.CellVariable(mesh=mesh, value=column) for name, column in at.items()}
    k = sum(abs(n[d]) * getattr(cells[along[d]], mean + "FaceValue") for d in dims).value  # along the normal of each face
    T, inner = cells["initial_mean"], k.copy()
    mask, held, g, h = np.zeros((4, len(faces)))
    for d, _, place, kind in case.sides:
        side = abs(faces[:, d] - place) < 1e-9
        _, value, b = heatladder.reference(case, faces[side], "wall_" + "xyz"[d]).values()
        if kind == "dirichlet":
            held[side] = value
            T.constrain(held, where=side)
        else:
            inner[side], mask[side], h[side] = 0, 1, b
            g[side] = value if kind == "neumann" else b * value
    face = lambda value: fipy.FaceVariable(mesh=mesh, value=value)  # noqa: E731
    dPf, a = face(mesh._faceToCellDistanceRatio * mesh.cellDistanceVectors), face(h * n)
    robin = face(mask) * face(k) * n / (dPf.dot(a) + face(k))
    equation = (fipy.TransientTerm(cells["rho_c"]) == fipy.DiffusionTerm(face(inner)) + cells["source"]
                + (robin * face(g)).divergence - fipy.ImplicitSourceTerm((robin * a.dot(n)).divergence))
    steps = case.steps(1 / (2 * (sum(at[name] / w**2 for name, w in zip(along, case.width)) / at["rho_c"]).max()))
    solver = fipy.LinearLUSolver(tolerance=1e-12) if setting == "tight" else None
    for _ in range(steps):
        equation.solve(T, dt=case.t_end / steps, solver=solver)
    return points, T.value


heatladder.run(solve)
