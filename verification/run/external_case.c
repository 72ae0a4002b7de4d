/* The case file of --solver: one `key = value` a line, SI, numbers with 17 digits, several values with commas
 * between.
 */
#include "verification/run/external_case.h"

#include "references/scene.h"
#include "verification/run/experiment.h"

#include <math.h>

/* Places along a side at which a temperature or flux that varies is given. */
enum { PLACES = 9 };

static void write_pair(FILE *out, const char *key, const double *value, int count) {
    fprintf(out, "%s = %.17g", key, value[0]);
    if (count == 2) fprintf(out, ", %.17g", value[1]);
    fputc('\n', out);
}

static void write_params(const struct experiment *e, FILE *out) {
    const struct param *table = e->scene->params;
    for (int i = 0; table[i].name; i++) {
        double value = e->problem.param[i];
        if (table[i].choice)
            fprintf(out, "param_%s = %s\n", table[i].name, table[i].choice[(int)value]);
        else
            fprintf(out, "param_%s = %.17g\n", table[i].name, value);
    }
}

static void write_materials(const struct problem *p, FILE *out) {
    static const char *const axis[] = {"k_x", "k_y"};
    double value[MATERIAL_MAX];
    fprintf(out, "materials = %d\n", p->materials);
    if (p->materials == 2) fprintf(out, "interface = %.17g\n", p->interface);
    for (int a = 0; a < p->dim; a++) {
        for (int m = 0; m < p->materials; m++) value[m] = p->material[m].k[a];
        write_pair(out, axis[a], value, p->materials);
    }
    for (int m = 0; m < p->materials; m++) value[m] = p->material[m].rho_c;
    write_pair(out, "rho_c", value, p->materials);
}

/* One value where the side is held at one, else PLACES of them, evenly from its low to its high end. */
static void write_side(const struct problem *p, int s, FILE *out) {
    static const char *const name[] = {"side_x_lo", "side_x_hi", "side_y_lo", "side_y_hi"};
    double value[PLACES];
    int along = 1 - s / 2, count = 1;
    for (int i = 0; i < PLACES; i++) {
        double x[2];
        x[s / 2] = s % 2 ? p->hi[s / 2] : p->lo[s / 2];
        x[along] = p->lo[along] + (p->hi[along] - p->lo[along]) * i / (PLACES - 1);
        value[i] = p->wall(p, (enum side)s, x);
        if (value[i] != value[0]) count = PLACES;
    }
    fprintf(out, "%s = %s", name[s], p->side[s] == DIRICHLET ? "dirichlet" : "neumann");
    for (int i = 0; i < count; i++) fprintf(out, ", %.17g", value[i]);
    fputc('\n', out);
}

void external_case_write(const struct experiment *e, FILE *out) {
    const struct problem *p = &e->problem;
    fprintf(out, "scene = %s\nlabel = %s\ndim = %d\n", e->scene->name, e->method->name, p->dim);
    write_params(e, out);
    write_pair(out, "lo", p->lo, p->dim);
    write_pair(out, "hi", p->hi, p->dim);
    write_materials(p, out);
    for (int s = 0; s < 2 * p->dim; s++) write_side(p, s, out);
    fprintf(out, "source = %s\nt_end = %.17g\ndx = %.17g\n", p->source ? "yes" : "no", p->t_end, e->options.dx);
    if (e->options.dt > 0) fprintf(out, "dt = %.17g\n", e->options.dt);
    if (e->options.fourier > 0) fprintf(out, "fourier = %.17g\n", e->options.fourier);
    fprintf(out, "threads = %d\n", e->options.threads > 1 ? e->options.threads : 1);
}
