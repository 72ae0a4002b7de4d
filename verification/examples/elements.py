"""elements.py CASE OUT: FEniCSx, linear elements on segments, bilinear ones on rectangles, BDF2 in time.  All that
the case does not tell, `heatladder reference` does, at the elements' nodes; $HEATLADDER is that program."""
import logging, os, subprocess, sys
import numpy as np
import ufl
from dolfinx import fem, mesh
from dolfinx.fem import petsc
from mpi4py import MPI
from petsc4py import PETSc
logging.disable()  # of what is compiled
case = dict(line.rstrip("\n").split(" = ", 1) for line in open(sys.argv[1]))
if case["source"] == "changing" or "shape" in case or "periodic" in case.values():
    sys.exit(77)
dim, t_end = int(case["dim"]), float(case["t_end"])
lo, hi = (np.array([float(v) for v in case[key].split(",")]) for key in ("lo", "hi"))
n = [int(v) for v in case["cells"].split(",")]
body = mesh.create_interval(MPI.COMM_SELF, n[0], [lo[0], hi[0]]) if dim == 1 else \
    mesh.create_rectangle(MPI.COMM_SELF, [lo, hi], n, mesh.CellType.quadrilateral)

def ask(space, points, what):  # a function of the space for each column
    rows = np.column_stack([points] + [np.full(len(points), width) for width in (hi - lo) / n])
    np.savetxt(sys.argv[2] + ".points", rows, "%.17g", ",", header="x,y,dx,dy" if dim > 1 else "x,dx", comments="")
    words = [os.environ.get("HEATLADDER", "heatladder"), "reference", *case["oracle"].split()]
    words += ["--points", sys.argv[2] + ".points", "--what", what]
    told = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True).stdout.split("\n")[1:-1]
    columns = np.array([line.split(",")[dim:] for line in told], float).T
    functions = [fem.Function(space) for _ in columns]
    for function, column in zip(functions, columns):
        function.x.array[:] = column
    return functions

V, D, cell = (fem.FunctionSpace(body, space) for space in (("Lagrange", 1), ("DG", 1), ("DG", 0)))
at, inside, centre = (space.tabulate_dof_coordinates()[:, :dim] for space in (V, D, cell))
for dofs in D.dofmap.list.array.reshape(len(centre), -1):  # each side of an interface has its own value
    inside[dofs] += 1e-9 * (inside[dofs].mean(axis=0) - inside[dofs])
(start,) = ask(cell, centre, "initial_mean")
source, rho_c, *k = ask(D, inside, "source,rho_c,k_x" + ",k_y" * (dim - 1))
kind, wall, _, *sides = ask(V, at, "wall,wall_x" + ",wall_y" * (dim - 1))
speed = sum(k[d].x.array * (n[d] / (hi[d] - lo[d])) ** 2 for d in range(dim)) / rho_c.x.array
steps = int(np.ceil(8 * t_end * speed.max()))

u, v, normal = ufl.TrialFunction(V), ufl.TestFunction(V), ufl.FacetNormal(body)
T, known, rate = fem.Function(V), fem.Function(V), fem.Constant(body, PETSc.ScalarType(0))
left = (rho_c * rate * u * v + sum(k[d] * u.dx(d) * v.dx(d) for d in range(dim))) * ufl.dx
right = (rho_c * known * v + source * v) * ufl.dx
for d in range(dim):
    of_side, value, b = sides[3 * d : 3 * d + 3]
    value.x.array[:] *= np.where(of_side.x.array == 2, 1, b.x.array)
    left, right = left + b * u * v * normal[d] ** 2 * ufl.ds, right + value * v * normal[d] ** 2 * ufl.ds
walls = [fem.dirichletbc(wall, np.flatnonzero(kind.x.array == 1).astype(np.int32))]
petsc.LinearProblem(rho_c * u * v * ufl.dx, rho_c * start * v * ufl.dx, [], T).solve()
problem = petsc.LinearProblem(left, right, walls, T, {"ksp_type": "preonly", "pc_type": "lu"})
old = T.x.array.copy()
for step in range(steps):  # the first is Euler's
    older, old, rate.value = old, T.x.array.copy(), (1 if step == 0 else 1.5) * steps / t_end
    known.x.array[:] = (old if step == 0 else 2 * old - older / 2) * steps / t_end
    problem.solve()
header = f"# steps = {steps}\n{'x,y,T' if dim > 1 else 'x,T'}"
np.savetxt(sys.argv[2], np.c_[at, T.x.array], "%.17g", ",", header=header, comments="")
