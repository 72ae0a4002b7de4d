# SPDX-License-Identifier: GPL-3.0-or-later
"""heat_skfem.py CASE OUT | verify [options]: scikit-fem, elements P1 on a line, Q1 in the plane and in space, the
trapezoidal rule with a matrix factored once, as in its example 19.

    (rho_c dT/dt, v) + (k grad T, grad v) + <b T, v> = (source, v) + <flux or b T_air, v>,   T given on held walls
"""
import numpy as np
import skfem
from scipy.sparse.linalg import splu

import heatladder


@skfem.BilinearForm
def product(T, v, w):
    return w.factor * T * v


@skfem.BilinearForm
def flow(T, v, w):
    return sum(w[f"k_{a}"] * T.grad[d] * v.grad[d] for d, a in enumerate("xyz"[:w.x.shape[0]]))


@skfem.LinearForm
def load(v, w):
    return w.heat * v


def solve(case):
    if not case.is_plain:
        raise heatladder.NotApplicable
    lines, axes = [np.linspace(lo, hi, n + 1) for lo, hi, n in zip(case.lo, case.hi, case.cells)], "xyz"[:case.dim]
    mesh = (skfem.MeshLine, skfem.MeshQuad.init_tensor, skfem.MeshHex.init_tensor)[case.dim - 1](*lines)
    element = (skfem.ElementLineP1, skfem.ElementQuad1, skfem.ElementHex1)[case.dim - 1]()
    basis = skfem.Basis(mesh, element)
    ask = lambda x, what: heatladder.reference(case, np.moveaxis(np.array(x), 0, -1), what)  # noqa: E731
    at = ask(basis.global_coordinates(), "source,rho_c," + ",".join("k_" + a for a in axes))
    K, F, nodes = flow.assemble(basis, **at), load.assemble(basis, heat=at["source"]), basis.doflocs.T
    M = product.assemble(basis, factor=at["rho_c"])
    T, held = heatladder.reference(case, nodes, "initial_mean", width=case.width)["initial_mean"], [[]]
    for d, end, place, kind in case.sides:
        facets = mesh.facets_satisfying(lambda x: abs(x[d] - place) < 1e-9, boundaries_only=True)
        if kind == "dirichlet":
            held.append(basis.get_dofs(facets).all())
            T[held[-1]] = list(ask(basis.doflocs[:, held[-1]], "wall_" + axes[d]).values())[1]
        else:
            side = skfem.FacetBasis(mesh, element, facets=facets)
            _, value, b = ask(side.global_coordinates(), "wall_" + axes[d]).values()
            F += load.assemble(side, heat=value if kind == "neumann" else b * value)
            K += product.assemble(side, factor=b)
    free = basis.complement_dofs(np.concatenate(held).astype(int))
    steps = case.steps(1 / (2 * (sum(at["k_" + a] / w**2 for a, w in zip(axes, case.width)) / at["rho_c"]).max()))
    dt = case.t_end / steps
    backsolve = splu((M + dt / 2 * K)[free][:, free].tocsc()).solve
    for _ in range(steps):
        T[free] += backsolve(dt * (F - K @ T)[free])
    return nodes, T


heatladder.run(solve)
