// SPDX-License-Identifier: GPL-3.0-or-later
// A peer of the Voronoi cells: Voro++ 0.4, which knows three dimensions, on one layer of particles in a box.
//
//     voro_peer POINTS LO_X HI_X LO_Y HI_Y      POINTS: a line x y for each particle
//
// Prints the seconds from the points in memory to areas, neighbours and faces, the sum of the areas and that of the
// lengths of the faces between two particles.  The layer is as thick as a particle's share of the box is wide, and
// blocks are of the size that the library asks for.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>
#include <voro++/voro++.hh>

int main(int argc, char **argv) {
    if (argc != 6) return 2;
    double lo[2] = {atof(argv[2]), atof(argv[4])}, hi[2] = {atof(argv[3]), atof(argv[5])}, x, y;
    std::vector<double> at;
    FILE *in = fopen(argv[1], "r");
    if (!in) return 2;
    while (fscanf(in, "%lf %lf", &x, &y) == 2) at.push_back(x), at.push_back(y);
    fclose(in);
    auto start = std::chrono::steady_clock::now();
    size_t n = at.size() / 2;
    double wide = std::sqrt((hi[0] - lo[0]) * (hi[1] - lo[1]) / n), block = std::sqrt(voro::optimal_particles) * wide;
    voro::container box(lo[0], hi[0], lo[1], hi[1], -wide / 2, wide / 2, int((hi[0] - lo[0]) / block) + 1,
                        int((hi[1] - lo[1]) / block) + 1, 1, false, false, false, 8);
    for (size_t i = 0; i < n; i++) box.put(int(i), at[2 * i], at[2 * i + 1], 0);
    voro::c_loop_all all(box);
    voro::voronoicell_neighbor cell;
    std::vector<int> beyond, neighbours;
    std::vector<double> faces, lengths, areas;
    if (all.start()) do
            if (box.compute_cell(cell, all)) {
                areas.push_back(cell.volume() / wide);
                cell.neighbors(beyond);
                cell.face_areas(faces);
                for (size_t k = 0; k < beyond.size(); k++)
                    if (beyond[k] >= 0) neighbours.push_back(beyond[k]), lengths.push_back(faces[k] / wide);
            }
        while (all.inc());
    std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    double area = 0, length = 0;
    for (double a : areas) area += a;
    for (double l : lengths) length += l / 2; // from either side
    printf("%.9g %.17g %.17g\n", took.count(), area, length);
    return 0;
}
