# SPDX-License-Identifier: GPL-3.0-or-later
"""heat_pypde.py CASE OUT | verify [options]: py-pde, a PDE class of one's own on a CartesianGrid, explicit Euler.

    rho_c dT/dt = k lap T + grad k . grad T + source,   the form in py-pde's example of a varying diffusivity

Its Laplacian (backend scipy; numba compiles for seconds in each run) has one spacing, and here k is that of all axes.
"""
import numpy as np
from pde import CartesianGrid, PDEBase, ScalarField

import heatladder


class Heat(PDEBase):
    def __init__(self, k, rho_c, source, bc):
        super().__init__()
        self.k, self.rho_c, self.source, self.bc = k, rho_c, source, bc
        self.grad_k = k.gradient({"derivative": 0}, backend="scipy")

    def evolution_rate(self, state, t=0):
        heat = self.k * state.laplace(self.bc, backend="scipy") + self.source
        if np.ptp(self.k.data) > 0:
            heat += self.grad_k @ state.gradient(self.bc, backend="scipy")
        return heat / self.rho_c


def solve(case):
    if not case.is_plain:
        raise heatladder.NotApplicable
    axes, width = "xyz"[:case.dim], case.width
    grid = CartesianGrid(list(zip(case.lo, case.hi)), case.cells)
    centres = grid.cell_coords
    at = heatladder.reference(case, centres.reshape(-1, case.dim), "initial_mean,source,rho_c,"
                              + ",".join("k_" + axis for axis in axes), width=width)
    T, source, rho_c, k, *others = (ScalarField(grid, np.reshape(column, grid.shape)) for column in at.values())
    if not np.allclose(width, width[0]) or not all(np.allclose(k.data, other.data) for other in others):
        raise heatladder.NotApplicable
    bc = {}
    for d, end, place, kind in case.sides:
        feet, k_wall = (np.take(values, 0 if end == "lo" else -1, axis=d) for values in (centres, k.data))
        feet[..., d] = place
        wall = heatladder.reference(case, feet.reshape(-1, case.dim), "wall_" + axes[d])
        _, value, b = (np.reshape(column, k_wall.shape) for column in wall.values())
        bc[axes[d] + ("-" if end == "lo" else "+")] = {
            "dirichlet": {"value": value}, "neumann": {"derivative": value / k_wall},
            "robin": {"type": "mixed", "value": b / k_wall, "const": b * value / k_wall}}[kind]
    steps = case.steps(width[0]**2 / (4 * case.dim * (k.data / rho_c.data).max()))
    T = Heat(k, rho_c, source, bc).solve(T, case.t_end, dt=case.t_end / steps, backend="numpy", tracker=None)
    return centres, T.data


heatladder.run(solve)
