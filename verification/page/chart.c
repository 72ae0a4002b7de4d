/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Logarithmic axes by decades, a marker a series (Okabe and Ito's palette). */
#include "verification/page/chart.h"

#include "verification/page/html.h"

#include <math.h>

/* px; ROW of the key.  WIDTH leaves the text 11 px or more on a screen of 400. */
enum { WIDTH = 460, HEIGHT = 360, LEFT = 66, RIGHT = 20, TOP = 16, BOTTOM = 56, ROW = 22 };
enum { STYLES = CHART_STYLES };

static const char *const colour[STYLES] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};
static const char *const dash[STYLES] = {"none", "7 4", "2 3", "9 3 2 3", "4 4", "12 4"};

struct axes {
    double lo[2], hi[2]; /* log10 */
};

static int drawn(const struct chart_series *s, int i) {
    return isfinite(s->x[i]) && isfinite(s->y[i]) && s->x[i] > 0 && s->y[i] > 0;
}

static struct axes axes_of(const struct chart *c) {
    struct axes a = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int k = 0; k < c->count; k++)
        for (int i = 0; i < c->series[k].n; i++) {
            if (!drawn(&c->series[k], i)) continue;
            double at[2] = {log10(c->series[k].x[i]), log10(c->series[k].y[i])};
            for (int d = 0; d < 2; d++) a.lo[d] = fmin(a.lo[d], at[d]), a.hi[d] = fmax(a.hi[d], at[d]);
        }
    for (int d = 0; d < 2; d++) {
        if (!(a.lo[d] <= a.hi[d])) a.lo[d] = -1, a.hi[d] = 0; /* nothing to draw */
        a.lo[d] = d ? floor(a.lo[d]) : a.lo[d] - 0.15;
        a.hi[d] = d ? fmax(ceil(a.hi[d]), a.lo[d] + 1) : a.hi[d] + 0.15;
    }
    return a;
}

static double place_x(const struct axes *a, double x) {
    return LEFT + (log10(x) - a->lo[0]) / (a->hi[0] - a->lo[0]) * (WIDTH - LEFT - RIGHT);
}

static double place_y(const struct axes *a, double y) {
    return HEIGHT - BOTTOM - (log10(y) - a->lo[1]) / (a->hi[1] - a->lo[1]) * (HEIGHT - TOP - BOTTOM);
}

void chart_open(FILE *out, const char *title, int width, int height) {
    fprintf(out, "<svg viewBox=\"0 0 %d %d\" width=\"%d\" role=\"img\" style=\"font: 14px sans-serif\">\n", width,
            height, width);
    html_print(out, "<title>%s</title>\n", title);
    fprintf(out, "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n");
}

void chart_label(FILE *out, double x, double y, const char *how, const char *text) {
    fprintf(out, "<text x=\"%.1f\" y=\"%.1f\" %s>", x, y, how);
    html_text(out, text);
    fprintf(out, "</text>\n");
}

/* 1, 2, 5 times each power of ten within the range. */
static void put_ticks(FILE *out, const struct axes *a) {
    static const double step[] = {1, 2, 5};
    char text[32];
    int crowded = a->hi[0] - a->lo[0] > 2.3; /* decades: only powers of ten have a label */
    for (int e = (int)floor(a->lo[0]); e <= (int)ceil(a->hi[0]); e++)
        for (int k = 0; k < 3; k++) {
            double value = step[k] * pow(10, e), x = place_x(a, value);
            if (x < LEFT - 0.5 || x > WIDTH - RIGHT + 0.5) continue;
            fprintf(out, "<path d=\"M%.1f %dV%d\" stroke=\"#ddd\"/>\n", x, TOP, HEIGHT - BOTTOM);
            if (k && crowded) continue;
            snprintf(text, sizeof text, "%g", value);
            chart_label(out, x, HEIGHT - BOTTOM + 18, "text-anchor=\"middle\"", text);
        }
    int every = (int)ceil((a->hi[1] - a->lo[1]) / 8);
    for (int e = (int)a->lo[1]; e <= (int)a->hi[1]; e += every) {
        double y = place_y(a, pow(10, e));
        fprintf(out, "<path d=\"M%d %.1fH%d\" stroke=\"#ddd\"/>\n", LEFT, y, WIDTH - RIGHT);
        snprintf(text, sizeof text, "1e%d", e);
        chart_label(out, LEFT - 8, y + 4, "text-anchor=\"end\"", text);
    }
}

