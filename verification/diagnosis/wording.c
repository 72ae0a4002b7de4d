/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a diagnosis says. */
#include "verification/diagnosis/wording.h"

#include "verification/diagnosis/diagnosis.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *axis_name(int axis) {
    return axis == 0 ? "x" : axis == 1 ? "y" : "x and y";
}

void wording_fault(struct diagnosis *d) {
    static const char *const sides[] = {"side x_lo holds", "side x_hi holds", "side y_lo holds", "side y_hi holds",
                                        "sides of given flux hold"};
    static const char *const cooled[] = {" of side x_lo", " of side x_hi", " of side y_lo", " of side y_hi", "s"};
    static const double ANOTHER =
        300; /* %, past which a value near 0 or a lost condition is likelier than a factor */
    double size = d->size, apart = fabs(size);
    const char *much = size < 0 ? "small" : "large", *axis = axis_name(d->fault.axis);
    char *to = d->what;
    const size_t room = sizeof d->what;
    switch (d->fault.kind) {
    case FAULT_CLOCK:
        snprintf(to, room, "as if the run had stopped %.3g %s %s%s", apart, d->unit, size < 0 ? "early" : "late",
                 d->unit[0] == 'd' ? ": one step, if steps are of that length" : "");
        break;
    case FAULT_AXIS:
        snprintf(to, room, "as if k_%s were %.3g %% too %s", axis_name(d->fault.axis), apart, much);
        break;
    case FAULT_RHO_C:
        snprintf(to, room, "as if rho c of the %s material were %.3g %% too %s", d->fault.axis ? "second" : "first",
                 apart, much);
        break;
    case FAULT_COEFFICIENT:
        snprintf(to, room, "as if the heat transfer coefficient%s were %.3g %% too %s", cooled[d->fault.axis], apart,
                 much);
        break;
    case FAULT_CONDUCTIVITY:
        snprintf(to, room, "as if the conductivity were %.3g %% too %s", apart, much);
        break;
    case FAULT_SWAP:
        snprintf(to, room, "as if k_x and k_y were in each other's place");
        break;
    case FAULT_ISOTROPIC:
        snprintf(to, room, "as if k_%s were k_%s", axis_name(d->fault.axis), axis_name(1 - d->fault.axis));
        break;
    case FAULT_TRANSPOSED:
        snprintf(to, room, "as if x and y were swapped");
        break;
    case FAULT_CORNER:
        snprintf(to, room, "as if %.3g %% of what sides hold were lost at a corner, %s, %s", apart,
                 d->fault.axis & 1 ? "x_hi" : "x_lo", d->fault.axis & 2 ? "y_hi" : "y_lo");
        break;
    case FAULT_MEAN:
        snprintf(to, room, "as if the arithmetic mean of two conductivities stood for the harmonic one");
        break;
    case FAULT_SOURCE:
        snprintf(to, room,
                 fabs(size + 100) < 5    ? "as if the source were lost"
                 : fabs(size + 200) < 10 ? "as if the source had the wrong sign"
                                         : "as if the source were %.3g %% too %s",
                 apart, much);
        break;
    case FAULT_SOURCE_TIME:
        snprintf(to, room, "as if the source were that of %.3g %s %s", apart, d->unit,
                 size < 0 ? "earlier" : "later");
        break;
    case FAULT_CAPACITY:
        snprintf(to, room, "as if rho c of the second material were that of the first");
        break;
    case FAULT_WALL:
        if (fabs(size + 100) < 5)
            snprintf(to, room, "as if what %s were lost", sides[d->fault.axis]);
        else if (fabs(size + 200) < 10)
            snprintf(to, room, "as if what %s had the wrong sign", sides[d->fault.axis]);
        else if (size > ANOTHER)
            snprintf(to, room, "as if what %s were another value", sides[d->fault.axis]);
        else
            snprintf(to, room, "as if what %s were %.3g %% too %s", sides[d->fault.axis], apart, much);
        break;
    case FAULT_EXTENT:
        snprintf(to, room, "as if the sides across %s lay %.3g cells %s", axis, apart,
                 size < 0 ? "inside" : "outside");
        break;
    case FAULT_START_SHIFT:
        snprintf(to, room, "as if the initial data lay %.3g cells too far %s along %s", apart,
                 size < 0 ? "down" : "up", axis);
        break;
    case FAULT_START_WIDTH:
        snprintf(to, room, "as if the jumps of the initial data lay %.3g cells %s along %s", apart,
                 size < 0 ? "inwards" : "outwards", axis);
        break;
    case FAULT_SAMPLES:
        snprintf(to, room, "as if the initial data were values at the points, where means over cells are due");
        break;
    case FAULT_INTERFACE:
        snprintf(to, room, "as if the interface lay %.3g cells too far %s", apart, size < 0 ? "down" : "up");
        break;
    case FAULT_AMPLITUDE:
        snprintf(to, room, "as if all temperatures were %.3g %% too %s", apart, much);
        break;
    }
}

