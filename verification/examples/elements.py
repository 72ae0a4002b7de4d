# SPDX-License-Identifier: GPL-3.0-or-later
"""elements.py CASE OUT: FEniCSx, linear elements on segments and triangles, bilinear ones on
rectangles, BDF2 in time.

    (rho_c dT/dt, v) + (k grad T, grad v) + <b T, v> = (source, v) + <flux or b T_air, v>,   T given on held walls

with ( ) over the body and < > over its walls.  The case file gives the grid and the end time.
`heatladder reference` gives all else (start, source, coefficients, walls) at the elements' nodes.
$HEATLADDER is the path of that program. Round bodies have the triangles of triangles.py.
"""
import logging
import os
import subprocess
import sys
import time

import numpy as np
import ufl
from dolfinx import fem, mesh
from dolfinx.fem import petsc
from mpi4py import MPI
from petsc4py import PETSc

HELD, FLUX = 1, 2  # kinds of walls in the answers of `reference`; 3 is a cooled one
DIRECT = {"ksp_type": "preonly", "pc_type": "lu"}

logging.disable()  # of what FEniCSx compiles
with open(sys.argv[1]) as f:
    case = dict(line.rstrip("\n").split(" = ", 1) for line in f)
if case["dim"] == "3" or "changing" in case.values() or "periodic" in case.values() \
        or {"k_law", "contact_resistance", "conductivity"} & case.keys():
    sys.exit(77)  # rods and plane bodies with walls, data that stay, and T without a jump
is_round = "shape" in case


def numbers(key):
    return np.array([float(word) for word in case[key].split(",")])


lo, hi, n, t_end = numbers("lo"), numbers("hi"), numbers("cells").astype(int), float(case["t_end"])
dim, width = len(n), (hi - lo) / n
if is_round:
    from triangles import make_mesh

    outer = float(case.get("r2", case.get("radius", 1)))
    points, triangles = make_mesh(float(case.get("r1", 0)), outer, width[0])
    straight = ufl.Mesh(ufl.VectorElement("Lagrange", "triangle", 1))
    body = mesh.create_mesh(MPI.COMM_SELF, triangles, points, straight)
elif dim == 1:
    body = mesh.create_interval(MPI.COMM_SELF, n[0], [lo[0], hi[0]])
else:
    body = mesh.create_rectangle(MPI.COMM_SELF, [lo, hi], n, mesh.CellType.quadrilateral)
nodes = fem.FunctionSpace(body, ("Lagrange", 1))
# Each element has nodes of its own, so that coefficients may jump.
apart = fem.FunctionSpace(body, ("DG", 1))
element = fem.FunctionSpace(body, ("DG", 0))


def places(space):
    return space.tabulate_dof_coordinates()[:, :dim]


def ask(space, points, what):
    """The named columns at time 0, each as a function of the space with nodes at these points."""
    file = sys.argv[2] + ".points"
    np.savetxt(file, np.hstack([points, np.tile(width, (len(points), 1))]), "%.17g", ",", comments="",
               header=",".join(["x", "y"][:dim] + ["dx", "dy"][:dim]))
    program = os.environ.get("HEATLADDER", "heatladder")
    words = [program, "reference", *case["oracle"].split(), "--points", file, "--what", what]
    run = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True)
    answer = run.stdout.splitlines()
    functions = []
    for column in np.array([[float(x) for x in line.split(",")] for line in answer[1:]])[:, dim:].T:
        functions.append(fem.Function(space))
        functions[-1].x.array[:] = column
    return functions


# A little inside of its element a node is on that element's side of an interface.
inner = places(apart)
for dofs in apart.dofmap.list.array.reshape(element.dofmap.index_map.size_local, -1):
    inner[dofs] += 1e-9 * (inner[dofs].mean(axis=0) - inner[dofs])
begin = nodes if is_round else element  # where data jump, means over elements keep the heat
(start,) = ask(begin, places(begin), "initial" if is_round else "initial_mean")
source, rho_c, *k = ask(apart, inner, "source,rho_c,k_x" + (",k_y" if dim == 2 else ""))
sides = "" if is_round else ",wall_x" if dim == 1 else ",wall_x,wall_y"
kind, held, own, *sides = ask(nodes, places(nodes), "wall" + sides)

T, known = fem.Function(nodes), fem.Function(nodes)  # the unknown; earlier times in dT/dt
rate = fem.Constant(body, PETSc.ScalarType(0))  # 1/s: the coefficient of T in dT/dt
u, v, normal = ufl.TrialFunction(nodes), ufl.TestFunction(nodes), ufl.FacetNormal(body)
left = (rho_c * rate * u * v + sum(k[d] * u.dx(d) * v.dx(d) for d in range(dim))) * ufl.dx
right = (rho_c * known * v + source * v) * ufl.dx
across = [normal[d] ** 2 for d in range(dim)]  # 1 on the sides across axis d, else 0
if is_round:
    sides, across = [kind, held, own], [1]
for d in range(len(across)):
    side, value, b = sides[3 * d:3 * d + 3]
    entering = fem.Function(nodes)  # W/m^2, apart from what the wall's own temperature takes
    entering.x.array[:] = np.where(side.x.array == FLUX, value.x.array, b.x.array * value.x.array)
    left += b * u * v * across[d] * ufl.ds
    right += entering * v * across[d] * ufl.ds
walls = [fem.dirichletbc(held, np.flatnonzero(kind.x.array == HELD).astype(np.int32))]

# The start has the heat of `start`: a projection.
petsc.LinearProblem(rho_c * u * v * ufl.dx, rho_c * start * v * ufl.dx, [], T).solve()
fastest = (sum(k[d].x.array / width[d] ** 2 for d in range(dim)) / rho_c.x.array).max()
steps = int(np.ceil(8 * t_end * fastest))
dt = t_end / steps
problem = petsc.LinearProblem(left, right, walls, T, DIRECT)
old = T.x.array.copy()
began = time.perf_counter()
for step in range(steps):
    older, old = old, T.x.array.copy()
    if step == 0:  # Euler's: dT/dt = (T - old) / dt
        rate.value, known.x.array[:] = 1 / dt, old / dt
    else:  # dT/dt = (1.5 T - 2 old + 0.5 older) / dt
        rate.value, known.x.array[:] = 1.5 / dt, (2 * old - older / 2) / dt
    problem.solve()
seconds = time.perf_counter() - began

np.savetxt(sys.argv[2], np.column_stack([places(nodes), T.x.array]), "%.17g", ",", comments="",
           header=f"# steps = {steps}\n# seconds = {seconds}\n" + ",".join(["x", "y"][:dim] + ["T"]))
