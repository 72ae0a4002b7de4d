# SPDX-License-Identifier: GPL-3.0-or-later
"""particles.py CASE OUT: PySPH, a pair operator on a lattice of particles with ghosts, explicit
Euler.

    rho_c dT_i/dt = source + sum over neighbours j of V k_ij F_ij (T_i - T_j),   F_ij = r_ij . grad W_ij / r_ij^2

with k_ij of Espanol and Revenga 2003 where conductivities differ by axis, and the harmonic
mean of Cleary and Monaghan 1999 where materials do.  The case file gives the grid and the end time.
`heatladder reference` gives all else (start, source, coefficients, walls) at particles and at the
feet of the sides.  $HEATLADDER is the path of that program.
"""
import os
import subprocess
import sys
import time

import numpy as np
from pysph.base.kernels import CubicSpline
from pysph.base.nnps import LinkedListNNPS
from pysph.base.utils import get_particle_array
from pysph.sph.acceleration_eval import AccelerationEval
from pysph.sph.equation import Equation, Group
from pysph.sph.sph_compiler import SPHCompiler

HELD, FLUX, COOLED = 1, 2, 3  # kinds of walls in the answers of `reference`
LAYERS = 3  # of ghosts: the kernel reaches 2 h, and h is 1.2 spacings


class Conduction(Equation):
    """PySPH compiles both functions: d_ is the particle itself, s_ its neighbour."""

    def initialize(self, d_idx, d_rate):
        d_rate[d_idx] = 0.0

    def loop(self, d_idx, s_idx, d_rate, d_T, s_T, d_kx, s_kx, d_ky, s_ky, d_kz, s_kz, d_V, d_dim,
             XIJ, DWIJ, R2IJ):
        kx = 2.0 * d_kx[d_idx] * s_kx[s_idx] / (d_kx[d_idx] + s_kx[s_idx])
        ky = 2.0 * d_ky[d_idx] * s_ky[s_idx] / (d_ky[d_idx] + s_ky[s_idx] + 1e-300)
        kz = 2.0 * d_kz[d_idx] * s_kz[s_idx] / (d_kz[d_idx] + s_kz[s_idx] + 1e-300)
        along = (kx * XIJ[0] * XIJ[0] + ky * XIJ[1] * XIJ[1] + kz * XIJ[2] * XIJ[2]) / (R2IJ + 1e-300)
        k = (d_dim[d_idx] + 2.0) * along - kx - ky - kz
        F = (XIJ[0] * DWIJ[0] + XIJ[1] * DWIJ[1] + XIJ[2] * DWIJ[2]) / (R2IJ + 1e-300)
        d_rate[d_idx] += d_V[d_idx] * k * F * (d_T[d_idx] - s_T[s_idx])


with open(sys.argv[1]) as f:
    case = dict(line.rstrip("\n").split(" = ", 1) for line in f)
if "changing" in case.values() or {"dy", "shape", "k_law", "k_xy", "contact_resistance", "conductivity"} & case.keys():
    sys.exit(77)  # square cells in rods, rectangles and boxes, and data that stay


def numbers(key):
    return np.array([float(word) for word in case[key].split(",")])


lo, hi, n, t_end = numbers("lo"), numbers("hi"), numbers("cells").astype(int), float(case["t_end"])
dim, width = len(n), (hi - lo) / n

# The points to ask for: the centres of the cells, in a frame of those of the faces on the sides.
axes = [np.clip(lo[d] + (np.arange(n[d] + 2) - 0.5) * width[d], lo[d], hi[d]) for d in range(dim)]
points = np.stack([x.ravel() for x in np.meshgrid(*axes, indexing="ij")], axis=1)
file = sys.argv[2] + ".points"
np.savetxt(file, np.hstack([points, np.tile(width, (len(points), 1))]), "%.17g", ",", comments="",
           header=",".join(["x", "y", "z"][:dim] + ["dx", "dy", "dz"][:dim]))

