# SPDX-License-Identifier: GPL-3.0-or-later
"""lines.py CASE OUT: SciPy, the method of lines: finite volumes on a grid of cells, solve_ivp's BDF
in time.

    rho_c dT/dt = L T + source,   L T = sum over the faces of a cell of conductance (T_beyond - T) / width

The case file gives the grid and the end time.  `heatladder reference` gives all else (start,
source, coefficients, walls) at the centres of the cells and of the faces on the sides.  $HEATLADDER
is the path of that program.
"""
import os
import subprocess
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.sparse import csc_matrix, diags

HELD, FLUX, COOLED = 1, 2, 3  # kinds of walls in the answers of `reference`

with open(sys.argv[1]) as f:
    case = dict(line.rstrip("\n").split(" = ", 1) for line in f)
if {"shape", "contact_resistance", "conductivity"} & case.keys() or case["dim"] == "3" or "periodic" in case.values():
    sys.exit(77)  # rods and rectangles with walls alone
if "latent" in case:
    sys.exit(77)


def numbers(key):
    return np.array([float(word) for word in case[key].split(",")])


lo, hi, n, t_end = numbers("lo"), numbers("hi"), numbers("cells").astype(int), float(case["t_end"])
dim, width = len(n), (hi - lo) / n

# The points: cells 1 to n along each axis, in a frame of the centres of the faces on the sides
# (drawn in cells.c).
axes = [np.clip(lo[d] + (np.arange(n[d] + 2) - 0.5) * width[d], lo[d], hi[d]) for d in range(dim)]
points = np.stack([x.ravel() for x in np.meshgrid(*axes, indexing="ij")], axis=1)
number = np.arange(len(points)).reshape(n + 2)
file = sys.argv[2] + ".points"
np.savetxt(file, np.hstack([points, np.tile(width, (len(points), 1))]), "%.17g", ",", comments="",
           header=",".join(["x", "y"][:dim] + ["dx", "dy"][:dim]))


def ask(what, moment="0"):
    """The named columns at a time, each as an array over the framed grid."""
    program = os.environ.get("HEATLADDER", "heatladder")
    words = [program, "reference", *case["oracle"].split(), "--points", file, "--time", moment, "--what", what]
    run = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True)
    answer = run.stdout.splitlines()
    columns = np.array([[float(x) for x in line.split(",")] for line in answer[1:]])[:, dim:].T
    return columns.reshape(-1, *(n + 2))


def along(d, part):
    """Those cells, or points of the frame, that `part` selects along axis d."""
    return tuple(part if e == d else slice(1, -1) for e in range(dim))


def harmonic(below, above):
    return 2 / (1 / below + 1 / above)


def arithmetic(below, above):
    return (below + above) / 2


def k_of(T):
    """k by the law of the case, with u = T - k_ref."""
    u, k_0 = T - float(case["k_ref"]), float(case["k_0"])
    if case["k_law"] == "linear":
        return k_0 * (1 + float(case["k_beta"]) * u)
    return k_0 * np.maximum(u, 0) ** float(case["k_n"])


# Across each axis: k, and for its faces the distance between the points on either side and, on the
# frame, what the wall resists.
T, source, rho_c = ask("initial_mean,source,rho_c")
k, kinds, distance, resists = [], [], [], []
for d in range(dim):
    k_d, kind, value, b = ask(f"k_{'xy'[d]},wall_{'xy'[d]}")
    k.append(k_d)
    kinds.append(kind)
    distance.append(np.full(kind[along(d, slice(1, None))].shape, width[d]))
    resists.append(np.zeros(distance[d].shape))
    for side in 0, -1:
        wall = along(d, side)
        face = (slice(None),) * d + (side,)
        distance[d][face] /= 2
        resists[d][face] = np.select([kind[wall] == FLUX, kind[wall] == COOLED],
                                     [np.inf, 1 / np.fmax(b[wall], 1e-300)])


def operator(k, mean):
    """L over cells and frame, from the mean of k on either side of each face."""
    L = csc_matrix((len(points), len(points)))
    for d in range(dim):
        below, above = along(d, slice(None, -1)), along(d, slice(1, None))
        with np.errstate(divide="ignore"):  # k = 0: no heat
            g = (1 / (distance[d] / mean(k[d][below], k[d][above]) + resists[d]) / width[d]).ravel()
        i, j = number[below].ravel(), number[above].ravel()
        L += csc_matrix((np.r_[g, g, -g, -g], (np.r_[i, j, i, j], np.r_[j, i, i, j])), L.shape)
    return L


L = operator(k, harmonic)
inside = (slice(1, -1),) * dim
cells, frame = number[inside].ravel(), np.setdiff1d(number, number[inside])
per_capacity = diags(1 / rho_c[inside].ravel())
A = csc_matrix(per_capacity @ L[cells][:, cells])


def supply(moment):
    """Held and air temperatures on the frame, and what given fluxes and source add, W m^-3, at a time."""
    added, *walls = ask("source" + "".join([f",wall_{axis}" for axis in "xy"[:dim]]), moment)
    held = T.copy()
    for d in range(dim):
        kind, value, b = walls[3 * d:3 * d + 3]
        for side, cell in (0, 1), (-1, -2):
            wall = along(d, side)
            held[wall] = value[wall]
            added[along(d, cell)] += np.where(kind[wall] == FLUX, value[wall] / width[d], 0)
    return held.ravel()[frame], added[inside].ravel()


def rate(T, held, added):
    """dT/dt where k depends on T: its arithmetic mean, as the harmonic one lets no heat into a cell with k = 0."""
    framed = np.empty(n + 2)
    framed.ravel()[cells], framed.ravel()[frame] = T, held
    k = [k_of(framed) for d in range(dim)]
    for d in range(dim):
        for side, cell in (0, 1), (-1, -2):
            wall = along(d, side)
            k[d][wall] = np.where(kinds[d][wall] == HELD, k[d][wall], k[d][along(d, cell)])
    return per_capacity @ ((operator(k, arithmetic) @ framed.ravel())[cells] + added)


# Data that change in time are known at equal steps, with splines between them: the integrator takes
# times of its own.
changing = "walls" in case or case["source"] == "changing"
moments = np.linspace(0, t_end, 65) if changing else [0, t_end]
held, added = zip(*[supply(f"{t:.17g}") for t in moments])
if "k_law" in case:
    held, added = CubicSpline(moments, held), CubicSpline(moments, added)
    system = {"fun": lambda t, T: rate(T, held(t), added(t)), "jac_sparsity": A != 0}
else:
    g = CubicSpline(moments, [per_capacity @ (L[cells][:, frame] @ h + a) for h, a in zip(held, added)])
    system = {"fun": lambda t, T: A @ T + g(t), "jac": A}
begin = time.perf_counter()
march = solve_ivp(t_span=(0, t_end), y0=T[inside].ravel(), method="BDF", rtol=1e-8, atol=1e-10, **system)

seconds = time.perf_counter() - begin

header = f"# seconds = {seconds:.9g}\n" + ",".join(["x", "y"][:dim] + ["T"])
answer = np.column_stack([points[cells], march.y[:, -1]])
np.savetxt(sys.argv[2], answer, "%.17g", ",", header=header, comments="")
