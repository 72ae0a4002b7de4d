# SPDX-License-Identifier: GPL-3.0-or-later
"""cells.py CASE OUT [corner]: finite volumes on a grid of cells, explicit Euler.

    rho_c dT/dt = source + sum over the faces of a cell of conductance (T_beyond - T)

The case file gives the grid and the end time.  `heatladder reference` gives all else (start,
source, coefficients, walls) at the centres of the cells and of the faces on the sides.  $HEATLADDER
is the path of that program.
"""
import itertools
import math
import os
import subprocess
import sys
import time

PERIODIC, FLUX, COOLED = 0, 2, 3  # kinds of sides in the answers of `reference`; 1: held


def read_case(path):
    """The `key = value` lines of the case as a dictionary of strings."""
    with open(path) as f:
        return dict(line.rstrip("\n").split(" = ", 1) for line in f)


def numbers(text):
    return [float(word) for word in text.split(",")]


class Reference:
    """Asks `heatladder reference` about the scene of a case, at points that are written once."""

    def __init__(self, oracle, path, points, width):
        self.path, self.dim = path, len(width)
        program = os.environ.get("HEATLADDER", "heatladder")
        self.words = [program, "reference", *oracle.split(), "--points", path]
        with open(path, "w") as f:
            print(*["x", "y", "z"][:self.dim], *["dx", "dy", "dz"][:self.dim], sep=",", file=f)
            for point in points:
                print(*point, *width, sep=",", file=f)

    def ask(self, times, what):
        """A list of numbers for each point (and each time), without the point itself."""
        answer = subprocess.run(self.words + ["--time", times, "--what", what],
                                check=True, stdout=subprocess.PIPE, text=True).stdout
        return [numbers(line)[self.dim:] for line in answer.splitlines()[1:]]


case = read_case(sys.argv[1])
melts = case.get("k_law") == "phases"
if "shape" in case or ("k_law" in case and not melts):
    sys.exit(77)  # a round body, which cells do not fill; k(T) without phases
dim, t_end = int(case["dim"]), float(case["t_end"])
lo, hi = numbers(case["lo"]), numbers(case["hi"])
n = [int(word) for word in case["cells"].split(",")]
width = [(hi[d] - lo[d]) / n[d] for d in range(dim)]
contact, interface = float(case.get("contact_resistance", 0)), float(case.get("interface", "nan"))
if melts:  # a solid below the melting point and a liquid above, by their enthalpy from there
    melting_point, latent = float(case["k_ref"]), float(case["latent"])
    k_phase, rho_c_phase = numbers(case["k_phases"]), numbers(case["rho_c_phases"])


def heat_at(T):
    u = T - melting_point
    return rho_c_phase[u > 0] * u + (latent if u > 0 else 0)


def temperature_at(heat):
    """A cell is at the melting point while it takes its latent heat."""
    return melting_point + (max(heat - latent, 0) / rho_c_phase[1] if heat > 0 else heat / rho_c_phase[0])


def potential(T):
    """The integral of k from the melting point: the flux through a face is its difference."""
    return k_phase[T > melting_point] * (T - melting_point)


# The points: cells 1 to n along each axis, in a frame of the centres of the faces on the sides
# (drawn in cells.c).
axes = [[lo[d]] + [lo[d] + (i + 0.5) * width[d] for i in range(n[d])] + [hi[d]] for d in range(dim)]
points = [p[::-1] for p in itertools.product(*axes[::-1])]  # x fastest
stride = [math.prod(m + 2 for m in n[:d]) for d in range(dim)]  # from a point to the next along an axis


def on_side(e, d):
    return not lo[d] < points[e][d] < hi[d]


def beyond(c, d, way):
    """The next point along an axis; where periodic sides meet, the cell at the opposite one."""
    e = c + way * stride[d]
    return e - way * n[d] * stride[d] if on_side(e, d) and wall[e][d][0] == PERIODIC else e


cells = [c for c in range(len(points)) if not any(on_side(c, d) for d in range(dim))]

reference = Reference(case["oracle"], sys.argv[2] + ".points", points, width)
what = "initial_mean,source,rho_c" + "".join([f",k_{axis},wall_{axis}" for axis in "xyz"[:dim]])
scene = reference.ask("0", what)
T = [values[0] for values in scene]
source = [values[1] for values in scene]
rho_c = [values[2] for values in scene]
k = [values[3::4] for values in scene]  # along each axis
wall = [[values[4 + 4 * d:7 + 4 * d] for d in range(dim)] for values in scene]  # kind, value, b

has_cross = {"k_xy", "conductivity"} & case.keys()
by_corners = sys.argv[3:] == ["corner"] and has_cross and dim == 2

# The faces of each cell: half cells in series, or a half cell and what the wall resists.
flux = [0.0] * len(points)
faces = [[] for point in points]  # of each cell, pairs (point beyond, conductance)
beside = []  # the cell at each point of the frame that has one: (point, axis, cell)
fastest = 0
for c in cells:
    for d in range(dim):
        for e in (beyond(c, d, -1), beyond(c, d, 1)):
            kind, value, b = wall[e][d]
            resistance = width[d] / (2 * (1 if melts else k[c][d]))
            if on_side(e, d):
                beside.append((e, d, c))
            if on_side(e, d) and kind == FLUX:
                continue
            if by_corners:
                continue
            if "conductivity" in case:  # K at the face, the mean of both cells
                faces[c].append((e, (2 * k[e][d] if on_side(e, d) else (k[c][d] + k[e][d]) / 2) / width[d] ** 2))
                continue
            if on_side(e, d):
                resistance += 1 / b if kind == COOLED else 0
            else:
                resistance += width[d] / (2 * (1 if melts else k[e][d]))
            if contact > 0 and (points[c][0] < interface) != (points[e][0] < interface):
                resistance += contact
            faces[c].append((e, 1 / (resistance * width[d])))
    fastest = max(fastest, sum(k[c][d] / (width[d] ** 2 * rho_c[c]) for d in range(dim)))

