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

FLUX, COOLED = 2, 3  # kinds of walls in the answers of `reference`; 1: held

with open(sys.argv[1]) as f:
    case = dict(line.rstrip("\n").split(" = ", 1) for line in f)
if (case["source"] == "changing" or "shape" in case or "k_law" in case
        or case["dim"] == "3" or "periodic" in case.values()):
    sys.exit(77)  # the integrator takes times of its own; rods and rectangles with walls alone


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


# Resistance of a point: half a cell inside; on the frame, the wall.
T, source, rho_c = ask("initial_heat,source,rho_c")
L = csc_matrix((len(points), len(points)))
for d in range(dim):
    k, kind, value, b = ask(f"k_{'xy'[d]},wall_{'xy'[d]}")
    resistance = width[d] / (2 * k)
    for side in 0, -1:
        wall = along(d, side)
        resistance[wall] = np.select([kind[wall] == FLUX, kind[wall] == COOLED],
                                     [np.inf, 1 / np.fmax(b[wall], 1e-300)])
    below, above = along(d, slice(None, -1)), along(d, slice(1, None))
    g = (1 / (resistance[below] + resistance[above]) / width[d]).ravel()
    i, j = number[below].ravel(), number[above].ravel()  # the points on either side of each face
    L += csc_matrix((np.r_[g, g, -g, -g], (np.r_[i, j, i, j], np.r_[j, i, i, j])), L.shape)

inside = (slice(1, -1),) * dim
cells, frame = number[inside].ravel(), np.setdiff1d(number, number[inside])
per_capacity = diags(1 / rho_c[inside].ravel())
A = csc_matrix(per_capacity @ L[cells][:, cells])


def supply(moment):
    """What walls and source add to dT/dt at a time: held and air temperatures, given fluxes, source."""
    held, added = T.copy(), source.copy()
    for d in range(dim):
        kind, value, b = ask(f"wall_{'xy'[d]}", moment)
        for side, cell in (0, 1), (-1, -2):
            wall = along(d, side)
            held[wall] = value[wall]
            added[along(d, cell)] += np.where(kind[wall] == FLUX, value[wall] / width[d], 0)
    return per_capacity @ (L[cells][:, frame] @ held.ravel()[frame] + added[inside].ravel())


# Walls that change in time are known at equal steps, with a spline between them.
moments = np.linspace(0, t_end, 65) if "walls" in case else [0, t_end]
g = CubicSpline(moments, [supply(f"{t:.17g}") for t in moments])
begin = time.perf_counter()
march = solve_ivp(lambda t, T: A @ T + g(t), (0, t_end), T[inside].ravel(), "BDF", jac=A,
                  rtol=1e-8, atol=1e-10)

seconds = time.perf_counter() - begin

header = f"# seconds = {seconds:.9g}\n" + ",".join(["x", "y"][:dim] + ["T"])
answer = np.column_stack([points[cells], march.y[:, -1]])
np.savetxt(sys.argv[2], answer, "%.17g", ",", header=header, comments="")
