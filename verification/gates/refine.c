/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A ceiling bounds the error at the finest spacing.  k halvings multiply it by 2^-kP, P the order of the row: bands
 * begin half an order below it, 0.1 below the order in time (battery.def). */
#include "verification/gates/gates.h"

#include "solver/status.h"
#include "verification/text/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The list of numbers after that option in a command; NULL where there are fewer than two. */
static const char *list_after(const char *command, const char *option, size_t *letters) {
    const char *at = strstr(command, option);
    if (!at) return NULL;
    at += strlen(option);
    *letters = strcspn(at, " ");
    return memchr(at, ',', *letters) ? at : NULL;
}

/* The number of `letters` letters at `text`, over 2^halvings: 1/60 is 1/120. */
static void halve(const char *text, size_t letters, int halvings, FILE *out) {
    const char *slash = memchr(text, '/', letters);
    char below[40] = "1";
    double divisor = 1;
    size_t above = slash ? (size_t)(slash - text) : letters;
    if (slash) snprintf(below, sizeof below, "%.*s", (int)(letters - above - 1), slash + 1);
    number_read(below, &divisor);
    fprintf(out, ",%.*s/%.17g", (int)above, text, ldexp(divisor, halvings));
}

/* The command with so many rungs into `text`; by how many halvings it is finer. */
static int add_rungs(const char *command, int rungs, char *text, size_t size) {
    size_t letters;
    const char *list = list_after(command, "--dt ", &letters);
    int count = 1;
    if (!list) list = list_after(command, "--dx ", &letters);
    if (!list) return 0;
    const char *last = list;
    for (const char *c = list; c < list + letters; c++)
        if (*c == ',') count++, last = c + 1;
    if (count >= rungs) return 0;
    FILE *out = xcheck(fmemopen(text, size, "w"), size, 1);
    fprintf(out, "%.*s", (int)(list + letters - command), command);
    for (int k = 1; k <= rungs - count; k++) halve(last, (size_t)(list + letters - last), k, out);
    fprintf(out, "%s", list + letters);
    fclose(out);
    text[size - 1] = '\0';
    return rungs - count;
}

void refine_gates(struct gates *g, int rungs, double time_order) {
    static const double BELOW = 0.2, ABOVE = 0.5;
    char text[GATES_COMMAND];
    for (int i = 0; i < g->declared; i++) {
        struct gate *gate = &g->result[i].gate;
        int finer = rungs > 0 ? add_rungs(gate->command, rungs, text, sizeof text) : 0;
        if (finer) gates_retype(g, i, text), gate->ceiling *= pow(2, -finer * nearbyint(gate->lo + 0.5));
        if (time_order > 0 && strcmp(gate->measure, "slope_time") == 0)
            gate->lo = time_order - BELOW, gate->hi = time_order + ABOVE;
    }
}
