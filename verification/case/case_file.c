/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes the case file of a program, and reads it back. */
#include "verification/case/case_file.h"

#include "references/mapping.h"
#include "references/scene.h"
#include "solver/options.h"
#include "solver/shape.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/text/number.h"
#include "verification/text/whole_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char case_file_help[] =
    "A case file has one `key = value` a line (SI, several values with commas between):\n"
    "  scene, label, dim        the names on the command line; 1 for a rod, 2 for a rectangle, 3 for a box\n"
    "  param_NAME               every parameter of the scene (heatladder list scenes explains each)\n"
    "  map, scale, offset       only if given: the axes of the case in terms of the scene, such as y,-x, and T of\n"
    "                           the case = scale T + offset, K.  All keys but param_NAME are in axes of the case\n"
    "  lo, hi                   the domain, m: along x, along y and along z\n"
    "  shape                    of a round body: disc, annulus or ball, about 0; with radius, or r1 and r2, m\n"
    "  cells                    extent over dx (along y over dy, if given), rounded: along each axis\n"
    "  materials, interface     1; or 2, the second at x >= interface, m\n"
    "  interface_axis           y or z if the second is at y or z >= interface; not written for x\n"
    "  contact_resistance       m^2 K/W, only if T jumps at the interface of a rod: by this times the heat flux\n"
    "  k_x, k_y, k_z, rho_c     W/(m K), J/(m^3 K): of each material\n"
    "  k_xy, k_xz, k_yz         W/(m K), only of a tensor that is not diagonal: heat flows by -K grad T.  A program\n"
    "                           for diagonal ones ends with exit status 77\n"
    "  conductivity             field, in place of k_x, k_y and k_xy: K = k_perp I + (k_par - k_perp) b b^T with a "
    "unit\n"
    "                           vector b that varies; `reference` has k_x, k_y, k_xy, b_x and b_y at any point\n"
    "  k_par, k_perp            W/(m K): along b and across\n"
    "  k_law                    only if k depends on T, with u = T - k_ref: linear, k = k_0 (1 + k_beta u); power,\n"
    "                           k = k_0 u^k_n, 0 for u <= 0.  k_x is then the largest k of the solution; phases, a\n"
    "                           solid for u < 0 and a liquid for u > 0 that melts at u = 0\n"
    "  k_0, k_beta, k_ref, k_n  W/(m K) (power: times K^-k_n), 1/K, K, 1: of that law\n"
    "  latent                   J/m^3, of phases: latent heat\n"
    "  k_phases, rho_c_phases   W/(m K), J/(m^3 K): of the solid, of the liquid\n"
    "  side_x_lo, side_x_hi, side_y_lo, side_y_hi, side_z_lo, side_z_hi\n"
    "                           dirichlet, K; neumann, W/m^2 into the body; robin, W/(m^2 K), K around: one value,\n"
    "                           or nine evenly along the side (of a box: 3 x 3 from edge to edge, x before y before\n"
    "                           z); periodic: no wall, with no value\n"
    "  side_r_hi, side_r_lo     the same for the outer wall and the hole of a round body; nine values are at the\n"
    "                           angles 0, 45, ... 360 degrees (of a ball: at z = 0)\n"
    "  source                   no; yes, a source constant in time; changing, a source that depends on time\n"
    "  walls                    only if they change in time: changing; side_... is then their value at t = 0\n"
    "  t_end, dx, dt, fourier   s, m, s, 1; dt or fourier only if given\n"
    "  dy                       m, only if given: the spacing along y where it is not dx.  A program with one "
    "spacing\n"
    "                           for both axes ends with exit status 77\n"
    "  seed                     with --seeds: for a cloud, or for random numbers\n"
    "  NAME                     with --vary: the value\n"
    "  oracle                   arguments of `heatladder reference`, which evaluates initial data, source,\n"
    "                           coefficients and walls at your points\n"
    "  threads                  number of threads that the program may use\n";

/* positions along a side at which a varying temperature or flux is given */
enum { PLACES = 9 };

static void write_list(FILE *out, const char *key, const double *value, int count) {
    fprintf(out, "%s =", key);
    for (int i = 0; i < count; i++) fprintf(out, "%s %.17g", i ? "," : "", value[i]);
    fputc('\n', out);
}

