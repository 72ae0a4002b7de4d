import os, shlex, subprocess, sys

case = dict(line.strip().split(" = ") for line in open(sys.argv[1]) if " = " in line)
if case["dim"] != "1" or case["materials"] != "1" or "k_law" in case or {"changing", "periodic"} & {*case.values()}:
    sys.exit(77)                                                # not in this code: the row is skipped
lo, hi, n, t_end = float(case["lo"]), float(case["hi"]), int(case["cells"]), float(case["t_end"])
dx = (hi - lo) / n
x = [lo] + [lo + (i + 0.5) * dx for i in range(n)] + [hi]       # a wall, centres of cells, a wall
question = [os.environ["HEATLADDER"], "reference", *shlex.split(case["oracle"]), "--points", "-", "--time", "0",
            "--what", "initial_mean,source,rho_c,k_x,wall_x"]
table = subprocess.run(question, input="x,dx\n" + "".join(f"{p},{dx}\n" for p in x), capture_output=True, text=True)
rows = [[float(word) for word in line.split(",")[1:]] for line in table.stdout.split()[1:]]
T, G, rho_c, k, kind, value, b = zip(*rows)

T, G, C = [*T], [g * dx for g in G], [k[1] / dx] * (n + 1)      # C: conductance of each face, W/(m^2 K)
for wall, cell in (0, 1), (-1, -2):
    if kind[wall] == 2: G[cell] += value[wall]; C[wall] = 0     # Neumann: heat flux into the body
    else: T[wall] = value[wall]; C[wall] = 1 / (dx / 2 / k[wall] + (1 / b[wall] if kind[wall] == 3 else 0))
steps = int(6 * t_end * k[1] / (rho_c[1] * dx * dx)) + 1
for _ in range(steps):
    q = [C[i] * (T[i] - T[i + 1]) for i in range(n + 1)]        # heat flux at each face, W/m^2
    for i in range(1, n + 1): T[i] += t_end / steps / (rho_c[i] * dx) * (q[i - 1] - q[i] + G[i])
open(sys.argv[2], "w").write("x,T\n" + "".join(f"{p},{t}\n" for p, t in zip(x[1:-1], T[1:-1])))