void wording_text(const struct diagnosis *d, char *text, size_t size) {
    if (d->named && isfinite(d->share))
        snprintf(text, size, "%s (%.0f %% of the error)", d->what, 100 * d->share);
    else
        snprintf(text, size, "%s", d->what);
}

/* Where the size stands in a text, and letters of the sentence, which the share follows. */
static const char *size_in(const char *text, size_t *letters) {
    const char *share = strstr(text, " (");
    *letters = share ? (size_t)(share - text) : strlen(text);
    const char *digit = text + strcspn(text, "0123456789");
    return digit < text + *letters ? digit : text + *letters;
}

static double size_of(const char *text) {
    size_t letters;
    const char *at = size_in(text, &letters);
    return at < text + letters ? strtod(at, NULL) : 0;
}

/* `text` without " and y": what is wrong along x and y looks in a rod as if along x. */
static void along_x(const char *text, char out[WORDING_ALL]) {
    const char *both = strstr(text, "x and y ");
    int letters = both ? (int)(both - text) + 1 : (int)strlen(text);
    snprintf(out, WORDING_ALL, "%.*s%s", letters, text, both ? both + 7 : "");
}

static const char COEFFICIENT[] = "heat transfer coefficient", OF_SIDE[] = " of side x_lo";

/* The coefficient of one side as that of all: a rod has one that is cooled, and a draw may mirror it. */
static void of_all_sides(const char *text, char out[WORDING_ALL]) {
    const char *at = strstr(text, COEFFICIENT), *end = at ? at + strlen(COEFFICIENT) : text + strlen(text);
    int one = strncmp(end, OF_SIDE, strlen(" of side ")) == 0;
    snprintf(out, WORDING_ALL, "%.*s%s%s", (int)(end - text), text, one ? "s" : "",
             one ? end + strlen(OF_SIDE) : end);
}

static int same_fault(const char *said, const char *of) {
    char a[WORDING_ALL], b[WORDING_ALL], general[WORDING_ALL];
    size_t m, n;
    along_x(said, general), of_all_sides(general, a);
    along_x(of, general), of_all_sides(general, b);
    const char *x = size_in(a, &m), *y = size_in(b, &n);
    if (x - a != y - b || strncmp(a, b, (size_t)(x - a)) != 0) return 0;
    x += strspn(x, "0123456789.e+-"), y += strspn(y, "0123456789.e+-");
    return a + m - x == b + n - y && strncmp(x, y, (size_t)(a + m - x)) == 0;
}

/* The first of those that most say. */
static int most_named(const char *const text[], int count, int *votes) {
    int best = -1;
    *votes = 0;
    for (int i = 0; i < count; i++) {
        int same = 0;
        for (int k = 0; k < count; k++) same += same_fault(text[i], text[k]);
        if (*text[i] && same > *votes) best = i, *votes = same;
    }
    return best;
}

/* Of those that say what the best says the one that has half of the others' sizes below its own. */
static int middle(const char *const text[], int count, int best, int votes) {
    for (int i = 0; i < count; i++) {
        int below = 0;
        if (!same_fault(text[i], text[best])) continue;
        for (int k = 0; k < count; k++) {
            double size = size_of(text[k]) - size_of(text[i]);
            below += same_fault(text[k], text[best]) && (size < 0 || (size == 0 && k < i));
        }
        if (below == (votes - 1) / 2) return i;
    }
    return best;
}

/* Whether those that name the coefficient name one side. */
static int one_side(const char *const text[], int count, const char *what) {
    const char *side = strstr(what, COEFFICIENT);
    for (int i = 0; side && i < count; i++) {
        const char *other = strstr(text[i], COEFFICIENT);
        if (other && strncmp(other, side, strlen(COEFFICIENT) + strlen(OF_SIDE)) != 0) return 0;
    }
    return 1;
}

/* 1 where at least half of those that name a fault name that one, and of the same size to 20 %: but for runs that
 * differ, by as much as each field makes of it. */
static int agree(const char *const text[], int count, const char *what) {
    static const double SAME = 0.2;
    int named = 0, same = 0;
    int noise = strncmp(what, "as if", 5) != 0;
    double size = size_of(what);
    for (int i = 0; i < count; i++) {
        named += *text[i] != '\0';
        same += same_fault(text[i], what) && (noise || fabs(size_of(text[i]) - size) <= SAME * fabs(size));
    }
    return 2 * same >= named;
}

void wording_all(const char *const text[], int count, char *all, size_t size) {
    int votes, best = most_named(text, count, &votes);
    size_t letters;
    *all = '\0';
    if (best < 0) return;
    char what[WORDING_ALL];
    const char *chosen = text[middle(text, count, best, votes)];
    if (one_side(text, count, chosen))
        snprintf(what, sizeof what, "%s", chosen);
    else
        of_all_sides(chosen, what);
    size_in(what, &letters);
    snprintf(all, size, "%s%.*s (%d of %d gates that do not hold)", agree(text, count, what) ? "" : "perhaps ",
             (int)letters, what, votes, count);
}
