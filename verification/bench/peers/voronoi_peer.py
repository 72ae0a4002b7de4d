"""A peer of the Voronoi cells: SciPy's Voronoi (Qhull), the particles mirrored in the sides.

    voronoi_peer.py POINTS LO_X HI_X LO_Y HI_Y      POINTS: a line x y for each particle

Prints the seconds from the points in memory to areas, neighbours and faces, the sum of the areas and that of the
lengths of the faces between two particles.  Particles within four mean spacings of a side have an image in it.
"""
import sys
import time

try:
    import numpy as np
    from scipy.spatial import Voronoi
except ImportError as missing:
    print(f"voronoi_peer: {missing}")
    sys.exit(77)


def cells(points, lo, hi):
    """The areas of the particles' cells, the pairs of neighbours and the lengths of their faces."""
    band = 4 * np.sqrt(np.prod(hi - lo) / len(points))
    images = [points]
    for axis in range(2):
        known = np.concatenate(images)
        for side in (lo[axis], hi[axis]):
            image = known[abs(known[:, axis] - side) < band]
            image[:, axis] = 2 * side - image[:, axis]
            images.append(image)
    places = np.concatenate(images)
    found = Voronoi(places)
    ends, pairs = np.asarray(found.ridge_vertices), found.ridge_points
    inside = (ends >= 0).all(axis=1) & (pairs < len(points)).any(axis=1)
    pairs = pairs[inside]
    a, b = found.vertices[ends[inside]].transpose(1, 0, 2)
    length = np.hypot(*(b - a).T)
    apart = np.hypot(*(places[pairs[:, 1]] - places[pairs[:, 0]]).T)
    area = np.bincount(pairs.ravel(), np.repeat(length * apart / 4, 2), len(places))[:len(points)]
    own = (pairs < len(points)).all(axis=1)
    return area, pairs[own], length[own]


def main(path, *box):
    points = np.loadtxt(path)
    lo_x, hi_x, lo_y, hi_y = (float(word) for word in box)
    start = time.perf_counter()
    area, _, length = cells(points, np.array([lo_x, lo_y]), np.array([hi_x, hi_y]))
    seconds = time.perf_counter() - start
    print(f"{seconds:.9g} {area.sum():.17g} {length.sum():.17g}")


main(*sys.argv[1:])
