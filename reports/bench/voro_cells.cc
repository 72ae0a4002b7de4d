// SPDX-License-Identifier: GPL-3.0-or-later
// voro_cells CASE OUT: two-point fluxes between the Voronoi cells of jittered points on square-step, cells by Voro++.
//
//     V_i dT_i/dt = kappa sum over faces of length / distance (T_j - T_i), T = 0 on the sides; explicit Euler
//
// Voro++ 0.4 has three dimensions: the cells are those of one layer of points in a box, as thick as dx.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>
#include <voro++/voro++.hh>

struct face {
    int from, to; // to < 0: a side
    double conductance;
};

static double dx, L, a, kappa, T0, t_end;
static int n;
static std::vector<double> x, y, T, volume;
static std::vector<face> faces;

static void read_case(const char *path) {
    char line[4096], scene[40] = "";
    FILE *f = fopen(path, "r");
    if (!f) exit(1);
    while (fgets(line, sizeof line, f)) {
        sscanf(line, "scene = %39s", scene);
        sscanf(line, "cells = %d", &n);
        sscanf(line, "dx = %lf", &dx);
        sscanf(line, "param_L = %lf", &L);
        sscanf(line, "param_a = %lf", &a);
        sscanf(line, "param_kappa_x = %lf", &kappa);
        sscanf(line, "param_T0 = %lf", &T0);
        sscanf(line, "t_end = %lf", &t_end);
    }
    fclose(f);
    if (strcmp(scene, "square-step") != 0) exit(77);
}

static void place_points() {
    std::mt19937 draw(1);
    std::uniform_real_distribution<double> jitter(-0.3 * dx, 0.3 * dx);
    for (int k = 0; k < n * n; k++) {
        x.push_back(-L + (k % n + 0.5) * dx + jitter(draw));
        y.push_back(-L + (k / n + 0.5) * dx + jitter(draw));
        T.push_back(std::fabs(x[k]) <= a && std::fabs(y[k]) <= a ? T0 : 0);
    }
}

static void make_cells() {
    int blocks = int(n / std::sqrt(voro::optimal_particles)) + 1;
    voro::container box(-L, L, -L, L, -dx / 2, dx / 2, blocks, blocks, 1, false, false, false, 8);
    for (int i = 0; i < n * n; i++) box.put(i, x[i], y[i], 0);
    volume.assign(n * n, 0);
    voro::c_loop_all all(box);
    voro::voronoicell_neighbor cell;
    std::vector<int> neighbour;
    std::vector<double> area;
    if (!all.start()) exit(1);
    do {
        if (!box.compute_cell(cell, all)) exit(1);
        int i = all.pid();
        volume[i] = cell.volume() / dx;
        cell.neighbors(neighbour);
        cell.face_areas(area);
        for (size_t k = 0; k < neighbour.size(); k++) {
            int j = neighbour[k];
            if (j < -4) continue; // the layer's own faces
            double side = j == -1 ? L + x[i] : j == -2 ? L - x[i] : j == -3 ? L + y[i] : L - y[i];
            double distance = j < 0 ? side : std::hypot(x[j] - x[i], y[j] - y[i]);
            if (j < i) faces.push_back({i, j, kappa * area[k] / dx / distance});
        }
    } while (all.inc());
}

static void march() {
    std::vector<double> rate(n * n), sum(n * n);
    double dt = t_end;
    for (const face &f : faces) {
        sum[f.from] += f.conductance;
        if (f.to >= 0) sum[f.to] += f.conductance;
    }
    for (int i = 0; i < n * n; i++) dt = std::fmin(dt, 0.8 * volume[i] / sum[i]);
    int steps = int(std::ceil(t_end / dt));
    for (int step = 0; step < steps; step++) {
        std::fill(rate.begin(), rate.end(), 0);
        for (const face &f : faces) {
            double flux = f.conductance * ((f.to < 0 ? 0 : T[f.to]) - T[f.from]);
            rate[f.from] += flux;
            if (f.to >= 0) rate[f.to] -= flux;
        }
        for (int i = 0; i < n * n; i++) T[i] += t_end / steps * rate[i] / volume[i];
    }
}

int main(int argc, char **argv) {
    if (argc != 3) return 1;
    read_case(argv[1]);
    place_points();
    auto begin = std::chrono::steady_clock::now();
    make_cells();
    march();
    double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    FILE *out = fopen(argv[2], "w");
    if (!out) return 1;
    fprintf(out, "# seconds = %.9g\nx,y,T\n", seconds);
    for (int i = 0; i < n * n; i++) fprintf(out, "%.17g,%.17g,%.17g\n", x[i], y[i], T[i]);
    return fclose(out) != 0;
}
