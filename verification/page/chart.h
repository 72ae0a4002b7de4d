/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_PAGE_CHART_H
#define HEATLADDER_VERIFICATION_PAGE_CHART_H

#include <stdio.h>

/* A chart of error against spacing as inline SVG, both axes logarithmic. */

enum { CHART_STYLES = 6 }; /* series at most */

struct chart_series {
    const char *name;
    int n;
    const double *x, *y; /* n each; points that are not positive are left out */
    const int *counts;   /* n, or NULL for all: 0 for a point that is drawn hollow */
};

struct chart {
    const char *title; /* also the text alternative */
    const char *x_label, *y_label;
    int count; /* series, each with a marker and dash of its own; the key is below; the first has the thickest line */
    const struct chart_series *series;
    double slope; /* of the reference line through the last point of the first series; NAN for none */
};

/* An open <svg> element of that size, px, on white; and a text in it, `how` its other attributes. */
void chart_open(FILE *out, const char *title, int width, int height);
void chart_label(FILE *out, double x, double y, const char *how, const char *text);

/* One <svg> element, coordinates in px. */
void chart_write(const struct chart *c, FILE *out);

#endif
