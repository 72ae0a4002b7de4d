"""A peer for --solver: SciPy on the five-point method of lines, on the cell-centred points of a rectangle of one
material whose sides hold a temperature each.

    scipy_peer.py CASE OUT bdf|expm|dst|dstk [TOLERANCE]

bdf   solve_ivp(method='BDF') with the sparse Jacobian given, as its documentation recommends for stiff systems
expm  scipy.sparse.linalg.expm_multiply, of the operator with the walls' values as one more unknown
dst   sine transforms (dstn) diagonalise the five-point operator: no error in time
dstk  the same with the exact -kappa k^2 in place of the operator's eigenvalues: no error of differences either
Transforms use the threads that the case allows; sparse matrices know none.  The solve is timed apart from Python's
start: `# seconds` in the answer.
"""
import sys
import time

try:
    import numpy as np

    if sys.argv[3:4] in (["dst"], ["dstk"]):  # a run loads what it needs
        from scipy import fft
    else:
        from scipy import integrate, sparse
        from scipy.sparse import linalg
except ImportError as missing:
    print(f"scipy_peer: {missing}")
    sys.exit(77)


def read_case(path):
    with open(path) as lines:
        return dict(line.rstrip("\n").split(" = ", 1) for line in lines)


def numbers(text):
    return [float(word) for word in text.split(",")]


class Problem:
    def __init__(self, case):
        if case["scene"] not in ("square-step", "plate"):
            sys.exit("scipy_peer: knows square-step and plate")
        self.lo, self.hi = numbers(case["lo"]), numbers(case["hi"])
        self.dx, self.t_end = float(case["dx"]), float(case["t_end"])
        self.n = [round((h - l) / self.dx) for l, h in zip(self.lo, self.hi)]
        self.kappa = [float(case[k]) / float(case["rho_c"]) for k in ("k_x", "k_y")]
        sides = [case["side_" + s].split(", ") for s in ("x_lo", "x_hi", "y_lo", "y_hi")]
        if any(s[0] != "dirichlet" or len(s) != 2 for s in sides):
            sys.exit("scipy_peer: only sides that hold a temperature")
        self.side = [float(s[1]) for s in sides]
        self.x, self.y = (l + (np.arange(n) + 0.5) * self.dx for l, n in zip(self.lo, self.n))
        self.T0, self.threads = float(case["param_T0"]), int(case["threads"])
        if case["scene"] == "square-step":
            a, b = (float(case["param_" + k]) * (1 + 1e-12) for k in "ab")
            self.start = self.T0 * np.outer(abs(self.y) <= b, abs(self.x) <= a).astype(float)
        else:
            self.start = np.full(self.n[::-1], self.T0)

    def walls(self):
        """What the walls add to dT/dt, K/s: ghosts hold 2 wall - T."""
        g = np.zeros(self.n[::-1])
        cx, cy = (2 * k / self.dx**2 for k in self.kappa)
        g[:, 0] += cx * self.side[0]
        g[:, -1] += cx * self.side[1]
        g[0, :] += cy * self.side[2]
        g[-1, :] += cy * self.side[3]
        return g

    def matrix(self):
        def line(n, kappa):
            main = np.full(n, -2.0)
            main[[0, -1]] = -3
            return kappa / self.dx**2 * sparse.diags([np.ones(n - 1), main, np.ones(n - 1)], [-1, 0, 1])

        return sparse.kronsum(line(self.n[0], self.kappa[0]), line(self.n[1], self.kappa[1]), format="csr")


def solve_bdf(p, tolerance):
    A, g, shape = p.matrix(), p.walls().ravel(), p.start.shape
    answer = integrate.solve_ivp(lambda t, T: A @ T + g, (0, p.t_end), p.start.ravel(), method="BDF", jac=A.tocsc(),
                                 t_eval=[p.t_end], rtol=tolerance, atol=tolerance * max(1, p.T0))
    if not answer.success:
        sys.exit("scipy_peer: " + answer.message)
    return answer.y[:, -1].reshape(shape)


def solve_expm(p, _):
    A, g, T = p.matrix(), p.walls().ravel(), p.start.ravel()
    if g.any():
        A = sparse.bmat([[A, g[:, None]], [None, np.zeros((1, 1))]], format="csr")
        T = np.append(T, 1.0)
    return linalg.expm_multiply(p.t_end * A, T)[: g.size].reshape(p.start.shape)


def solve_dst(p, _, exact=False):
    modes = [np.pi * np.arange(1, n + 1) / n for n in p.n]
    rates = [k / p.dx**2 * (m**2 if exact else 4 * np.sin(m / 2) ** 2) for k, m in zip(p.kappa, modes)]
    decay = np.outer(np.exp(-p.t_end * rates[1]), np.exp(-p.t_end * rates[0]))
    how = {"type": 2, "overwrite_x": True, "workers": p.threads}
    T = fft.dstn(p.start, **how)
    T *= decay
    g = p.walls()
    if exact and g.any():
        sys.exit("scipy_peer: dstk knows walls at zero")
    if g.any():
        T += (1 - decay) / np.add.outer(rates[1], rates[0]) * fft.dstn(g, **how)
    return fft.idstn(T, **how)


METHODS = {"bdf": solve_bdf, "expm": solve_expm, "dst": solve_dst,
           "dstk": lambda p, tolerance: solve_dst(p, tolerance, exact=True)}


def main(case, out, method, tolerance="1e-6"):
    values = read_case(case)
    start = time.perf_counter()
    while True:  # a tenth of a second, then the one that counts: program and memory are ready
        begin = time.perf_counter()
        p = Problem(values)
        T = METHODS[method](p, float(tolerance))
        seconds = time.perf_counter() - begin
        if begin - start > 0.1:
            break
    X, Y = np.meshgrid(p.x, p.y)
    with open(out, "w") as answer:
        answer.write(f"# seconds = {seconds:.9g}\nx,y,T\n")
        answer.writelines(f"{x!r},{y!r},{t!r}\n" for x, y, t in zip(X.ravel().tolist(), Y.ravel().tolist(), T.ravel().tolist()))


if __name__ == "__main__":
    main(*sys.argv[1:])
