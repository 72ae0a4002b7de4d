#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""pysph_operators.py HEATLADDER: PySPH's operators of diffusion beside those of this code, on the same clouds.

One wave of a periodic square decays for 0.5 s, RK2, mesh Fourier number 0.1, one thread, n = 16, 32, 64 particles
along an axis; a lattice and a jitter of 0.2 dx, seed 1.  Each entry has the order of E1 (n = 16 to 64), the share of
the conductivity that the decay shows (n = 64), and processor time (n = 64): of PySPH's steps, of this code's whole run.
PySPH reads the points that `run --field` wrote.  Its particles beyond the sides are copies, and its schemes compute
weights and corrections in each step, this code once.
"""
import csv
import json
import math
import os
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np
from pysph.base.kernels import CubicSpline
from pysph.base.nnps import LinkedListNNPS
from pysph.base.utils import get_particle_array
from pysph.sph.acceleration_eval import AccelerationEval
from pysph.sph.equation import Group
from pysph.sph.sph_compiler import SPHCompiler
from pysph.sph.wc import kernel_correction, transport_velocity, viscosity

program = os.path.abspath(sys.argv[1])
os.environ["OMP_NUM_THREADS"] = "1"
KAPPA, END, FOURIER, SIZES, RATIOS = 0.01, 0.5, 0.1, (16, 32, 64), (1.1, 1.3, 1.5)
WAVE = "--set mode_y=1 --t-end %g" % END
RATE = KAPPA * 2 * (2 * math.pi) ** 2  # 1/s, of the wave
CLOUDS = {"lattice": "", "jitter": "--layout jitter --jitter 0.2 --seed 1"}
OURS = ["brookshaw --volume raw", "brookshaw", "brookshaw_corrected", "kernel_second", "flux_divergence", "fo_ssph",
        "so_ssph", "schwaiger", "fatehi_manzari", "cspm", "voronoi_flux"]
# PySPH's equation (T is the velocity along x, kappa the viscosity), and its correction of the kernel's gradient;
# the correction is left out, by default, for pairs whose gradient it changes by more than 10 %.
PEERS = [("LaminarViscosity", "none"), ("LaminarViscosity", "GradientCorrection"),
         ("LaminarViscosity", "GradientCorrection, all pairs"),
         ("LaminarViscosity", "MixedGradientCorrection, all pairs"),
         ("TVF MomentumEquationViscosity", "none"), ("TVF MomentumEquationViscosity", "GradientCorrection, all pairs")]


def equations(name, correction):
    """The groups of a right-hand side, as PySPH's schemes write them."""
    body, groups, loop = ("body", ["body"]), [], []
    if name.startswith("TVF"):  # its volumes are those of the summed density
        groups.append(Group([transport_velocity.SummationDensity(*body)], real=False))
        loop = [transport_velocity.MomentumEquationViscosity(*body, nu=KAPPA)]
    else:
        loop = [viscosity.LaminarViscosity(*body, nu=KAPPA)]
    kind, _, pairs = correction.partition(",")
    limit = {"tol": 1e9} if pairs else {}
    if kind != "none":
        before = {"GradientCorrection": "GradientCorrectionPreStep",
                  "MixedGradientCorrection": "MixedKernelCorrectionPreStep"}[kind]
        groups.append(Group([getattr(kernel_correction, before)(*body, dim=2)], real=False))
        loop.insert(0, getattr(kernel_correction, kind)(*body, dim=2, **limit))
    return groups + [Group(loop)]


def images(x):
    """The points and their copies within 4 spacings of the unit square, and the point that each copies."""
    shifts = [(a, b) for a in (0, -1, 1) for b in (0, -1, 1)]
    all_x, of = np.concatenate([x + s for s in shifts]), np.tile(np.arange(len(x)), len(shifts))
    near = (np.abs(all_x - 0.5) < 0.5 + 4 / math.sqrt(len(x))).all(axis=1)
    near[:len(x)] = True
    return all_x[near], of[near]


