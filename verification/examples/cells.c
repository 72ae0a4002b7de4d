/* cells CASE OUT: finite volumes on a grid of cells, explicit Euler.  All that the case does not tell, `heatladder
   reference` does, at the centres of the cells and of the faces on the sides; $HEATLADDER is that program. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
enum { MEAN, SOURCE, RHO_C, K, KIND, VALUE, B, COLUMNS = 11 }; /* K to B of x, then of y */
int main(int argc, char **argv) {
    char line[5000], ask[4500], oracle[2048] = "", kind[9] = "";
    double lo[2] = {0}, hi[2] = {0, 1}, t_end = 0, fastest = 0, speed = 0;
    int dim = 1, n[2] = {1, 1}, m = 0, steps = 0;
    FILE *f = argc == 3 ? fopen(argv[1], "r") : NULL;
    if (!f) return fprintf(stderr, "cells CASE OUT\n"), 1;
    while (fgets(line, sizeof line, f))
        sscanf(line, "dim = %d", &dim), sscanf(line, "cells = %d, %d", n, n + 1), sscanf(line, "t_end = %lf", &t_end),
            sscanf(line, "lo = %lf, %lf", lo, lo + 1), sscanf(line, "hi = %lf, %lf", hi, hi + 1),
            sscanf(line, "oracle = %2047[^\n]", oracle), sscanf(line, "source = %8s", kind);
    /* Cells 1 to n along each axis, framed by the faces on the sides; a rod is one row, without a frame in y. */
    int nx = n[0] + 2, all = nx * (dim == 2 ? n[1] + 2 : 1), *in = calloc((size_t)all, sizeof *in);
    double *T = calloc((size_t)all, sizeof *T), *rate = calloc((size_t)all, sizeof *rate);
    double h[2] = {(hi[0] - lo[0]) / n[0], (hi[1] - lo[1]) / n[1]}, (*at)[2] = calloc((size_t)all, sizeof *at);
    double(*p)[COLUMNS] = calloc((size_t)all, sizeof *p), (*g)[5] = calloc((size_t)all, sizeof *g);
    snprintf(line, sizeof line, "%s.points", argv[2]), f = fopen(line, "w"), fprintf(f, "x,y,dx,dy\n");
    for (int c = 0; c < all; c++) {
        int i[] = {c % nx, c / nx}, inside = 1;
        for (int d = 0; d < dim; inside = inside && i[d] >= 1 && i[d] <= n[d], d++)
            at[c][d] = i[d] < 1 ? lo[d] : i[d] > n[d] ? hi[d] : lo[d] + (i[d] - 0.5) * h[d];
        in[m] = c, m += inside, fprintf(f, "%.17g,%.17g,%.17g,%.17g\n", at[c][0], at[c][1], h[0], h[1]);
    }
    snprintf(ask, sizeof ask, "${HEATLADDER:-heatladder} reference %s --points %s.points --time 0", oracle, argv[2]);
    sprintf(line, "%s --what initial_heat,source,rho_c,k_x,wall_x%s", ask, dim > 1 ? ",k_y,wall_y" : "");
    fclose(f), f = popen(line, "r"), fgets(line, sizeof line, f);
    for (int c = 0, i = -dim; c < all && fgets(line, sizeof line, f); T[c] = p[c][MEAN], c++, i = -dim)
        for (char *w = strtok(line, ","); w; w = strtok(NULL, ","), i++) if (i >= 0) p[c][i] = atof(w);
    if (pclose(f)) return fprintf(stderr, "cells: no answer from heatladder reference\n"), 1;
    /* Conductances of the faces, over the cell's width: half cells in series, and at a side Robin's coefficient. */
    for (int a = 0, c = in[0]; a < m; c = in[++a], fastest = fmax(fastest, speed), speed = 0)
        for (int s = 0, next[] = {c - 1, c + 1, c - nx, c + nx}; s < 2 * dim; s++) {
            int d = s / 2, side = (d ? c / nx : c % nx) == (s % 2 ? n[d] : 1);
            double *q = p[next[s]] + 4 * d, k = p[c][K + 4 * d], beyond = q[KIND] == 3 ? 1 / q[B] : 0;
            if (side) T[next[s]] = q[VALUE];
            g[c][s] = 1 / (h[d] / (2 * k) + (side ? beyond : h[d] / (2 * q[K]))) / h[d];
            if (side && q[KIND] == 2) g[c][s] = 0, g[c][4] += q[VALUE] / h[d];
            speed += k / (h[d] * h[d] * p[c][RHO_C]) / 2;
        }
    steps = (int)ceil(t_end * fastest / 0.25); /* a source that changes is told for all of them */
    snprintf(line, sizeof line, "%s:%.17g:%d --what source | tail -n +2", ask, t_end, steps + 1);
    for (int step = (f = *kind == 'c' ? popen(line, "r") : NULL, 0); step < steps; step++) {
        for (int c = 0; f && c < all && fgets(line, sizeof line, f); c++) p[c][SOURCE] = atof(strrchr(line, ',') + 1);
        for (int a = 0, c = in[0]; a < m; c = in[++a])
            rate[c] = p[c][SOURCE] + g[c][4] + g[c][0] * (T[c - 1] - T[c]) + g[c][1] * (T[c + 1] - T[c]) +
                      (dim < 2 ? 0 : g[c][2] * (T[c - nx] - T[c]) + g[c][3] * (T[c + nx] - T[c]));
        for (int a = 0, c = in[0]; a < m; c = in[++a]) T[c] += t_end / steps * rate[c] / p[c][RHO_C];
    }
    f = fopen(argv[2], "w"), fprintf(f, "# steps = %d\n%s\n", steps, dim == 2 ? "x,y,T" : "x,T");
    for (int a = 0, c = in[0]; a < m; c = in[++a])
        fprintf(f, dim == 2 ? "%.17g,%.17g,%.17g\n" : "%.17g,%.17g\n", at[c][0], dim == 2 ? at[c][1] : T[c], T[c]);
    return fclose(f) != 0;
}
