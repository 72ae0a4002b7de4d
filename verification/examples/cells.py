"""cells.py CASE OUT: finite volumes on a grid of cells, explicit Euler.  All that the case does not tell, `heatladder
reference` does, at the centres of the cells and of the faces on the sides; $HEATLADDER is that program."""
import math
import os
import subprocess
import sys
case = dict(line.rstrip("\n").split(" = ", 1) for line in open(sys.argv[1]))
dim, t_end = int(case["dim"]), float(case["t_end"])
lo, hi = ([float(v) for v in case[key].split(",")] for key in ("lo", "hi"))
n = [int(v) for v in case["cells"].split(",")]
h = [(hi[d] - lo[d]) / n[d] for d in range(dim)]
# Cells 1 to n along each axis, framed by the faces on the sides; a rod is one row, without a frame in y.
axes = [[lo[d]] + [lo[d] + (i + 0.5) * h[d] for i in range(n[d])] + [hi[d]] for d in range(dim)]
points = [(x,) for x in axes[0]] if dim == 1 else [(x, y) for y in axes[1] for x in axes[0]]
nx = n[0] + 2
inside = [c for c, at in enumerate(points) if all(lo[d] < at[d] < hi[d] for d in range(dim))]
with open(sys.argv[2] + ".points", "w") as f:
    print(*("xy"[:dim]), *("dx", "dy")[:dim], sep=",", file=f)
    for at in points:
        print(*at, *h, sep=",", file=f)
def ask(time, what):  # a row of answers for each point
    words = [os.environ.get("HEATLADDER", "heatladder"), "reference", *case["oracle"].split()]
    words += ["--points", f.name, "--time", time, "--what", what]
    told = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True).stdout.split("\n")[1:-1]
    return [[float(v) for v in line.split(",")[dim:]] for line in told]
told = ask("0", "initial_heat,source,rho_c,k_x,wall_x" + (",k_y,wall_y" if dim == 2 else ""))
# Conductances of the faces, over the cell's width: half cells in series, and at a side Robin's coefficient.
T = [p[0] for p in told]
source = [p[1] for p in told]
cells, fastest = [], 0
for c in inside:
    rho_c, flux, faces = told[c][2], 0, []
    for d in range(dim):
        k = told[c][3 + 4 * d]
        for e in (c - (1, nx)[d], c + (1, nx)[d]):
            k_e, kind, value, b = told[e][3 + 4 * d : 7 + 4 * d]
            side = not lo[d] < points[e][d] < hi[d]
            T[e] = value if side else T[e]
            if side and kind == 2:
                flux += value / h[d]
            else:
                beyond = h[d] / (2 * k_e) if not side else 1 / b if kind == 3 else 0
                faces.append((e, 1 / (h[d] / (2 * k) + beyond) / h[d] / rho_c))
    cells.append((c, flux, rho_c, faces))
    fastest = max(fastest, sum(told[c][3 + 4 * d] / (h[d] ** 2 * rho_c) for d in range(dim)))
steps = math.ceil(t_end * fastest / 0.25)
dt = t_end / steps
change = ask(f"0:{t_end}:{steps + 1}", "source") if case["source"] == "changing" else []
for step in range(steps):
    source = [value for time, value in change[step * len(points) : (step + 1) * len(points)]] or source
    new = [T[c] + dt * ((source[c] + flux) / rho_c + sum([g * (T[e] - T[c]) for e, g in faces]))
           for c, flux, rho_c, faces in cells]
    for c, value in zip(inside, new):
        T[c] = value
with open(sys.argv[2], "w") as f:
    print("# steps =", steps, file=f)
    print(*("xy"[:dim]), "T", sep=",", file=f)
    for c in inside:
        print(*points[c], T[c], sep=",", file=f)