/* Writes each parameter with `before` and `between` around its name and `after` behind its value. */
static void write_params(const struct scene *s, const struct problem *p, const char *before, const char *between,
                         const char *after, FILE *out) {
    for (int i = 0; s->params[i].name; i++) {
        fprintf(out, "%s%s%s", before, s->params[i].name, between);
        if (s->params[i].choice)
            fprintf(out, "%s%s", s->params[i].choice[(int)p->param[i]], after);
        else
            fprintf(out, "%.17g%s", p->param[i], after);
    }
}

static void write_materials(const struct image *image, FILE *out) {
    static const char *const axis[] = {"k_x", "k_y", "k_z"}, *const pair[] = {"k_xy", "k_xz", "k_yz"};
    const struct problem *p = &image->problem;
    double value[MATERIAL_MAX];
    fprintf(out, "materials = %d\n", p->materials);
    if (p->materials == 2) fprintf(out, "interface = %.17g\n", p->interface);
    if (p->materials == 2 && image->interface_axis)
        fprintf(out, "interface_axis = %c\n", "xyz"[image->interface_axis]);
    if (p->resistance > 0) fprintf(out, "contact_resistance = %.17g\n", p->resistance);
    if (p->direction) fprintf(out, "conductivity = field\nk_par = %.17g\nk_perp = %.17g\n", p->k_par, p->k_perp);
    for (int a = 0; a < p->dim && !p->direction; a++) {
        for (int m = 0; m < p->materials; m++) value[m] = p->material[m].k[a];
        write_list(out, axis[a], value, p->materials);
    }
    for (int k = 0; k < (p->dim == 3 ? 3 : 1) && problem_has_cross(p) && !p->direction; k++)
        write_list(out, pair[k], &p->cross[k], 1);
    for (int m = 0; m < p->materials; m++) value[m] = p->material[m].rho_c;
    write_list(out, "rho_c", value, p->materials);
    if (p->k_law == K_LINEAR)
        fprintf(out, "k_law = linear\nk_0 = %.17g\nk_beta = %.17g\nk_ref = %.17g\n", p->k_0, p->k_beta, p->k_ref);
    if (p->k_law == K_POWER)
        fprintf(out, "k_law = power\nk_0 = %.17g\nk_n = %.17g\nk_ref = %.17g\n", p->k_0, p->k_n, p->k_ref);
    if (p->k_law != K_PHASES) return;
    fprintf(out, "k_law = phases\nk_ref = %.17g\nlatent = %.17g\n", p->k_ref, p->latent);
    write_list(out, "k_phases", p->phase_k, 2);
    write_list(out, "rho_c_phases", p->phase_rho_c, 2);
}

/* Position `place` on a side in steps of 1/each of its extents, its first axis fastest; or around a round wall. */
static void place_on_side(const struct problem *p, int s, int place, int each, double x[DIM_MAX]) {
    double turn = 2 * M_PI * place / each;
    x[0] = p->radius[s % 2] * cos(turn), x[1] = p->radius[s % 2] * sin(turn), x[2] = 0;
    for (int a = 0; a < p->dim && !p->shape; a++) {
        if (a == s / 2) {
            x[a] = s % 2 ? p->hi[a] : p->lo[a];
            continue;
        }
        x[a] = p->lo[a] + (p->hi[a] - p->lo[a]) * (place % (each + 1)) / each;
        place /= each + 1;
    }
}

static double value_on_side(const struct problem *p, int s, int place, int each) {
    double x[DIM_MAX];
    place_on_side(p, s, place, each, x);
    return p->wall(p, (enum side)s, x, 0);
}

static int is_uniform(const struct problem *p, int s) {
    int places = p->dim == 3 && !p->shape ? PLACES * PLACES : PLACES;
    for (int i = 1; i < places; i++)
        if (value_on_side(p, s, i, PLACES - 1) != value_on_side(p, s, 0, PLACES - 1)) return 0;
    return 1;
}