# Particles, including `LAYERS` layers of ghosts beyond each side.  A ghost has the columns of the
# cell at its foot point.
index = [np.arange(-LAYERS, n[d] + LAYERS) for d in range(dim)]
foot = np.ix_(*[np.clip(index[d] + 1, 0, n[d] + 1) for d in range(dim)])
inside = (slice(LAYERS, -LAYERS),) * dim


def ask(what):
    """The named columns at time 0, each as an array over the particles."""
    program = os.environ.get("HEATLADDER", "heatladder")
    words = [program, "reference", *case["oracle"].split(), "--points", file, "--what", what]
    run = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True)
    answer = run.stdout.splitlines()
    columns = np.array([[float(x) for x in line.split(",")] for line in answer[1:]])[:, dim:].T
    return [column.reshape(n + 2)[foot] for column in columns]


def mirrors(d, k, kind, value, b):
    """The ghosts along axis d: which they are, their mirror images, and a, s of T = a + s T(image).

    The wall is half-way: held, T_wall = (T + T(image)) / 2; else k (T - T(image)) / r = flux or b
    (T_air - T_wall). Where opposite sides meet, the image is the particle a period away.
    """
    low, high = index[d] < 0, index[d] >= n[d]
    ghost = low | high
    if case[f"side_{'xyz'[d]}_lo"] == "periodic":
        return d, ghost, LAYERS + index[d][ghost] % n[d], 0, 1
    image = np.where(low, -1 - index[d], 2 * n[d] - 1 - index[d])[ghost]
    apart = width[d] * abs(index[d][ghost] - image)  # from a ghost to its image
    k, kind, value, b = (np.moveaxis(column, d, 0)[ghost] for column in (k, kind, value, b))
    g = k / apart.reshape(-1, *[1] * (dim - 1))
    a = np.select([kind == HELD, kind == FLUX, kind == COOLED],
                  [2 * value, value / g, b * value / (g + b / 2)])
    s = np.select([kind == HELD, kind == COOLED], [-1, (g - b / 2) / (g + b / 2)], 1)
    return d, ghost, LAYERS + image, a, s


T, source, rho_c = ask("initial_mean,source,rho_c")
k, ghosts = [], []
for d in range(dim):
    k_d, kind, value, b = ask(f"k_{'xyz'[d]},wall_{'xyz'[d]}")
    k.append(k_d)
    ghosts.append(mirrors(d, k_d, kind, value, b))

centres = [lo[d] + (index[d] + 0.5) * width[d] for d in range(dim)]
x = [grid.ravel() for grid in np.meshgrid(*centres, indexing="ij")]
none = [np.zeros(T.size)] * (3 - dim)
(px, py, pz), (kx, ky, kz) = x + none, [k_d.ravel() for k_d in k] + none
body = get_particle_array(
    name="body", x=px, y=py, z=pz, h=1.2 * np.prod(width) ** (1 / dim), m=1.0, rho=1.0,
    V=np.prod(width), dim=float(dim), kx=kx, ky=ky, kz=kz, T=T.ravel(), rate=0.0)
evaluation = AccelerationEval([body], [Group([Conduction("body", ["body"])])], CubicSpline(dim=dim))
SPHCompiler(evaluation, None).compile()
evaluation.set_nnps(LinkedListNNPS(dim, [body], radius_scale=2, fixed_h=True, cache=True))

fastest = (sum(k[d] / width[d] ** 2 for d in range(dim)) / rho_c).max()
steps = int(np.ceil(t_end * fastest / 0.25))
begin = time.perf_counter()
for step in range(steps):
    for d, ghost, image, a, s in ghosts:
        np.moveaxis(T, d, 0)[ghost] = a + s * np.moveaxis(T, d, 0)[image]
    body.T[:] = T.ravel()
    evaluation.compute(0.0, t_end / steps)
    T = T + t_end / steps * (source + body.rate.reshape(T.shape)) / rho_c

seconds = time.perf_counter() - begin

answer = [column.reshape(T.shape)[inside].ravel() for column in x + [T]]
header = f"# seconds = {seconds:.9g}\n" + ",".join(["x", "y", "z"][:dim] + ["T"])
np.savetxt(sys.argv[2], np.column_stack(answer), "%.17g", ",", header=header, comments="")
