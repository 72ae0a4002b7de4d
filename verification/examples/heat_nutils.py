# SPDX-License-Identifier: GPL-3.0-or-later
"""heat_nutils.py CASE OUT | verify [options]: nutils, basis std of degree 1, integrated once, Crank-Nicolson.

    (rho_c dT/dt, v) + (k grad T, grad v) + <b T, v> = (source, v) + <flux or b T_air, v>,   T given on held walls
"""
import numpy as np
from nutils import mesh
from nutils.expression_v2 import Namespace

import heatladder

SIDES = ["left", "right", "bottom", "top", "front", "back"]


def solve(case):
    if not heatladder.Case({key: word for key, word in case.items() if word != "periodic"}).is_plain:
        raise heatladder.NotApplicable
    axes = "xyz"[:case.dim]
    edges = [np.linspace(lo, hi, n + 1) for lo, hi, n in zip(case.lo, case.hi, case.cells)]
    around = [d for d, axis in enumerate(axes) if case[f"side_{axis}_lo"] == "periodic"]
    body, geometry = mesh.rectilinear(edges, periodic=around)
    grid = lambda lines: np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, case.dim)  # noqa: E731
    middles = grid([(line[1:] + line[:-1]) / 2 for line in edges])
    nodes = grid([line[:-1] if d in around else line for d, line in enumerate(edges)])
    at = heatladder.reference(case, middles, "initial_mean,source,rho_c," + ",".join("k_" + axis for axis in axes),
                              width=case.width)
    ns, cell = Namespace(), body.basis("discont", degree=0)
    ns.x = geometry
    ns.define_for("x", gradient="∇", jacobians=("dV", "dS"))
    ns.v = body.basis("std", degree=1)
    for name, column in zip(["T", "s", "c", "k0", "k1", "k2"], at.values()):
        setattr(ns, name, cell @ column)
    diffusion = " + ".join(f"k{d} ∇_{d}(v_m) ∇_{d}(v_n)" for d in range(case.dim))
    C, K, heat, start = body.integrate(["c v_m v_n dV" @ ns, f"({diffusion}) dV" @ ns, "s v_n dV" @ ns,
                                        "c T v_n dV" @ ns], degree=2)
    how = {"precon": "diag", "rtol": 1e-9} if case.dim == 3 else {}  # a factorization fills in
    T, held = C.solve(start, **how), np.full(len(nodes), np.nan)  # a projection, which keeps the heat
    for d, end, place, kind in case.sides:
        if kind == "dirichlet":
            on = np.isclose(nodes[:, d], place)
            held[on] = list(heatladder.reference(case, nodes[on], "wall_" + axes[d]).values())[1]
        elif kind != "periodic":
            feet = middles.copy()
            feet[:, d] = place
            _, value, b = heatladder.reference(case, feet, "wall_" + axes[d]).values()
            ns.b, ns.q = cell @ (b if kind == "robin" else 0 * b), cell @ (b * value if kind == "robin" else value)
            film, flux = body.boundary[SIDES[2 * d + (end == "hi")]].integrate(
                ["b v_m v_n dS" @ ns, "q v_n dS" @ ns], degree=2)
            K, heat = K + film, heat + flux
    T = np.where(np.isnan(held), T, held)
    k = sum(at["k_" + axis] / w**2 for axis, w in zip(axes, case.width))
    steps = case.steps(1 / (2 * (k / at["rho_c"]).max()))
    A, B = C * (steps / case.t_end) + K * 0.5, C * (steps / case.t_end) + K * -0.5
    for _ in range(steps):
        T = A.solve(B @ T + heat, constrain=held, **how)
    return nodes, T


heatladder.run(solve)
