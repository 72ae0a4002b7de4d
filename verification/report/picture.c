/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures of a row that does not hold. */
#include "verification/report/picture.h"

#include "solver/field.h"
#include "solver/status.h"
#include "verification/gates/gates.h"
#include "verification/text/html.h"

#include <ctype.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>

/* The plot within a panel, in units of the SVG; text is 13 high. */
enum { WIDE = 340, HIGH = 240, LEFT = 66, RIGHT = 14, TOP = 26, BOTTOM = 40, POINTS_MOST = 4000, CROWD = 100 };

struct axis {
    double lo, hi; /* the data, or their logarithms to base 10 */
    int logarithmic;
};

static struct axis axis_none(int logarithmic) {
    return (struct axis){DBL_MAX, -DBL_MAX, logarithmic};
}

static double on_axis(const struct axis *a, double value) {
    return a->logarithmic ? log10(value) : value;
}

static void widen(struct axis *a, double value) {
    double v = on_axis(a, value);
    if (!isfinite(v)) return;
    a->lo = fmin(a->lo, v);
    a->hi = fmax(a->hi, v);
}

/* A margin on both sides; an axis of one value gets a width. */
static void relax_ends(struct axis *a) {
    double margin = a->hi > a->lo                        ? 0.06 * (a->hi - a->lo)
                    : fabs(a->lo) > 0 && !a->logarithmic ? 0.1 * fabs(a->lo)
                                                         : 0.5;
    a->lo -= margin;
    a->hi += margin;
}

/* A margin of half a cell, of so many along the axis. */
static void relax_by_cell(struct axis *a, double cells) {
    double margin = 0.55 * (a->hi - a->lo) / fmax(cells - 1.1, 1);
    a->lo -= margin;
    a->hi += margin;
}

static double x_of(const struct axis *a, double value) {
    return LEFT + (on_axis(a, value) - a->lo) / (a->hi - a->lo) * (WIDE - LEFT - RIGHT);
}

static double y_of(const struct axis *a, double value) {
    return HIGH - BOTTOM - (on_axis(a, value) - a->lo) / (a->hi - a->lo) * (HIGH - TOP - BOTTOM);
}

static void open_panel(FILE *out, const char *title) {
    html_print(out,
               "<svg class=\"panel\" viewBox=\"0 0 340 240\" width=\"340\" role=\"img\" font-size=\"13\" "
               "fill=\"currentColor\">\n<title>%s</title>\n<text x=\"66\" y=\"16\">%s</text>\n",
               title, title);
}

static double power(double exponent, int logarithmic) {
    return logarithmic ? pow(10, exponent) : exponent;
}

/* The frame, and the values at both ends of each axis. */
static void put_frame(FILE *out, const struct axis *x, const struct axis *y, const char *below, const char *beside) {
    int right = WIDE - RIGHT, floor = HIGH - BOTTOM;
    fprintf(out, "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"none\" stroke=\"currentColor\"/>\n", LEFT,
            TOP, right - LEFT, floor - TOP);
    fprintf(out, "<text x=\"%d\" y=\"%d\">%.3g</text><text x=\"%d\" y=\"%d\" text-anchor=\"end\">%.3g</text>\n", LEFT,
            floor + 16, power(x->lo, x->logarithmic), right, floor + 16, power(x->hi, x->logarithmic));
    fprintf(out, "<text x=\"%d\" y=\"%d\" text-anchor=\"end\">%.3g</text>", LEFT - 4, floor,
            power(y->lo, y->logarithmic));
    fprintf(out, "<text x=\"%d\" y=\"%d\" text-anchor=\"end\">%.3g</text>\n", LEFT - 4, TOP + 10,
            power(y->hi, y->logarithmic));
    html_print(out, "<text x=\"196\" y=\"232\" text-anchor=\"middle\">%s</text>", below);
    html_print(out, "<text transform=\"translate(14 120) rotate(-90)\" text-anchor=\"middle\">%s</text>\n", beside);
}

