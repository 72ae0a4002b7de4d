# SPDX-License-Identifier: GPL-3.0-or-later
"""scipy_dst.py CASE OUT: SciPy's sine transform on square-step and cube-step.

The central difference with T = 0 on the sides is diagonal in sines, so that there is no error in time.
"""
import sys
import time
from functools import reduce

import numpy as np
from scipy import fft

WARM = 0.1  # s: solves before the one that is timed

with open(sys.argv[1]) as lines:
    case = dict(line.rstrip("\n").split(" = ", 1) for line in lines)
if case["scene"] not in ("square-step", "cube-step"):
    sys.exit(77)


def parameter(name):
    return float(case["param_" + name])


dim, dx, t_end = int(case["dim"]), float(case["dx"]), float(case["t_end"])
n = [int(word) for word in case["cells"].split(",")]
axes = [-parameter("L") + (np.arange(m) + 0.5) * dx for m in n]


def outer(factors):
    """The product of one factor per axis, as an array by z, y, x."""
    return reduce(np.multiply.outer, reversed(factors))


def solve():
    start = parameter("T0") * outer([1.0 * (abs(x) <= parameter(half) * (1 + 1e-12)) for x, half in zip(axes, "abc")])
    rates = [4 * parameter("kappa_" + axis) / dx**2 * np.sin(np.pi * np.arange(1, m + 1) / (2 * m)) ** 2
             for axis, m in zip("xyz", n)]
    modes = fft.dstn(start, type=2, overwrite_x=True)
    modes *= outer([np.exp(-t_end * rate) for rate in rates])
    return fft.idstn(modes, type=2, overwrite_x=True)


first = time.perf_counter()
while True:
    begin = time.perf_counter()
    T = solve()
    seconds = time.perf_counter() - begin
    if begin - first > WARM:
        break

points = np.meshgrid(*reversed(axes), indexing="ij")[::-1]
header = f"# seconds = {seconds:.9g}\n" + ",".join("xyz"[:dim]) + ",T"
table = np.stack([*points, T], axis=-1).reshape(-1, dim + 1)
np.savetxt(sys.argv[2], table, "%.17g", ",", header=header, comments="")
