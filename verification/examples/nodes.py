# SPDX-License-Identifier: GPL-3.0-or-later
"""nodes.py CASE OUT: volumes around the nodes of a grid, explicit Euler, for rods and rectangles.

The nodes divide the body into boxes; each node has the part of the box around it, half-way to its
neighbours, that is in the body.  A box of two materials has the heat capacity of both, and starts
with the heat of both: `initial_mean`. The case file gives extents and the number of boxes;
`heatladder reference` gives all else at the points asked for.
$HEATLADDER is that program.  Only the standard library is used."""

import itertools
import math
import os
import subprocess
import sys


def read_case(path):
    with open(path) as lines:
        return dict(line.rstrip("\n").split(" = ", 1) for line in lines)


def numbers(text):
    return [float(word) for word in text.split(",")]


class Body:
    def __init__(self, case, scratch):
        self.oracle = case["oracle"].split()
        self.changing = case["source"] == "changing"
        self.dim, self.t_end = int(case["dim"]), float(case["t_end"])
        self.lo, self.hi = numbers(case["lo"]), numbers(case["hi"])
        self.cells = [int(n) for n in case["cells"].split(",")]
        self.h = [(b - a) / n for a, b, n in zip(self.lo, self.hi, self.cells)]
        self.scratch = scratch

    def place(self, index):
        """Coordinates of an index, whole at nodes and half-way between."""
        return [self.hi[d] if i == self.cells[d] else self.lo[d] + i * self.h[d] for d, i in enumerate(index)]

    def ask(self, indices, what, times=None):
        """The columns of `what` at the points of these indices: a list of numbers for each point."""
        with open(self.scratch, "w") as out:
            print("x,y,dx,dy" if self.dim == 2 else "x,dx", file=out)
            for index in indices:
                print(*self.place(index), *self.h, sep=",", file=out)
        words = [os.environ.get("HEATLADDER", "heatladder"), "reference", *self.oracle]
        words += ["--points", self.scratch, "--what", what] + (["--time", times] if times else [])
        answer = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True).stdout.split("\n")[1:-1]
        return [numbers(line)[self.dim :] for line in answer]


def around(index, steps):
    """The indices beside this one, by each combination of the steps."""
    return [tuple(i + s for i, s in zip(index, step)) for step in itertools.product(steps, repeat=len(index))]


def set_up(body):
    """For each node that is free: its row in `nodes`, neighbours with their conductances, flux, capacity."""
    n, h, axes = body.cells, body.h, range(body.dim)
    nodes = list(itertools.product(*[range(n[d] + 1) for d in axes]))
    row = {index: i for i, index in enumerate(nodes)}
    names = "xy"[: body.dim]
    sides = body.ask(nodes, ",".join("wall_" + d for d in names))

    # A node's box is cut into quarters (on a rod, halves): each is of one material if interfaces
    # are on nodes.
    parts = {p: 0 for index in nodes for p in around(index, (-0.25, 0.25)) if all(0 < p[d] < n[d] for d in axes)}
    for p, (rho_c,) in zip(parts, body.ask(parts, "rho_c")):
        parts[p] = rho_c * math.prod(h) / 2**body.dim
    # Heat flows along the edges, through faces that are cut in the same way.
    edges = {}
    for d in axes:
        for index in nodes:
            if index[d] < n[d]:
                middle = tuple(i + 0.5 * (a == d) for a, i in enumerate(index))
                for p in around(middle, (-0.25, 0.25)):
                    if all(0 < p[a] < n[a] for a in axes):
                        edges[p] = d
    k = dict(zip(edges, body.ask(edges, ",".join("k_" + d for d in names))))

    volumes = []
    for index in nodes:
        wall = [sides[row[index]][3 * d : 3 * d + 3] for d in axes]
        if any(kind == 1 for kind, value, b in wall):
            continue  # a held node
        mine = [p for p in around(index, (-0.25, 0.25)) if p in parts]
        size = len(mine) * math.prod(h) / 2**body.dim
        capacity, flux, loss, links = sum(parts[p] for p in mine), 0, 0, []
        for d in axes:
            face = size / (h[d] if wall[d][0] == 0 else h[d] / 2)
            kind, value, b = wall[d]
            if kind == 2:
                flux += value * face
            if kind == 3:
                flux, loss = flux + b * value * face, loss + b * face
            for step in (-1, 1):
                other = tuple(i + step * (a == d) for a, i in enumerate(index))
                if other not in row:
                    continue
                middle = tuple(i + 0.5 * step * (a == d) for a, i in enumerate(index))
                halves = [k[p][d] for p in around(middle, (-0.25, 0.25)) if p in k]
                links.append((row[other], sum(halves) / len(halves) * face / h[d]))
        volumes.append((row[index], links, flux, loss, size, capacity))
    return nodes, sides, volumes


def solve(body):
    nodes, sides, volumes = set_up(body)
    start = body.ask(nodes, "initial_mean,source" + ",wall", "0")
    T = [value if kind == 1 else heat for heat, source, kind, value, b in start]
    source = [values[1] for values in start]
    fastest = max((sum(g for _, g in links) + loss) / capacity for _, links, _, loss, _, capacity in volumes)
    steps = math.ceil(body.t_end * fastest / 0.8)  # 1 is the limit of an explicit step
    dt = body.t_end / steps
    change = body.ask(nodes, "source", f"0:{body.t_end}:{steps + 1}") if body.changing else []
    for step in range(steps):
        if change:
            source = [value for time, value in change[step * len(nodes) : (step + 1) * len(nodes)]]
        new = [(i, T[i] + dt / capacity * (sum([g * (T[j] - T[i]) for j, g in links]) + flux - loss * T[i]
                                           + source[i] * size))
               for i, links, flux, loss, size, capacity in volumes]
        for i, value in new:
            T[i] = value
    return nodes, T, steps


def main():
    if len(sys.argv) != 3:
        sys.exit("nodes.py CASE OUT")
    case = read_case(sys.argv[1])
    others = {"shape", "walls", "k_law", "contact_resistance", "conductivity"}
    if case["dim"] == "3" or others & case.keys() or "periodic" in case.values():
        sys.exit(77)  # rods and rectangles with steady walls alone
    body = Body(case, sys.argv[2] + ".points")
    nodes, T, steps = solve(body)
    with open(sys.argv[2], "w") as out:
        print("# steps =", steps, file=out)
        print("x,y,T" if body.dim == 2 else "x,T", file=out)
        for index, value in zip(nodes, T):
            print(*body.place(index), value, sep=",", file=out)


main()
