# SPDX-License-Identifier: GPL-3.0-or-later
"""heat_calculix.py CASE OUT | verify [options]: CalculiX (ccx), bricks DC3D8, *HEAT TRANSFER with equal increments
(implicit Euler), numbers of at most 20 characters.  A rod or a rectangle is one element thick along its other axes.
"""
import itertools
import subprocess
import tempfile
import heatladder
import numpy as np

CORNERS = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)])
FACES = {(2, "lo"): 1, (2, "hi"): 2, (1, "lo"): 3, (0, "hi"): 4, (1, "hi"): 5, (0, "lo"): 6}


def rows(form, *columns):
    return [form.format(*values) for values in zip(*columns)]


def solve(case):
    if not case.is_plain:
        raise heatladder.NotApplicable
    dim, axes, flat = case.dim, "xyz"[:case.dim], 3 - case.dim
    n, lo, width = case.cells + [1] * flat, case.lo + [0] * flat, np.array(case.width + case.width[:1] * flat)
    index, cells = (np.array(list(np.ndindex(*shape))) for shape in ([m + 1 for m in n], n))
    nodes, middles = lo + index * width, lo + (cells + 0.5) * width
    of = np.arange(1, len(nodes) + 1)
    corners = of.reshape([m + 1 for m in n])[tuple((cells[:, None] + CORNERS).transpose(2, 0, 1))]
    at = heatladder.reference(case, middles[:, :dim], "source,rho_c," + ",".join("k_" + a for a in axes))
    start = heatladder.reference(case, nodes[:, :dim], "initial_mean", width=case.width)["initial_mean"]
    k = [at["k_" + a] for a in (axes + "xx")[:3]]
    deck = ["*NODE, NSET=ALL", *rows("{}, {:.12e}, {:.12e}, {:.12e}", of, *nodes.T)]
    materials, number = np.unique(np.stack([*k, at["rho_c"]], axis=1), axis=0, return_inverse=True)
    for m, (kx, ky, kz, rho_c) in enumerate(materials):
        mine = np.flatnonzero(number == m)
        deck += [f"*ELEMENT, TYPE=DC3D8, ELSET=E{m}", *rows("{}" + ", {}" * 8, mine + 1, *corners[mine].T),
                 f"*MATERIAL, NAME=M{m}", "*DENSITY", "1.", "*SPECIFIC HEAT", f"{rho_c:.12e}",
                 "*CONDUCTIVITY, TYPE=ORTHO", f"{kx:.12e}, {ky:.12e}, {kz:.12e}",
                 f"*SOLID SECTION, ELSET=E{m}, MATERIAL=M{m}"]
    deck += ["*INITIAL CONDITIONS, TYPE=TEMPERATURE", *rows("{}, {:.12e}", of, start)]
    steps = case.steps(1 / (2 * max((k[d] / at["rho_c"]).max() / width[d]**2 for d in range(dim))))
    deck += [f"*STEP, INC={steps + 1}", "*HEAT TRANSFER, DIRECT", f"{case.t_end / steps:.12e}, {case.t_end:.12e}",
             "*DFLUX", *rows("{}, BF, {:.12e}", itertools.count(1), at["source"])]
    for d, end, place, kind in case.sides:
        last = end == "hi"
        side, on = np.flatnonzero(cells[:, d] == last * (n[d] - 1)), np.flatnonzero(index[:, d] == last * n[d])
        feet = np.where(np.arange(dim) == d, place, (nodes[on] if kind == "dirichlet" else middles[side])[:, :dim])
        _, value, b = heatladder.reference(case, feet, "wall_" + axes[d]).values()
        deck += {"dirichlet": ["*BOUNDARY", *rows("{0}, 11, 11, {1:.12e}", on + 1, value)],
                 "neumann": ["*DFLUX", *rows(f"{{}}, S{FACES[d, end]}, {{:.12e}}", side + 1, value)],
                 "robin": ["*FILM", *rows(f"{{}}, F{FACES[d, end]}, {{:.12e}}, {{:.12e}}", side + 1, value, b)]}[kind]
    deck += [f"*NODE PRINT, NSET=ALL, FREQUENCY={steps}", "NT", "*END STEP"]
    with tempfile.TemporaryDirectory() as folder:
        np.savetxt(f"{folder}/heat.inp", deck, "%s")
        subprocess.run(["ccx", "heat"], cwd=folder, stdout=subprocess.DEVNULL, check=True)
        T = np.loadtxt(f"{folder}/heat.dat", skiprows=3)[:, 1]
    low = (index[:, dim:] == 0).all(axis=1)  # one layer
    return nodes[low, :dim], T[low]


heatladder.run(solve)
