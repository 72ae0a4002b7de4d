# SPDX-License-Identifier: GPL-3.0-or-later
"""solid.py CASE OUT: finite volumes on a box of cells in three dimensions, explicit Euler.

    rho_c dT/dt = source + sum over the faces of a cell of (heat flux into the cell) / width

A rod or a rectangle is a thin box: along the axes that the case does not have nothing changes, and
the answer is one layer.  `heatladder reference` gives start, source, coefficients and walls at the
centres of the cells and of the faces on the sides.  $HEATLADDER is the path of that program.
"""
import os
import subprocess
import sys

import numpy as np

LAYERS = 2  # along an axis that the case does not have
FLUX, COOLED = 2, 3  # kinds of walls in the answers of `reference`; 1: held

with open(sys.argv[1]) as f:
    case = dict(line.rstrip("\n").split(" = ", 1) for line in f)
if {"shape", "walls", "k_law", "contact_resistance", "conductivity"} & case.keys() or "periodic" in case.values():
    sys.exit(77)  # boxes with steady walls


def numbers(key):
    return np.array([float(word) for word in case[key].split(",")])


lo, hi, n, t_end = numbers("lo"), numbers("hi"), numbers("cells").astype(int), float(case["t_end"])
width = (hi - lo) / n
dim = len(n)
box = np.append(n, [LAYERS] * (3 - dim)).astype(int)
spacing = np.append(width, [width[0]] * (3 - dim))

# The points of the case: cells 1 to n along each of its axes, framed by the faces on the sides.
axes = [np.clip(lo[a] + (np.arange(n[a] + 2) - 0.5) * width[a], lo[a], hi[a]) for a in range(dim)]
points = np.stack([x.ravel() for x in np.meshgrid(*axes, indexing="ij")], axis=1)
file = sys.argv[2] + ".points"
np.savetxt(file, np.hstack([points, np.tile(width, (len(points), 1))]), "%.17g", ",", comments="",
           header=",".join(["x", "y", "z"][:dim] + ["dx", "dy", "dz"][:dim]))


def ask(times, what):
    """The named columns, each as an array over the framed box; layers of a thin box are equal."""
    program = os.environ.get("HEATLADDER", "heatladder")
    words = [program, "reference", *case["oracle"].split(), "--points", file, "--time", times, "--what", what]
    run = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True)
    answer = run.stdout.splitlines()
    columns = np.array([[float(x) for x in line.split(",")] for line in answer[1:]])[:, dim:].T
    layers = [column.reshape(-1, *(n + 2), *[1] * (3 - dim)) for column in columns]
    return [np.broadcast_to(layer, (len(layer), *(box + 2))) for layer in layers]


T, source, rho_c = [column[0].copy() for column in ask("0", "initial_mean,source,rho_c")]
inside = (slice(1, -1),) * 3


def along(d, part):
    """Those cells, or faces between cells, that `part` selects along axis d."""
    return tuple(part if e == d else slice(1, -1) for e in range(3))


# Resistance of a point: half a cell inside; on the frame, the wall.  The heat of a given flux is in
# the source.
conductance = []  # W m^-2 K^-1, of the faces across each axis
fastest = 0
for d in range(3):
    axis = "xyz"[d if d < dim else 0]
    k, kind, value, b = [column[0] for column in ask("0", f"k_{axis},wall_{axis}")]
    resistance = spacing[d] / (2 * k)
    for side, cell in (0, 1), (-1, -2):
        wall = along(d, side)
        if d >= dim:
            resistance[wall] = np.inf
            continue
        resistance[wall] = np.select([kind[wall] == FLUX, kind[wall] == COOLED],
                                     [np.inf, 1 / np.fmax(b[wall], 1e-300)])
        T[wall] = value[wall]
        source[along(d, cell)] += np.where(kind[wall] == FLUX, value[wall] / spacing[d], 0)
    above, below = resistance[along(d, slice(1, None))], resistance[along(d, slice(None, -1))]
    conductance.append(1 / (above + below))
    fastest = fastest + k[inside] / spacing[d] ** 2 / rho_c[inside]

steps = int(np.ceil(t_end * fastest.max() / 0.25))
changing = case["source"] == "changing"
if changing:  # asked for at the start of every step
    fluxes = source - ask("0", "source")[0][0]
    sources = ask(f"0:{t_end}:{steps + 1}", "source")[-1]
for step in range(steps):
    if changing:
        source = fluxes + sources[step]
    rate = source[inside].copy()
    for d in range(3):
        flux = conductance[d] * np.diff(T[along(d, slice(None))], axis=d)
        rate += np.diff(flux, axis=d) / spacing[d]
    T[inside] += t_end / steps * rate / rho_c[inside]

layer = T[inside][(slice(None),) * dim + (0,) * (3 - dim)]
cells = points.reshape(*(n + 2), dim)[(slice(1, -1),) * dim].reshape(-1, dim)
np.savetxt(sys.argv[2], np.column_stack([cells, layer.ravel()]), "%.17g", ",", comments="",
           header=f"# steps = {steps}\n" + ",".join(["x", "y", "z"][:dim] + ["T"]))