void picture_ladder(FILE *out, const struct rungs *l, const struct gate *gate) {
    struct axis x = axis_none(1), y = axis_none(1);
    int finest = l->n - 1, banded = gate->lo > 0 && isfinite(gate->hi) && l->n > 1 && l->error[0] > 0;
    double due[2] = {NAN, NAN};
    if (l->n < 2) return;
    for (int k = 0; k < 2 && banded; k++)
        due[k] = l->error[0] * pow(l->x[finest] / l->x[0], k ? gate->hi : gate->lo), widen(&y, due[k]);
    for (int i = 0; i < l->n; i++) widen(&x, l->x[i]), widen(&y, l->error[i]);
    if (isfinite(gate->ceiling)) widen(&y, gate->ceiling);
    if (!(y.hi >= y.lo)) return;
    relax_ends(&x), relax_ends(&y);
    open_panel(out, banded ? "The ladder, and the band of its slope" : "The ladder");
    if (banded) /* between the slopes lo and hi from the coarsest rung */
        fprintf(out, "<polygon points=\"%.1f,%.1f %.1f,%.1f %.1f,%.1f\" fill=\"#0072b2\" fill-opacity=\"0.2\"/>\n",
                x_of(&x, l->x[0]), y_of(&y, l->error[0]), x_of(&x, l->x[finest]), y_of(&y, due[0]),
                x_of(&x, l->x[finest]), y_of(&y, due[1]));
    if (isfinite(gate->ceiling))
        fprintf(out,
                "<line x1=\"%d\" x2=\"%d\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"#d55e00\" stroke-dasharray=\"6 3\"/>\n"
                "<text x=\"%d\" y=\"%.1f\" text-anchor=\"end\" fill=\"#d55e00\">ceiling</text>\n",
                LEFT, WIDE - RIGHT, y_of(&y, gate->ceiling), y_of(&y, gate->ceiling), WIDE - RIGHT - 4,
                y_of(&y, gate->ceiling) - 4);
    for (int i = 0; i < l->n; i++)
        if (isfinite(l->error[i]) && l->error[i] > 0)
            fprintf(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" stroke=\"currentColor\" fill=\"%s\"/>\n",
                    x_of(&x, l->x[i]), y_of(&y, l->error[i]), l->counts[i] ? "currentColor" : "none");
    put_frame(out, &x, &y, l->axis, l->norm);
    fprintf(out, "</svg>\n");
}

/* ---- Fields ---- */

/* The points that are drawn: all of a rod or a plane, in space those of the layer nearest the middle; evenly thinned.
 */
static size_t choose(const struct field *f, size_t *chosen) {
    double x[DIM_MAX], lo = DBL_MAX, hi = -DBL_MAX, layer = DBL_MAX;
    size_t n = 0;
    for (size_t i = 0; i < f->n; i++) lo = fmin(lo, field_place(f, i, x)[2]), hi = fmax(hi, x[2]);
    double middle = (lo + hi) / 2;
    for (size_t i = 0; i < f->n; i++)
        if (fabs(field_place(f, i, x)[2] - middle) < fabs(layer - middle)) layer = x[2];
    for (size_t i = 0; i < f->n; i++)
        if (f->dim < 3 || fabs(field_place(f, i, x)[2] - layer) <= 1e-9 * (hi - lo)) chosen[n++] = i;
    size_t every = 1 + n / POINTS_MOST, kept = 0;
    for (size_t k = 0; k < n; k += every) chosen[kept++] = chosen[k];
    return kept;
}

static double difference(const struct measured *m, size_t i) {
    return m->field.T[i] - m->due[i];
}

static void put_profile(FILE *out, const struct measured *m, const size_t *at, size_t n, int apart) {
    struct axis x = axis_none(0), y = axis_none(0);
    const struct field *f = &m->field;
    char title[100], beside[60];
    for (size_t k = 0; k < n; k++) {
        widen(&x, f->x[0][at[k]]);
        widen(&y, apart ? difference(m, at[k]) : f->T[at[k]]);
        if (!apart) widen(&y, m->due[at[k]]);
    }
    if (!(y.hi >= y.lo)) return;
    if (apart && m->due_scale > 0) widen(&y, -m->due_scale), widen(&y, m->due_scale);
    relax_ends(&x), relax_ends(&y);
    snprintf(title, sizeof title, apart ? "T less %s" : "T (dots), %s (crosses)", m->due_is);
    snprintf(beside, sizeof beside, apart ? "T - %s [K]" : "T [K]", m->due_is);
    open_panel(out, title);
    double r = n > CROWD ? 1.2 : 2.5;
    for (size_t k = 0; k < n; k++) {
        double here = x_of(&x, f->x[0][at[k]]), value = apart ? difference(m, at[k]) : f->T[at[k]];
        if (isfinite(value))
            fprintf(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%g\" fill=\"#d55e00\"/>", here, y_of(&y, value), r);
        if (!apart && isfinite(m->due[at[k]]))
            fprintf(out, "<path d=\"M%.1f %.1fl%g %gm0 %gl%g %g\" stroke=\"#0072b2\"/>", here - r,
                    y_of(&y, m->due[at[k]]) - r, 2 * r, 2 * r, -2 * r, -2 * r, 2 * r);
    }
    put_frame(out, &x, &y, "x [m]", beside);
    fprintf(out, "</svg>\n");
}

