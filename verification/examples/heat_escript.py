# SPDX-License-Identifier: GPL-3.0-or-later
"""heat_escript.py CASE OUT | verify [options]: escript (run-escript), bilinear elements of finley, implicit Euler as in
its user's guide.  A rod is a strip, one element high.

    -div(A grad T) + D T = Y in the body,   n . A grad T + d T = y on its walls,   D = rho_c / dt,  Y = source + D T_old
"""
import numpy as np
from esys.escript import ContinuousFunction, Data, Function, FunctionOnBoundary, ReducedFunction, Scalar, interpolate
from esys.escript.linearPDEs import LinearPDE
from esys.finley import Brick, Rectangle

import heatladder


def field(values, space):
    data = Scalar(0, space, True)
    for i, value in enumerate(values):
        data.setValueOfDataPoint(i, float(value))
    return data


def solve(case):
    if not case.is_plain:
        raise heatladder.NotApplicable
    dim, axes, extra = case.dim, "xyz"[:case.dim], [case.width[0]] * (2 - case.dim)
    n, size = case.cells + [1] * len(extra), np.append(np.subtract(case.hi, case.lo), extra)
    body = (Brick if dim == 3 else Rectangle)(*n, **{f"l{d}": length for d, length in enumerate(size)})
    body.setX(body.getX() + np.array(case.lo + [0] * len(extra)))
    nodes, cells, edge = ContinuousFunction(body), ReducedFunction(body), FunctionOnBoundary(body)
    x, middles, feet = (np.array(space.getX().toListOfTuples()) for space in (nodes, cells, edge))
    names = ["initial_mean", "source", "rho_c", *("k_" + a for a in axes)]
    at = heatladder.reference(case, middles[:, :dim], ",".join(names), width=case.width)
    start, source, rho_c, *k = (interpolate(field(at[name], cells), Function(body)) for name in names)
    A = Data(0, (len(n), len(n)), Function(body), True)
    for d in range(dim):
        A[d, d] = k[d]
    heat, loss = np.zeros(len(feet)), np.zeros(len(feet))
    for d, a in enumerate(axes):  # at the points on the sides across each axis
        across = abs(np.array(body.getNormal().toListOfTuples())[:, d]) > 0.5
        kind, value, b = (across * column for column in heatladder.reference(case, feet[:, :dim], "wall_" + a).values())
        heat += np.where(kind == 2, value, b * value)
        loss += b
    kind, value, _ = heatladder.reference(case, x[:, :dim], "wall").values()
    projection, pde = LinearPDE(body), LinearPDE(body)
    for equation in projection, pde:
        equation.setSymmetryOn()
        equation.getSolverOptions().setTolerance(1e-10)
    projection.setValue(D=rho_c, Y=rho_c * start)  # keeps the heat of the start
    T = projection.getSolution()
    steps = case.steps(1 / (2 * (sum(at["k_" + a] / w**2 for a, w in zip(axes, case.width)) / at["rho_c"]).max()))
    D = rho_c * (steps / case.t_end)
    pde.setValue(A=A, D=D, d=field(loss, edge), y=field(heat, edge), q=field(kind == 1, nodes), r=field(value, nodes))
    for _ in range(steps):
        pde.setValue(Y=source + D * T)
        T = pde.getSolution()
    low = x[:, -1] < (extra[0] / 2 if extra else np.inf)
    return x[low, :dim], np.array(interpolate(T, nodes).toListOfTuples())[low]


heatladder.run(solve)
