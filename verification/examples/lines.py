"""lines.py CASE OUT: SciPy, finite volumes on a grid of cells, solve_ivp's BDF in time.  All that the case does not
tell, `heatladder reference` does, at the centres of cells and of faces on the sides; $HEATLADDER is that program."""
import os
import subprocess
import sys

import numpy as np
from scipy import sparse
from scipy.integrate import solve_ivp

case = dict(line.rstrip("\n").split(" = ", 1) for line in open(sys.argv[1]))
if case["source"] == "changing" or "shape" in case or "periodic" in case.values():
    sys.exit(77)  # the integrator takes times of its own; boxes with walls alone
dim, t_end = int(case["dim"]), float(case["t_end"])
lo, hi = ([float(v) for v in case[key].split(",")] for key in ("lo", "hi"))
n = [int(v) for v in case["cells"].split(",")]
h = [(hi[d] - lo[d]) / n[d] for d in range(dim)]

# Cells 1 to n along each axis, framed by the faces on the sides.
axes = [np.r_[lo[d], lo[d] + (np.arange(n[d]) + 0.5) * h[d], hi[d]] for d in range(dim)]
grid = np.meshgrid(*axes, indexing="ij")
rows = np.column_stack([x.ravel() for x in grid] + [np.full(grid[0].size, width) for width in h])
np.savetxt(sys.argv[2] + ".points", rows, "%.17g", ",", header="x,y,dx,dy" if dim > 1 else "x,dx", comments="")
words = [os.environ.get("HEATLADDER", "heatladder"), "reference", *case["oracle"].split(), "--points"]
words += [sys.argv[2] + ".points", "--what", "initial_heat,source,rho_c,k_x,wall_x" + ",k_y,wall_y" * (dim - 1)]
told = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True).stdout.split("\n")[1:-1]
told = np.array([line.split(",")[dim:] for line in told], float).T.reshape(-1, *grid[0].shape)
inside = (slice(1, -1),) * dim
start, source, rho_c = (column[inside] for column in told[:3])

# Conductances of the faces, over the cell's width: half cells in series, and at a side Robin's coefficient.
A = sparse.csr_matrix((start.size, start.size))
for d in range(dim):
    k, kind, value, b = told[3 + 4 * d : 7 + 4 * d][(slice(None),) + inside[:d] + (slice(None),) + inside[d + 1 :]]
    with np.errstate(divide="ignore"):
        half = np.choose(kind.astype(int), [h[d] / 2 / k, 0 * k, np.inf + 0 * k, 1 / b])
    lower, upper = (np.moveaxis(half, d, 0)[s] for s in (slice(None, -1), slice(1, None)))
    g = sparse.diags(np.moveaxis(1 / (lower + upper) / h[d], 0, d).ravel())
    slope = sparse.diags([1, -1], [0, -1], (n[d] + 1, n[d]))
    slope = sparse.kron(sparse.kron(sparse.eye(int(np.prod(n[:d]))), slope), sparse.eye(int(np.prod(n[d + 1 :]))))
    A = A - slope.T @ g @ slope
    flux = np.moveaxis(np.where(kind == 2, value / h[d], 0), d, 0)
    source = source + np.moveaxis(flux[:-2] + flux[2:], 0, d)
    source = source + (slope.T @ g @ np.diff(np.where(kind == 2, 0, -value), axis=d).ravel()).reshape(n)
A, constant = sparse.csc_matrix(sparse.diags(1 / rho_c.ravel()) @ A), (source / rho_c).ravel()
T = solve_ivp(lambda t, T: A @ T + constant, (0, t_end), start.ravel(), "BDF", jac=A, rtol=1e-8, atol=1e-10).y[:, -1]
rows = [x[inside].ravel() for x in grid] + [T]
np.savetxt(sys.argv[2], np.column_stack(rows), "%.17g", ",", header="x,y,T" if dim > 1 else "x,T", comments="")