/* Dark blue to yellow, which also differ in lightness; a difference from blue over white to red. */
static void put_colour(FILE *out, double share, int diverging) {
    double s = fmin(1, fmax(0, share)), away = 2 * fabs(s - 0.5);
    if (!diverging)
        fprintf(out, "#%02x%02x%02x", (unsigned)(13 + 240 * s * s), (unsigned)(20 + 212 * s),
                (unsigned)(110 + 60 * s - 140 * s * s));
    else if (s < 0.5)
        fprintf(out, "#%02x%02xff", (unsigned)(255 - 235 * away), (unsigned)(255 - 155 * away));
    else
        fprintf(out, "#ff%02x%02x", (unsigned)(255 - 165 * away), (unsigned)(255 - 255 * away));
}

static void put_map(FILE *out, const struct field *f, const double *value, const size_t *at, size_t n, int diverging,
                    const char *title, const double range[2]) {
    struct axis x = axis_none(0), y = axis_none(0);
    char label[120], below[60] = "x [m]";
    double largest = fmax(fabs(range[0]), fabs(range[1])), lo = diverging ? -largest : range[0];
    double hi = diverging ? largest : range[1], place[DIM_MAX];
    for (size_t k = 0; k < n; k++) field_place(f, at[k], place), widen(&x, place[0]), widen(&y, place[1]);
    if (!(x.hi > x.lo && y.hi > y.lo)) return;
    double columns = sqrt((double)n * (x.hi - x.lo) / (y.hi - y.lo)), rows = (double)n / columns;
    relax_by_cell(&x, columns), relax_by_cell(&y, rows);
    double wide = 1.1 * (WIDE - LEFT - RIGHT) / columns, high = 1.1 * (HIGH - TOP - BOTTOM) / rows;
    snprintf(label, sizeof label, "%s: %.3g to %.3g K", title, range[0], range[1]);
    open_panel(out, label);
    for (size_t k = 0; k < n; k++) {
        field_place(f, at[k], place);
        if (!isfinite(value[at[k]])) continue;
        fprintf(out, "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"",
                x_of(&x, place[0]) - wide / 2, y_of(&y, place[1]) - high / 2, wide, high);
        put_colour(out, hi > lo ? (value[at[k]] - lo) / (hi - lo) : 0.5, diverging);
        fprintf(out, "\"/>");
    }
    if (f->dim == 3) snprintf(below, sizeof below, "x [m], at z = %.3g m", place[2]);
    put_frame(out, &x, &y, below, "y [m]");
    fprintf(out, "</svg>\n");
}

static void put_maps(FILE *out, const struct measured *m, const size_t *at, size_t n) {
    const struct field *f = &m->field;
    const double *due = m->due, room = m->due_scale > 0 ? m->due_scale : -DBL_MAX;
    double *apart = xcalloc(f->n, sizeof *apart), range[2] = {DBL_MAX, -DBL_MAX}, gap[2] = {-room, room};
    char title[60], less[60];
    snprintf(title, sizeof title, "%c%s", toupper((unsigned char)m->due_is[0]), m->due_is + 1);
    snprintf(less, sizeof less, "T less %s", m->due_is);
    for (size_t i = 0; i < f->n; i++) apart[i] = difference(m, i);
    for (size_t k = 0; k < n; k++) {
        if (!isfinite(apart[at[k]])) continue;
        range[0] = fmin(range[0], fmin(f->T[at[k]], due[at[k]]));
        range[1] = fmax(range[1], fmax(f->T[at[k]], due[at[k]]));
        gap[0] = fmin(gap[0], apart[at[k]]), gap[1] = fmax(gap[1], apart[at[k]]);
    }
    if (range[1] >= range[0]) {
        put_map(out, f, f->T, at, n, 0, "T", range);
        put_map(out, f, due, at, n, 0, title, range);
        put_map(out, f, apart, at, n, 1, less, gap);
    }
    free(apart);
}

void picture_field(FILE *out, const struct measured *m) {
    size_t *at = xcalloc(m->field.n + 1, sizeof *at), n = choose(&m->field, at);
    if (m->field.dim == 1) {
        put_profile(out, m, at, n, 0);
        put_profile(out, m, at, n, 1);
    } else {
        put_maps(out, m, at, n);
    }
    free(at);
}