/* Writes one value if the side is uniform, otherwise PLACES of them. */
static void write_side(const struct problem *p, int s, FILE *out) {
    static const char *const plane[] = {"side_x_lo", "side_x_hi", "side_y_lo", "side_y_hi", "side_z_lo", "side_z_hi"};
    static const char *const round[] = {"side_r_lo", "side_r_hi"};
    if (p->shape && !shape_has_wall(p, s)) return;
    int count = p->side[s] == PERIODIC ? 0 : is_uniform(p, s) ? 1 : PLACES;
    int each = p->dim == 3 && !p->shape ? 2 : PLACES - 1;
    fprintf(out, "%s = %s", (p->shape ? round : plane)[s], problem_law(p, s)->word);
    if (p->side[s] == ROBIN) fprintf(out, ", %.17g", p->robin[s]);
    for (int i = 0; i < count; i++) fprintf(out, ", %.17g", value_on_side(p, s, i, each));
    fputc('\n', out);
}

static void write_shape(const struct problem *p, FILE *out) {
    if (!p->shape) return;
    fprintf(out, "shape = %s\n", p->shape->name);
    if (p->radius[0] > 0)
        fprintf(out, "r1 = %.17g\nr2 = %.17g\n", p->radius[0], p->radius[1]);
    else
        fprintf(out, "radius = %.17g\n", p->radius[1]);
}

/* Writes the options of `heatladder reference`, or the keys of the case, for a mapping that was given. */
static void write_mapping(const struct mapping *m, const char *before, const char *between, const char *after,
                          FILE *out) {
    char words[MAPPING_WORDS];
    mapping_print(m, words);
    if (m->axes) fprintf(out, "%smap%s%s%s", before, between, words, after);
    if (m->scale > 0) fprintf(out, "%sscale%s%.17g%s", before, between, m->scale, after);
    if (m->offset != 0) fprintf(out, "%soffset%s%.17g%s", before, between, m->offset, after);
}

void case_file_write(const struct scene *s, const struct problem *of, const struct options *o,
                     const struct case_extra *extra, FILE *out) {
    static const struct mapping none = {0};
    const struct mapping *m = extra->map ? extra->map : &none;
    struct image image;
    double cells[DIM_MAX];
    mapping_image(m, of, &image);
    const struct problem *p = &image.problem;
    fprintf(out, "scene = %s\nlabel = %s\ndim = %d\n", s->name, extra->label, p->dim);
    write_params(s, p, "param_", " = ", "\n", out);
    write_mapping(m, "", " = ", "\n", out);
    write_list(out, "lo", p->lo, p->dim);
    write_list(out, "hi", p->hi, p->dim);
    write_shape(p, out);
    for (int a = 0; a < p->dim; a++) cells[a] = nearbyint((p->hi[a] - p->lo[a]) / options_spacing(o, a));
    write_list(out, "cells", cells, p->dim);
    write_materials(&image, out);
    for (int side = 0; side < 2 * p->dim; side++) write_side(p, side, out);
    fprintf(out, "source = %s\nt_end = %.17g\ndx = %.17g\n",
            p->source_rate || p->source_at ? "changing"
            : p->source                    ? "yes"
                                           : "no",
            p->t_end, o->dx);
    if (p->wall_rate) fputs("walls = changing\n", out);
    if (o->aspect > 0) fprintf(out, "dy = %.17g\n", options_spacing(o, 1));
    if (o->dt > 0) fprintf(out, "dt = %.17g\n", o->dt);
    if (o->fourier > 0) fprintf(out, "fourier = %.17g\n", o->fourier);
    if (extra->seed > 0) fprintf(out, "seed = %d\n", extra->seed);
    if (extra->name) fprintf(out, "%s = %s\n", extra->name, extra->value);
    fprintf(out, "oracle = %s", s->name);
    write_params(s, p, " --set ", "=", "", out);
    write_mapping(m, " --", " ", "", out);
    fprintf(out, "\nthreads = %d\n", o->threads > 1 ? o->threads : 1);
}

static int divides(const struct problem *p, const struct options *o) {
    for (int a = 0; a < p->dim; a++) {
        double cells = (p->hi[a] - p->lo[a]) / options_spacing(o, a);
        if (!(nearbyint(cells) >= 1 && fabs(cells - nearbyint(cells)) <= 1e-6 * cells)) return 0;
    }
    return 1;
}

