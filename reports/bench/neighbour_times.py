#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""neighbour_times.py CELL_LISTS [N]: neighbours of N^3 jittered particles in a cube (a million), within 2.2 spacings.

The cell lists of this code (the program CELL_LISTS), SciPy's cKDTree.query_pairs and PySPH's LinkedListNNPS, on one
thread, in turn in each of three rounds.  Printed is processor time, which hardly depends on other load; cKDTree lists
each pair once, the others twice.
"""
import os
import statistics
import subprocess
import sys
import tempfile
import time

os.environ["OMP_NUM_THREADS"] = "1"
import numpy as np
from pysph.base.nnps import LinkedListNNPS
from pysph.base.utils import get_particle_array
from scipy.spatial import cKDTree

ROUNDS, JITTER, REACH = 3, 0.2, 2.2
n = int(sys.argv[2]) if len(sys.argv) > 2 else 100
places = np.stack(np.meshgrid(*3 * [np.arange(n) + 0.5], indexing="ij"), axis=-1).reshape(-1, 3)[:, ::-1]
x = (places + np.random.default_rng(1).uniform(-JITTER, JITTER, places.shape)) / n
radius = REACH / n


def cell_lists(file):
    run = subprocess.run([sys.argv[1], file, str(radius)], stdout=subprocess.PIPE, text=True, check=True)
    pairs, seconds = run.stdout.split()
    return int(pairs), float(seconds)


def tree(_):
    begin = time.process_time()
    pairs = 2 * len(cKDTree(x).query_pairs(radius, output_type="ndarray"))
    return pairs, time.process_time() - begin


def linked_list(_):
    body = get_particle_array(name="body", x=x[:, 0], y=x[:, 1], z=x[:, 2], h=radius / 2)
    begin = time.process_time()
    search = LinkedListNNPS(3, [body], radius_scale=2, fixed_h=True, cache=True)
    search.update()
    search.set_context(0, 0)
    search.cache[0].find_all_neighbors()
    return None, time.process_time() - begin


with tempfile.TemporaryDirectory() as folder:
    x.tofile(f"{folder}/points")
    rounds = [[search(f"{folder}/points") for search in (cell_lists, tree, linked_list)] for _ in range(ROUNDS)]
assert rounds[0][0][0] == rounds[0][1][0], rounds[0]
print("| neighbours of %d particles | processor time, s | times that of this code |\n|---|---:|---:|" % len(x))
for k, name in enumerate(("this code", "SciPy, cKDTree.query_pairs", "PySPH, LinkedListNNPS")):
    ratios = [one[k][1] / one[0][1] for one in rounds]
    print(f"| {name} | {statistics.median(one[k][1] for one in rounds):.2f} | {statistics.median(ratios):.1f} "
          f"({min(ratios):.1f} to {max(ratios):.1f}) |")
