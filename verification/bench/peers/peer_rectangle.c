/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads the case, fills in the start, writes the answer. */
#include "verification/bench/peers/peer_rectangle.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void rectangle_die(const char *text) {
    fprintf(stderr, "stand-in: %s\n", text);
    exit(1);
}

static void take(struct rectangle *p, double *hi, double *rho_c, const char *key, const char *value) {
    static const char *const sides[] = {"side_x_lo", "side_x_hi", "side_y_lo", "side_y_hi"};
    if (!strcmp(key, "scene")) {
        p->plate = !strcmp(value, "plate");
        if (!p->plate && strcmp(value, "square-step")) rectangle_die("knows square-step and plate");
    }
    if (!strcmp(key, "lo")) sscanf(value, "%lf, %lf", &p->lo[0], &p->lo[1]);
    if (!strcmp(key, "hi")) sscanf(value, "%lf, %lf", &hi[0], &hi[1]);
    if (!strcmp(key, "dx")) p->dx = atof(value);
    if (!strcmp(key, "t_end")) p->t_end = atof(value);
    if (!strcmp(key, "k_x")) p->kappa[0] = atof(value);
    if (!strcmp(key, "k_y")) p->kappa[1] = atof(value);
    if (!strcmp(key, "rho_c")) *rho_c = atof(value);
    if (!strcmp(key, "param_T0")) p->T0 = atof(value);
    if (!strcmp(key, "param_a")) p->half[0] = atof(value);
    if (!strcmp(key, "param_b")) p->half[1] = atof(value);
    if (!strcmp(key, "threads")) p->threads = atoi(value);
    for (int s = 0; s < 4; s++)
        if (!strcmp(key, sides[s]) && sscanf(value, "dirichlet, %lf", &p->side[s]) != 1)
            rectangle_die("only sides that hold a temperature");
}

struct rectangle rectangle_read(const char *path) {
    struct rectangle p = {.threads = 1};
    double hi[2] = {0}, rho_c = 1;
    char line[512];
    FILE *in = fopen(path, "r");
    if (!in) rectangle_die("cannot read the case");
    while (fgets(line, sizeof line, in)) {
        char *value = strstr(line, " = ");
        if (!value) continue;
        *value = '\0';
        value[3 + strcspn(value + 3, "\n")] = '\0';
        take(&p, hi, &rho_c, line, value + 3);
    }
    fclose(in);
    for (int a = 0; a < 2; a++) {
        p.kappa[a] /= rho_c;
        p.n[a] = (int)lround((hi[a] - p.lo[a]) / p.dx);
    }
    return p;
}

void rectangle_start(const struct rectangle *p, double *T) {
    for (int j = 0; j < p->n[1]; j++)
        for (int i = 0; i < p->n[0]; i++) {
            double x = p->lo[0] + (i + 0.5) * p->dx, y = p->lo[1] + (j + 0.5) * p->dx;
            int hot = p->plate || (fabs(x) <= p->half[0] * (1 + 1e-12) && fabs(y) <= p->half[1] * (1 + 1e-12));
            T[(size_t)j * (size_t)p->n[0] + (size_t)i] = hot ? p->T0 : 0;
        }
}

void rectangle_write(const struct rectangle *p, const double *T, const char *path, double seconds, long steps) {
    FILE *out = fopen(path, "w");
    if (!out) rectangle_die("cannot write the answer");
    fprintf(out, "# seconds = %.9g\n# steps = %ld\nx,y,T\n", seconds, steps);
    for (int j = 0; j < p->n[1]; j++)
        for (int i = 0; i < p->n[0]; i++)
            fprintf(out, "%.17g,%.17g,%.17g\n", p->lo[0] + (i + 0.5) * p->dx, p->lo[1] + (j + 0.5) * p->dx,
                    T[(size_t)j * (size_t)p->n[0] + (size_t)i]);
    if (fclose(out)) rectangle_die("cannot write the answer");
}