/* Whether the domain divides into that number of cells along x and the number along y that --aspect requires. */
static int divides_by(const struct problem *p, const struct options *o, double count) {
    struct options with = *o;
    with.dx = (p->hi[0] - p->lo[0]) / count;
    return divides(p, &with);
}

int case_file_check(const struct problem *p, const struct options *o, struct failure *why) {
    enum { SEARCH = 100000 };
    double extent = p->hi[0] - p->lo[0], coarse = floor(extent / o->dx), fine = coarse + 1;
    char near[80] = "", with[40] = "";
    if (p->shape || divides_by(p, o, extent / o->dx)) return STATUS_OK; /* no lattice fits a round wall */
    for (int i = 0; i < SEARCH && coarse >= 1 && !divides_by(p, o, coarse); i++) coarse--;
    for (int i = 0; i < SEARCH && !divides_by(p, o, fine); i++) fine++;
    if (coarse >= 1) snprintf(near, sizeof near, "; %.10g does", extent / coarse);
    if (divides_by(p, o, fine)) words_add(near, sizeof near, "%s %.10g does", *near ? " and" : ";", extent / fine);
    if (o->aspect > 0) snprintf(with, sizeof with, " --aspect %g", o->aspect);
    return refuse(why, STATUS_INPUT, "--dx %.10g%s: does not divide the domain into whole cells%s", o->dx, with,
                  near);
}

const char *case_file_value(const struct rows *r, const char *key, long *line) {
    size_t length = strlen(key);
    for (size_t i = 0; i < r->count; i++) {
        const struct rows_line *l = &r->line[i];
        const char *at = l->text + length;
        if (strncmp(l->text, key, length) != 0 || at[strspn(at, " \t")] != '=') continue;
        if (line) *line = l->number;
        at = strchr(at, '=') + 1;
        return at + strspn(at, " \t");
    }
    return NULL;
}

int case_file_read(const char *path, struct rows *r, struct failure *why) {
    FILE *in = whole_file_open(path);
    *r = (struct rows){0};
    if (!in) return refuse(why, STATUS_INPUT, "%.200s: %s; `heatladder case` writes it", path, whole_file_error());
    int status = rows_read(in, path, r, why);
    fclose(in);
    return status;
}

/* Whether two values are the same numbers, to 1e-9, and words. */
static int is_same(const char *a, const char *b) {
    struct rows_cell of[2][ROWS_CELLS];
    struct failure ignored;
    int n = rows_split(&(struct rows){0}, &(struct rows_line){a, 0}, ',', of[0], &ignored);
    if (n != rows_split(&(struct rows){0}, &(struct rows_line){b, 0}, ',', of[1], &ignored)) return 0;
    for (int i = 0; i < n; i++) {
        double x[2];
        int words = 0;
        for (int k = 0; k < 2; k++) words += number_read_printed(of[k][i].text, of[k][i].length, &x[k]) != 0;
        if (words ? of[0][i].length != of[1][i].length || memcmp(of[0][i].text, of[1][i].text, of[0][i].length)
                  : !(fabs(x[0] - x[1]) <= 1e-9 * fabs(x[0])))
            return 0;
    }
    return 1;
}

int case_file_compare(const struct rows *kept, char *text, const char *but, struct failure *why) {
    static const char own[] = "label threads dt fourier seed oracle";
    struct rows asked;
    int status = rows_of(text, "case", &asked, why);
    for (size_t i = 0; i < asked.count && !status; i++) {
        char key[80];
        long line;
        snprintf(key, sizeof key, "%.*s", (int)strcspn(asked.line[i].text, " ="), asked.line[i].text);
        if (words_among(own, key) || strcmp(key, but) == 0) continue;
        const char *value = case_file_value(&asked, key, NULL), *other = case_file_value(kept, key, &line);
        if (other && !is_same(value, other))
            status = refuse(why, STATUS_INPUT,
                            "%.200s, line %ld: %s = %.40s, where this command has %.40s: the answer beside it is of "
                            "another case",
                            kept->name, line, key, other, value);
    }
    rows_free(&asked);
    return status;
}
