"""particles.py CASE OUT: PySPH, Brookshaw's Laplacian on a lattice of particles with mirrored ghosts, Euler.  All
that the case does not tell, `heatladder reference` does, at particles and at sides; $HEATLADDER is that program."""
import os, subprocess, sys, numpy as np
from pysph.base.kernels import CubicSpline
from pysph.base.nnps import LinkedListNNPS
from pysph.base.utils import get_particle_array
from pysph.sph.acceleration_eval import AccelerationEval
from pysph.sph.equation import Equation, Group
from pysph.sph.sph_compiler import SPHCompiler
class Conduction(Equation):  # Espanol and Revenga 2003 (anisotropic); Cleary and Monaghan 1999 (two materials)
    def initialize(self, d_idx, d_aT):
        d_aT[d_idx] = 0.0
    def loop(self, d_idx, s_idx, d_aT, d_T, s_T, d_kx, s_kx, d_ky, s_ky, d_V, d_dim, XIJ, DWIJ, R2IJ, HIJ):
        kx = 2.0 * d_kx[d_idx] * s_kx[s_idx] / (d_kx[d_idx] + s_kx[s_idx])
        ky = 2.0 * d_ky[d_idx] * s_ky[s_idx] / (d_ky[d_idx] + s_ky[s_idx] + 1e-300)
        k = (d_dim[d_idx] + 2.0) * (kx * XIJ[0] * XIJ[0] + ky * XIJ[1] * XIJ[1]) / (R2IJ + 1e-300) - kx - ky
        F = (XIJ[0] * DWIJ[0] + XIJ[1] * DWIJ[1]) / (R2IJ + 1e-300)
        d_aT[d_idx] += d_V[d_idx] * k * F * (d_T[d_idx] - s_T[s_idx])
case = dict(line.rstrip("\n").split(" = ", 1) for line in open(sys.argv[1]))
if case["source"] == "changing" or "dy" in case or "shape" in case or "periodic" in case.values(): sys.exit(77)
dim, t_end, layers = int(case["dim"]), float(case["t_end"]), 3  # of ghosts: h is 1.2 spacings
lo, hi = ([float(v) for v in case[key].split(",")] for key in ("lo", "hi"))
n = [int(v) for v in case["cells"].split(",")]
h = [(hi[d] - lo[d]) / n[d] for d in range(dim)]
# Told at the centres of the cells and of the faces on the sides; a ghost takes what its side is told.
axes = [np.r_[lo[d], lo[d] + (np.arange(n[d]) + 0.5) * h[d], hi[d]] for d in range(dim)]
framed = np.meshgrid(*axes, indexing="ij")
rows = np.column_stack([x.ravel() for x in framed] + [np.full(framed[0].size, width) for width in h])
np.savetxt(sys.argv[2] + ".points", rows, "%.17g", ",", header="x,y,dx,dy" if dim > 1 else "x,dx", comments="")
words = [os.environ.get("HEATLADDER", "heatladder"), "reference", *case["oracle"].split(), "--points"]
words += [sys.argv[2] + ".points", "--what", "initial_heat,source,rho_c,k_x,wall_x" + ",k_y,wall_y" * (dim - 1)]
told = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True).stdout.split("\n")[1:-1]
told = np.array([line.split(",")[dim:] for line in told], float).T.reshape(-1, *framed[0].shape)
index = [np.arange(-layers, n[d] + layers) for d in range(dim)]
told = told[np.ix_(np.arange(len(told)), *[np.clip(index[d] + 1, 0, n[d] + 1) for d in range(dim)])]
(T, source, rho_c), ghosts = told[:3], []  # T = a + s T of the mirror image, by layers away from the sides
for d in range(dim):
    ghost, low = (index[d] < 0) | (index[d] >= n[d]), index[d] < 0
    image = layers + np.where(low, -1 - index[d], 2 * n[d] - 1 - index[d])[ghost]
    k, kind, value, b = (np.moveaxis(column, d, 0)[ghost] for column in told[3 + 4 * d : 7 + 4 * d])
    g = (k.T / (h[d] * abs(np.where(low, 2 * index[d] + 1, 2 * (index[d] - n[d]) + 1)[ghost]))).T
    a = np.choose(kind.astype(int), [0 * g, 2 * value, value / g, b * value / (g + b / 2)])
    ghosts.append((d, ghost, image, a, np.choose(kind.astype(int), [1, -1, 1, (g - b / 2) / (g + b / 2)])))
x = [grid.ravel() for grid in np.meshgrid(*[lo[d] + (index[d] + 0.5) * h[d] for d in range(dim)], indexing="ij")]
body = get_particle_array(
    name="body", x=x[0], y=x[-1] * (dim - 1), h=1.2 * np.prod(h) ** (1 / dim), m=1.0, rho=1.0, V=np.prod(h),
    dim=float(dim), kx=told[3].ravel(), ky=told[-4].ravel() * (dim - 1), T=T.ravel(), aT=0.0)
evaluation = AccelerationEval([body], [Group([Conduction("body", ["body"])])], CubicSpline(dim=dim))
SPHCompiler(evaluation, None).compile()
evaluation.set_nnps(LinkedListNNPS(dim, [body], radius_scale=2, fixed_h=True, cache=True))
steps = int(np.ceil(t_end / 0.25 * (sum(told[3 + 4 * d] / h[d] ** 2 for d in range(dim)) / rho_c).max()))
for step in range(steps):
    for d, ghost, image, a, s in ghosts:
        np.moveaxis(T, d, 0)[ghost] = a + s * np.moveaxis(T, d, 0)[image]
    body.T[:] = T.ravel()
    evaluation.compute(0.0, t_end / steps)
    T = T + t_end / steps * (source + body.aT.reshape(T.shape)) / rho_c
inside = [column.reshape(T.shape)[(slice(layers, -layers),) * dim].ravel() for column in x + [T]]
np.savetxt(sys.argv[2], np.column_stack(inside), "%.17g", ",", header="x,y,T" if dim > 1 else "x,T", comments="")