# A tensor: K_ab times the derivative along b is a flux across a, the mean over the two cells of a face; none
# through a held wall, along which T is uniform, and 2 T_wall - T beyond it.  None through an insulated wall either:
# K grad T along b is 0 there, so that the derivative along b is -K_ab/K_bb of that along a.
names = ["k_xy", "k_xz", "k_yz"][:2 * dim - 3]
cross = reference.ask("0", ",".join(names)) if has_cross and not by_corners else []
for c in cells if cross else []:
    for (a, b), way in itertools.product(itertools.permutations(range(dim), 2), (-1, 1)):
        e = beyond(c, a, way)
        K = (cross[c][a + b - 1] + cross[e][a + b - 1]) / 2
        for x, side in itertools.product((c, e) if not on_side(e, a) else (), (-1, 1)):
            f, g = beyond(x, b, side), way * side * K / (4 * width[a] * width[b])
            if on_side(f, b) and wall[f][b][0] == FLUX:
                faces[c] += [(x, g), (e, -K / k[x][b] * K / (4 * width[a] ** 2))]
            else:
                faces[c] += [(f, 2 * g), (x, -g)] if on_side(f, b) else [(f, g)]


def image(e):
    """The temperature at a point, beyond walls of its mirror image, as pairs (point, share)."""
    inside, sides = e, []
    for d in range(dim):
        if on_side(e, d):
            kind = wall[e][d][0]
            far = stride[d] * (n[d] if kind == PERIODIC else 1) * (1 if points[e][d] == lo[d] else -1)
            inside += far
            e += far if kind in (PERIODIC, FLUX) else 0
            sides += [] if kind in (PERIODIC, FLUX) else [d]
    return [[(e, 1)], [(e, 2), (inside, -1)], [(inside, 1)]][len(sides)]


# Or the flux K grad T at the corners of cells; through a face flows the mean of both its ends.
if by_corners:
    lows = list(itertools.product(range(n[0] + 1), range(n[1] + 1)))  # the point below each corner on both axes
    place = [[lo[d] + low[d] * width[d] for d in range(2)] for low in lows]
    K = Reference(case["oracle"], sys.argv[2] + ".corners", place, width).ask("0", "k_x,k_xy,k_y")
    ways = list(itertools.product((0, 1), (0, 1)))  # to the four points around it
    for low, (k_x, k_xy, k_y) in zip(lows, K):
        around = [sum((low[d] + way[d]) * stride[d] for d in range(2)) for way in ways]
        insulated = [d for d in range(2) if any(on_side(e, d) and wall[e][d][0] == FLUX for e in around)]
        for e, (a, b) in zip(around, ways):
            T_x, T_y = (2 * a - 1) / (2 * width[0]), (2 * b - 1) / (2 * width[1])  # share of this point
            if 0 in insulated:
                T_x = -k_xy / k_x * T_y
            if 1 in insulated:
                T_y = -k_xy / k_y * T_x
            flux_x, flux_y = k_x * T_x + k_xy * T_y, k_xy * T_x + k_y * T_y
            for c, (p, q) in zip(around, ways):
                g = (1 - 2 * p) * flux_x / (2 * width[0]) + (1 - 2 * q) * flux_y / (2 * width[1])
                if not any(on_side(c, d) for d in range(2)):
                    faces[c] += [(f, g * share) for f, share in image(e)]


def set_walls(values):
    """Sets what the sides hold from the value at each point of `beside`."""
    for e, d, c in beside:
        flux[c] = 0.0
    for (e, d, c), value in zip(beside, values):
        if wall[e][d][0] == FLUX:
            flux[c] += value / width[d]
        else:
            T[e] = value


# Data that change in time are asked for at the start of every step.
steps = math.ceil(t_end * fastest / 0.25)
dt = t_end / steps
times = f"0:{t_end}:{steps + 1}"
changing, moving = case["source"] == "changing", "walls" in case
if changing:
    sources = [values[-1] for values in reference.ask(times, "source")]
set_walls([wall[e][d][1] for e, d, c in beside])
if moving:
    frame = Reference(case["oracle"], sys.argv[2] + ".frame", [points[e] for e, d, c in beside], width)
    walls = frame.ask(times, "wall_x" + (",wall_y" if dim == 2 else ""))
heat = [heat_at(value) for value in T] if melts else []
begun = time.process_time()
for step in range(steps):
    if changing:
        source = sources[step * len(points):(step + 1) * len(points)]
    if moving:
        now = walls[step * len(beside):(step + 1) * len(beside)]
        set_walls([values[2 + 3 * d] for values, (e, d, c) in zip(now, beside)])
    P = [potential(value) for value in T] if melts else T
    rate = [source[c] + flux[c] + sum([g * (P[e] - P[c]) for e, g in faces[c]]) for c in cells]
    for c, r in zip(cells, rate):
        if melts:
            heat[c] += dt * r
            T[c] = temperature_at(heat[c])
        else:
            T[c] += dt * r / rho_c[c]
seconds = time.process_time() - begun

with open(sys.argv[2], "w") as f:
    print("# steps =", steps, "\n# seconds =", seconds, file=f)
    print(*["x", "y", "z"][:dim], "T", sep=",", file=f)
    for c in cells:
        print(*points[c], T[c], sep=",", file=f)