def peer(operator, x, T, h, steps):
    """T at the end, and the processor time of the steps."""
    n, (places, of) = len(x), images(x)
    body = get_particle_array(name="body", x=places[:, 0], y=places[:, 1], h=h / math.sqrt(n), m=1.0 / n, rho=1.0,
                              **dict.fromkeys("u v w au av aw V cwij".split(), 0.0))
    body.add_property("m_mat", stride=9)
    body.add_property("dw_gamma", stride=3)
    evaluation = AccelerationEval([body], equations(*operator), CubicSpline(dim=2))
    SPHCompiler(evaluation, None).compile()
    evaluation.set_nnps(LinkedListNNPS(2, [body], radius_scale=2, fixed_h=True, cache=True))
    dt = END / steps

    def rate(T):
        body.u[:], body.au[:] = T[of], 0.0
        evaluation.compute(0.0, dt)
        return body.au[:n]

    rate(T)  # neighbours are cached
    begin = time.process_time()
    for _ in range(steps):
        T = T + dt * rate(T + dt / 2 * rate(T))
    return T, time.process_time() - begin


def own(method, cloud, n, h, file):
    """Runs this code: points, T and the exact T at the end, steps, processor time.  None where a run is unstable."""
    ratio = [] if method.startswith("voronoi") else ["--h", str(h)]
    words = f"run wave {method} {WAVE} {CLOUDS[cloud]} --dx 1/{n} --stepper rk2 --fourier {FOURIER} --field {file}"
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    run = subprocess.run([program, *words.split(), *ratio, "--json", "-"], stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE, text=True)
    if run.returncode:
        return None
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    field = np.loadtxt(file, delimiter=",", skiprows=1)
    return field[:, :2], field[:, 2], field[:, 3], json.loads(run.stdout)["steps"], seconds


def start_at(points):
    asked = subprocess.run([program, "reference", "wave", *WAVE.split(), "--points", points, "--what", "initial"],
                           stdout=subprocess.PIPE, text=True, check=True)
    return np.array([float(row["initial"]) for row in csv.DictReader(asked.stdout.splitlines())])


def entry(runs):
    """Order, share, seconds of the runs of all sizes: (T, exact T, seconds)."""
    if None in runs or not all(np.isfinite(T).all() for T, _, _ in runs):
        return "unstable"
    errors = [np.abs(T - exact).mean() for T, exact, _ in runs]
    T, exact, seconds = runs[-1]
    wave = exact - 1
    share = 1 - math.log(max((T - 1) @ wave / (wave @ wave), 1e-300)) / (RATE * END)
    order = math.log(errors[0] / errors[-1]) / math.log(SIZES[-1] / SIZES[0])
    return f"{order:.2f}, {share:.4f}, {seconds:.2g} s"


def table(cloud, folder):
    print(f"\n| {cloud}: order, share, seconds | " + " | ".join(f"h/dx {h}" for h in RATIOS) + " |")
    print("|---" * (len(RATIOS) + 1) + "|")
    for method in OURS:
        runs = {h: [own(method, cloud, n, h, f"{folder}/field") for n in SIZES] for h in RATIOS}
        cells = [entry([run and (run[1], run[2], run[4]) for run in runs[h]]) for h in RATIOS]
        print(f"| `{method}` | " + " | ".join(cells) + " |", flush=True)
    clouds = []
    for n in SIZES:
        x, _, exact, steps, _ = own("brookshaw", cloud, n, RATIOS[0], f"{folder}/{n}.csv")
        clouds.append((x, start_at(f"{folder}/{n}.csv"), exact, steps))
    for operator in PEERS:
        cells = []
        for h in RATIOS:
            runs = [(*peer(operator, x, T, h, steps), exact) for x, T, exact, steps in clouds]
            cells.append(entry([(T, exact, seconds) for T, seconds, exact in runs]))
        print(f"| PySPH {operator[0]}, {operator[1]} | " + " | ".join(cells) + " |", flush=True)


with tempfile.TemporaryDirectory() as place:
    for name in CLOUDS:
        table(name, place)
