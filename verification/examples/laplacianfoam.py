# SPDX-License-Identifier: GPL-3.0-or-later
"""laplacianfoam.py CASE OUT: OpenFOAM's laplacianFoam, finite volumes, BDF2 in time.

    dT/dt = DT laplacian T

It knows one material and no source.  Where conductivities differ, y is stretched by sqrt(k_x /
k_y), which makes them one; its unit of time is a step.  The case file gives the grid and the end
time.  `heatladder reference` gives all else (start, coefficients, walls) at the centres of the
cells and of the faces on the sides.  $HEATLADDER is the path of that program.
"""
import math
import os
import subprocess
import sys

HELD, FLUX, COOLED = 1, 2, 3  # kinds of walls in the answers of `reference`

with open(sys.argv[1]) as f:
    case = dict(line.rstrip("\n").split(" = ", 1) for line in f)
if case["dim"] == "3" or case["materials"] != "1" or case["source"] != "no":
    sys.exit(77)
if {"shape", "walls", "k_law", "contact_resistance", "conductivity"} & case.keys() or "periodic" in case.values():
    sys.exit(77)


def numbers(text):
    return [float(word) for word in text.split(",")]


lo, hi, t_end = numbers(case["lo"]), numbers(case["hi"]), float(case["t_end"])
n = [int(word) for word in case["cells"].split(",")]
dim = len(n)
h = [(hi[d] - lo[d]) / n[d] for d in range(dim)]
if dim == 1:  # one row of cells, whose other sides are left out
    lo, hi, n, h = lo + [0.0], hi + h, n + [1], h + h

# The cells, x fastest; then the faces on each side.
x, y = ([lo[d] + (i + 0.5) * h[d] for i in range(n[d])] for d in range(2))
cells = [(at, row) for row in y for at in x]
faces = {"x_lo": [(lo[0], row) for row in y], "x_hi": [(hi[0], row) for row in y]}
if dim == 2:
    faces |= {"y_lo": [(at, lo[1]) for at in x], "y_hi": [(at, hi[1]) for at in x]}

folder = os.path.abspath(sys.argv[2] + ".foam")
for name in "0", "system", "constant":
    os.makedirs(os.path.join(folder, name), exist_ok=True)


def write(name, kind, *lines):
    with open(os.path.join(folder, name), "w") as out:
        print("FoamFile { version 2.0; format ascii; class", kind + "; object any; }", file=out)
        print(*lines, sep="\n", file=out)


file = os.path.join(folder, "points")
with open(file, "w") as out:
    print("x,y,dx,dy", file=out)
    for point in cells + sum(faces.values(), []):
        print(*point, *h, sep=",", file=out)
program = os.environ.get("HEATLADDER", "heatladder")
words = [program, "reference", *case["oracle"].split(), "--points", file, "--what", "initial_mean,rho_c,k_x,wall_x" + (",k_y,wall_y" if dim == 2 else "")]
run = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True)
answer = run.stdout.splitlines()
scene = [numbers(line)[dim:] for line in answer[1:]]
start = [values[0] for values in scene[:len(cells)]]
rho_c, k = scene[0][1], scene[0][2::4]
stretch = math.sqrt(k[0] / k[1]) if dim == 2 else 1.0

steps = int(8 * t_end * sum(k[d] / h[d] ** 2 for d in range(dim)) / rho_c) + 1


def scalars(values):
    return f"nonuniform List<scalar> {len(values)} ({' '.join(map(repr, values))});"


def patch(side, walls):
    """A mixed condition: the fraction f of a value at the face, 1 - f of a normal slope."""
    d = "xy".index(side[0])
    values, slopes, fractions = [], [], []
    for kind, value, b in walls:
        values.append(value)
        slopes.append(value / k[d] / (stretch if d == 1 else 1) if kind == FLUX else 0.0)
        fractions.append(b / (b + 2 * k[d] / h[d]) if kind == COOLED else float(kind == HELD))
    return (f"{side} {{ type mixed; refValue {scalars(values)} refGradient {scalars(slopes)} "
            f"valueFraction {scalars(fractions)} }}")


patches = []
first = len(cells)
for side, points in faces.items():
    column = 3 + 4 * "xy".index(side[0])
    patches.append(patch(side, [values[column:column + 3] for values in scene[first:first + len(points)]]))
    first += len(points)
write("0/T", "volScalarField", "dimensions [0 0 0 1 0 0 0];", "internalField " + scalars(start),
      "boundaryField { defaultFaces { type empty; }", *patches, "}")

corners = [(lo[0], lo[1]), (hi[0], lo[1]), (hi[0], hi[1]), (lo[0], hi[1])]
corner_of = {"x_lo": "0 4 7 3", "x_hi": "2 6 5 1", "y_lo": "1 5 4 0", "y_hi": "3 7 6 2"}
write("system/blockMeshDict", "dictionary",
      "vertices (", *[f"({at!r} {row * stretch!r} {z})" for z in (0, 1) for at, row in corners], ");",
      f"edges (); blocks (hex (0 1 2 3 4 5 6 7) ({n[0]} {n[1]} 1) simpleGrading (1 1 1));",
      "boundary (", *[f"{side} {{ type patch; faces (({corner_of[side]})); }}" for side in faces], ");")
write("constant/transportProperties", "dictionary", f"DT DT [0 2 -1 0 0 0 0] {k[0] / rho_c * t_end / steps!r};")
write("system/controlDict", "dictionary", "startFrom startTime; startTime 0; stopAt endTime; deltaT 1;",
      f"endTime {steps}; writeControl timeStep; writeInterval {steps}; writeFormat ascii; writePrecision 17;")
write("system/fvSchemes", "dictionary", "ddtSchemes { default backward; } divSchemes { }",
      "laplacianSchemes { default Gauss linear corrected; } gradSchemes { default Gauss linear; }",
      "snGradSchemes { default corrected; }")
write("system/fvSolution", "dictionary",
      "solvers { T { solver PCG; preconditioner DIC; tolerance 1e-13; relTol 0; } } SIMPLE { }")

environment = {"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ}
for program in "blockMesh", "laplacianFoam":
    with open(os.path.join(folder, "log"), "w") as log:
        if subprocess.run([program], cwd=folder, env=environment, stdout=log, stderr=log).returncode:
            sys.exit(f"laplacianfoam.py: {program} failed, see {log.name}")

with open(os.path.join(folder, str(steps), "T")) as f:
    text = f.read()
T = text[text.index("internalField"):].split("(", 1)[1].split(")", 1)[0].split()
with open(os.path.join(folder, "log")) as f:  # the first step also reads the mesh
    times = [float(line.split()[2]) for line in f if line.startswith("ExecutionTime")]
with open(sys.argv[2], "w") as out:
    print("# seconds =", times[-1] - times[0], file=out)
    print("x,T" if dim == 1 else "x,y,T", file=out)
    for point, value in zip(cells, T):
        print(*point[:dim], value, sep=",", file=out)
