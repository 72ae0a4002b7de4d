# SPDX-License-Identifier: GPL-3.0-or-later
"""triangles.py CASE OUT | verify [options]: SciPy, linear elements on triangles in a round body,
the trapezoidal rule.

    (M / dt + K / 2) T_new = (M / dt - K / 2) T + F

with the matrices M of rho_c, K of conductivity and cooled walls, and F of source, given fluxes and
the air.  Nodes are on rings a spacing apart, also on the walls.  The heatladder package (make
wheel, or PYTHONPATH=scripts/python) makes a program of `solve`, and gives start, source,
coefficients and walls at the nodes.  Boxes are left to other examples.
"""
import numpy as np
from scipy.sparse import coo_matrix, diags
from scipy.sparse.linalg import splu
from scipy.spatial import Delaunay

import heatladder

HELD, FLUX, COOLED = 1, 2, 3  # kinds of walls in the answers of `reference`; 0: no wall


def make_mesh(hole, radius, dx):
    """Nodes (n x 2) and triangles (m x 3) between the radii; no triangle is in the hole."""
    rings = max(4, round((radius - hole) / dx))
    nodes = []
    for r in np.linspace(hole, radius, rings + 1):
        count = max(1, round(2 * np.pi * r / dx))
        angle = 2 * np.pi * np.arange(count) / count
        nodes.append(r * np.column_stack([np.cos(angle), np.sin(angle)]))
    nodes = np.concatenate(nodes)
    triangles = Delaunay(nodes).simplices
    middle = np.hypot(*nodes[triangles].mean(axis=1).T)
    x, y = nodes[triangles].transpose(2, 0, 1)
    area = np.cross(np.stack([x[:, 1] - x[:, 0], y[:, 1] - y[:, 0]], 1),
                    np.stack([x[:, 2] - x[:, 0], y[:, 2] - y[:, 0]], 1)) / 2
    return nodes, triangles[(middle > hole) & (abs(area) > 1e-6 * dx * dx)]


def assemble(nodes, triangles, rho_c, k, source, kind, value, b):
    """M, K, F of the elements: three points a triangle, the middles of its sides, two a wall."""
    n = len(nodes)
    x, y = nodes[triangles].transpose(2, 0, 1)
    slope_x, slope_y = np.roll(y, -1, 1) - np.roll(y, 1, 1), np.roll(x, 1, 1) - np.roll(x, -1, 1)
    twice = (x * slope_x).sum(axis=1)  # the area, with a sign
    slope_x, slope_y, area = slope_x / twice[:, None], slope_y / twice[:, None], abs(twice) / 2
    rows, columns = np.repeat(triangles, 3, 1).ravel(), np.tile(triangles, 3).ravel()
    flow = np.einsum("ti,tj->tij", slope_x, slope_x) + np.einsum("ti,tj->tij", slope_y, slope_y)
    flow *= (k[triangles].mean(axis=1) * area)[:, None, None]
    hold = (rho_c[triangles].mean(axis=1) * area)[:, None, None] * (1 + np.eye(3)) / 12
    K, M = (coo_matrix((part.ravel(), (rows, columns)), (n, n)).tocsr() for part in (flow, hold))
    F = np.zeros(n)
    load = (source[triangles].sum(axis=1)[:, None] + source[triangles]) * area[:, None] / 12
    np.add.at(F, triangles, load)
    sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    sides = np.sort(sides, axis=1)
    edges, count = np.unique(sides, axis=0, return_counts=True)
    edges = edges[count == 1]  # those of one triangle are on a wall
    length = np.hypot(*(nodes[edges[:, 0]] - nodes[edges[:, 1]]).T)
    loss = np.zeros(n)
    for end in edges.T:
        np.add.at(F, end, length / 2 * value[end] * np.where(kind[end] == COOLED, b[end], kind[end] == FLUX))
        np.add.at(loss, end, length / 2 * np.where(kind[end] == COOLED, b[end], 0))
    return M, K + diags(loss), F


def solve(case):
    """Nodes (n x 2) and T at the end time (n)."""
    if case.dim != 2 or "shape" not in case:
        raise heatladder.NotApplicable
    hole, radius = case.get("r1", 0), case.get("r2", case.get("radius", 1))
    dx = case.dx
    nodes, triangles = make_mesh(hole, radius, dx)
    at = heatladder.reference(case, nodes, "initial,source,rho_c,k_x,wall")
    T, rho_c, k, kind, value = at["initial"], at["rho_c"], at["k_x"], at["wall_kind"], at["wall_value"]
    M, K, F = assemble(nodes, triangles, rho_c, k, at["source"], kind, value, at["wall_b"])
    steps = int(np.ceil(case.t_end * (k / rho_c).max() / dx**2)) + 4
    dt = case.t_end / steps
    free = kind != HELD
    T[~free] = value[~free]
    new, old = (M / dt + K / 2).tocsc(), (M / dt - K / 2).tocsr()
    solver = splu(new[free][:, free])
    constant = (F - (new - old) @ np.where(free, 0, T))[free]  # held nodes do not change
    for _ in range(steps):
        T[free] = solver.solve((old[free][:, free] @ T[free]) + constant)
    return nodes, T


if __name__ == "__main__":
    heatladder.run(solve)
