"""A peer for --solver: PySPH, Brookshaw's Laplacian with the harmonic mean, on particles at the centres of the cells of
a rectangle whose sides hold a temperature each (two and a half h of fixed particles beyond them).

    pysph_peer.py CASE OUT cubic|quintic FOURIER

PySPH generates and compiles its loops for the first run of a kind, which is start-up here.  The solve is timed apart:
`# seconds`, with `# updates`, in the answer.  Particles do not move and h is one, so neighbours are found once.  Where
the case allows threads, loops are generated with OpenMP, which takes their number from OMP_NUM_THREADS.
"""
import sys
import time

try:
    import numpy as np
    from compyle.config import get_config
    from pysph.base.kernels import CubicSpline, QuinticSpline
    from pysph.base.nnps import LinkedListNNPS
    from pysph.base.utils import get_particle_array
    from pysph.sph.acceleration_eval import AccelerationEval
    from pysph.sph.equation import Equation, Group
    from pysph.sph.sph_compiler import SPHCompiler
except ImportError as missing:
    print(f"pysph_peer: {missing}")
    sys.exit(77)


class Conduction(Equation):
    """rho c dT/dt = sum m_j/rho_j 4 k_i k_j/(k_i + k_j) (T_i - T_j) F_ij (Brookshaw 1985; Cleary and Monaghan 1999)"""

    def initialize(self, d_idx, d_aT):
        d_aT[d_idx] = 0.0

    def loop(self, d_idx, s_idx, d_aT, d_T, s_T, d_k, s_k, s_V, XIJ, R2IJ, DWIJ, HIJ):
        F = (XIJ[0] * DWIJ[0] + XIJ[1] * DWIJ[1]) / (R2IJ + 0.01 * HIJ * HIJ)
        mean = 4.0 * d_k[d_idx] * s_k[s_idx] / (d_k[d_idx] + s_k[s_idx])
        d_aT[d_idx] += s_V[s_idx] * mean * (d_T[d_idx] - s_T[s_idx]) * F


def read_case(path):
    with open(path) as lines:
        return dict(line.rstrip("\n").split(" = ", 1) for line in lines)


def numbers(text):
    return [float(word) for word in text.split(",")]


def cells(case, dx, layers):
    lo, hi = numbers(case["lo"]), numbers(case["hi"])
    n = [round((h - l) / dx) for l, h in zip(lo, hi)]
    axes = [l + (np.arange(-layers, m + layers) + 0.5) * dx for l, m in zip(lo, n)]
    x, y = (a.ravel() for a in np.meshgrid(*axes))
    inside = (x > lo[0]) & (x < hi[0]) & (y > lo[1]) & (y < hi[1])
    return x, y, inside, lo, hi


def start_of(case, x, y):
    T0 = float(case["param_T0"])
    if case["scene"] == "plate":
        return np.full_like(x, T0)
    a, b = (float(case["param_" + k]) * (1 + 1e-12) for k in "ab")
    return T0 * ((abs(x) <= a) & (abs(y) <= b)).astype(float)


def walls(case, x, y, lo, hi):
    side = [float(case["side_" + s].split(", ")[1]) for s in ("x_lo", "x_hi", "y_lo", "y_hi")]
    return np.where(x < lo[0], side[0], np.where(x > hi[0], side[1], np.where(y < lo[1], side[2], side[3])))


def main(case_path, out, kernel_name, fourier):
    case = read_case(case_path)
    get_config().use_openmp = int(case["threads"]) > 1
    if case["scene"] not in ("square-step", "plate"):
        sys.exit("pysph_peer: knows square-step and plate")
    dx, t_end = float(case["dx"]), float(case["t_end"])
    kappa, h = float(case["k_x"]) / float(case["rho_c"]), 1.1 * dx
    kernel = QuinticSpline(dim=2) if kernel_name == "quintic" else CubicSpline(dim=2)
    x, y, inside, lo, hi = cells(case, dx, 1 + int(kernel.radius_scale * 1.1))
    T = np.where(inside, start_of(case, x, y), walls(case, x, y, lo, hi))
    arrays = []
    for name, part in (("body", inside), ("wall", ~inside)):
        one = np.ones(part.sum())
        array = get_particle_array(name=name, x=x[part], y=y[part], h=h * one, m=one, rho=one)
        for key, value in (("T", T[part]), ("aT", 0 * one), ("k", kappa * one), ("V", dx * dx * one)):
            array.add_property(key, data=value)
        arrays.append(array)
    body = arrays[0]
    evaluation = AccelerationEval(arrays, [Group([Conduction(dest="body", sources=["body", "wall"])])], kernel)
    SPHCompiler(evaluation, None).compile()
    steps = int(np.ceil(t_end * kappa / (float(fourier) * dx * dx)))
    dt = t_end / steps
    start = time.perf_counter()
    while True:  # a tenth of a second, then the one that counts: program and memory are ready
        body.T[:] = T[inside]
        begin = time.perf_counter()
        nnps = LinkedListNNPS(dim=2, particles=arrays, radius_scale=kernel.radius_scale, fixed_h=True, cache=True)
        evaluation.set_nnps(nnps)
        for _ in range(steps):
            evaluation.compute(0.0, dt)
            body.T += dt * body.aT
        seconds = time.perf_counter() - begin
        if begin - start > 0.1:
            break
    with open(out, "w") as answer:
        answer.write(f"# seconds = {seconds:.9g}\n# steps = {steps}\n# updates = {steps * body.get_number_of_particles()}\n")
        answer.write("x,y,T\n")
        np.savetxt(answer, np.column_stack([body.x, body.y, body.T]), fmt="%.17g", delimiter=",")


if __name__ == "__main__":
    main(*sys.argv[1:])