static void put_marker(FILE *out, int k, double x, double y, int hollow) {
    static const struct {
        const char *shape;
        double dx, dy; /* px: where it begins, beside its point */
    } marker[STYLES] = {{"<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4.5\"", 0, 0},
                        {"<rect x=\"%.1f\" y=\"%.1f\" width=\"8.4\" height=\"8.4\"", -4.2, -4.2},
                        {"<path d=\"M%.1f %.1fl5 9h-10z\"", 0, -5.5},
                        {"<path d=\"M%.1f %.1fl5 5.5l-5 5.5l-5 -5.5z\"", 0, -5.5},
                        {"<path d=\"M%.1f %.1fl5 -9h-10z\"", 0, 5.5},
                        {"<path d=\"M%.1f %.1fv9h5v-9z\"", -2.5, -4.5}};
    fprintf(out, marker[k].shape, x + marker[k].dx, y + marker[k].dy);
    fprintf(out, " fill=\"%s\" stroke=\"%s\" stroke-width=\"1.4\"/>\n", hollow ? "#fff" : colour[k], colour[k]);
}

static void put_series(FILE *out, const struct axes *a, const struct chart_series *s, int k) {
    int begun = 0;
    fprintf(out, "<path fill=\"none\" stroke=\"%s\" stroke-width=\"%g\" stroke-dasharray=\"%s\" d=\"", colour[k],
            k ? 1.4 : 2.6, dash[k]);
    for (int i = 0; i < s->n; i++) {
        if (!drawn(s, i)) continue;
        fprintf(out, "%c%.1f %.1f", begun ? 'L' : 'M', place_x(a, s->x[i]), place_y(a, s->y[i]));
        begun = 1;
    }
    fprintf(out, "\"/>\n");
    for (int i = 0; i < s->n; i++)
        if (drawn(s, i)) put_marker(out, k, place_x(a, s->x[i]), place_y(a, s->y[i]), s->counts && !s->counts[i]);
}

/* A line of the slope that is expected, a factor of three below the first series' finest point. */
static void put_slope(FILE *out, const struct axes *a, const struct chart *c) {
    const struct chart_series *s = &c->series[0];
    int finest = -1;
    char text[48];
    for (int i = 0; i < s->n; i++)
        if (drawn(s, i) && (finest < 0 || s->x[i] < s->x[finest])) finest = i;
    if (!isfinite(c->slope) || finest < 0) return;
    double x0 = s->x[finest], x1 = pow(10, a->hi[0] - 0.1), y0 = fmax(s->y[finest] / 3, pow(10, a->lo[1]));
    double y1 = y0 * pow(x1 / x0, c->slope), top = pow(10, a->hi[1]);
    if (y1 > top && c->slope > 0) y1 = top, x1 = x0 * pow(y1 / y0, 1 / c->slope);
    fprintf(out, "<path fill=\"none\" stroke=\"#555\" d=\"M%.1f %.1fL%.1f %.1f\"/>\n", place_x(a, x0), place_y(a, y0),
            place_x(a, x1), place_y(a, y1));
    snprintf(text, sizeof text, "slope %g", c->slope);
    chart_label(out, place_x(a, sqrt(x0 * x1)) + 8, place_y(a, sqrt(y0 * y1)) + 14, "fill=\"#555\"", text);
}

void chart_write(const struct chart *c, FILE *out) {
    struct axes a = axes_of(c);
    chart_open(out, c->title, WIDTH, HEIGHT + ROW * c->count);
    put_ticks(out, &a);
    fprintf(out, "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"none\" stroke=\"#333\"/>\n", LEFT, TOP,
            WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM);
    chart_label(out, WIDTH / 2.0, HEIGHT - 18, "text-anchor=\"middle\"", c->x_label);
    chart_label(out, 0, 0, "text-anchor=\"middle\" transform=\"translate(18 160) rotate(-90)\"", c->y_label);
    put_slope(out, &a, c);
    int shown = c->count < STYLES ? c->count : STYLES;
    for (int k = shown - 1; k >= 0; k--) put_series(out, &a, &c->series[k], k); /* the first is on top */
    for (int k = 0; k < shown; k++) {
        put_marker(out, k, LEFT + 8, HEIGHT + ROW * k, 0);
        chart_label(out, LEFT + 22, HEIGHT + ROW * k + 5, "", c->series[k].name);
    }
    fprintf(out, "</svg>\n");
}
