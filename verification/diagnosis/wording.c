/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a diagnosis says. */
#include "verification/diagnosis/wording.h"

#include "verification/diagnosis/diagnosis.h"
#include "verification/text/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const axes[] = {"x", "y", "x and y"};
static const char *const materials[] = {"first", "second"};
static const char *const sides[] = {"side x_lo holds", "side x_hi holds", "side y_lo holds", "side y_hi holds",
                                    "sides of given flux hold"};
static const char *const cooled[] = {" of side x_lo", " of side x_hi", " of side y_lo", " of side y_hi", "s"};
static const char *const corners[] = {"x_lo, y_lo", "x_hi, y_lo", "x_lo, y_hi", "x_hi, y_hi"};

/* What comes after "as if".  {size}: without its sign, in {unit} or as the text says; {way}: `below` of a size below
 * 0, else `above`, where none is given "small" and "large"; {name}: that of the fault's axis, {other} that of the
 * other axis. */
static const struct {
    const char *text;
    const char *const *names;
    const char *below, *above;
} wordings[] = {
    [FAULT_CLOCK] = {"the run had stopped {size} {unit} {way}", NULL, "early", "late"},
    [FAULT_CONDUCTIVITY] = {.text = "the conductivity were {size} % too {way}"},
    [FAULT_SWAP] = {.text = "k_x and k_y were in each other's place"},
    [FAULT_ISOTROPIC] = {"k_{name} were k_{other}", axes, NULL, NULL},
    [FAULT_TRANSPOSED] = {.text = "x and y were swapped"},
    [FAULT_SOURCE] = {.text = "the source were {size} % too {way}"},
    [FAULT_SOURCE_TIME] = {"the source were that of {size} {unit} {way}", NULL, "earlier", "later"},
    [FAULT_CAPACITY] = {.text = "rho c of the second material were that of the first"},
    [FAULT_AXIS] = {"k_{name} were {size} % too {way}", axes, NULL, NULL},
    [FAULT_RHO_C] = {"rho c of the {name} material were {size} % too {way}", materials, NULL, NULL},
    [FAULT_COEFFICIENT] = {"the heat transfer coefficient{name} were {size} % too {way}", cooled, NULL, NULL},
    [FAULT_WALL] = {"what {name} were {size} % too {way}", sides, NULL, NULL},
    [FAULT_CORNER] = {"{size} % of what sides hold were lost at a corner, {name}", corners, NULL, NULL},
    [FAULT_EXTENT] = {"the sides across {name} lay {size} cells {way}", axes, "inside", "outside"},
    [FAULT_START_SHIFT] = {"the initial data lay {size} cells too far {way} along {name}", axes, "down", "up"},
    [FAULT_START_WIDTH] = {"the jumps of the initial data lay {size} cells {way} along {name}", axes, "inwards",
                           "outwards"},
    [FAULT_SAMPLES] = {.text = "the initial data were values at the points, where means over cells are due"},
    [FAULT_INTERFACE] = {"the interface lay {size} cells too far {way}", NULL, "down", "up"},
    [FAULT_MEAN] = {.text = "the arithmetic mean of two conductivities stood for the harmonic one"},
    [FAULT_AMPLITUDE] = {.text = "all temperatures were {size} % too {way}"},
};

/* That of the table, but for the sizes that mean something else. */
static const char *text_of(const struct diagnosis *d) {
    static const double ANOTHER =
        300; /* %, past which a value near 0 or a lost condition is likelier than a factor */
    int is_wall = d->fault.kind == FAULT_WALL, is_source = d->fault.kind == FAULT_SOURCE;
    if (d->fault.kind == FAULT_CLOCK && d->unit[0] == 'd')
        return "the run had stopped {size} {unit} {way}: one step, if steps are of that length";
    if ((is_wall || is_source) && fabs(d->size + 100) < 5)
        return is_wall ? "what {name} were lost" : "the source were lost";
    if ((is_wall || is_source) && fabs(d->size + 200) < 10)
        return is_wall ? "what {name} had the wrong sign" : "the source had the wrong sign";
    if (is_wall && d->size > ANOTHER) return "what {name} were another value";
    return wordings[d->fault.kind].text;
}

void wording_fault(struct diagnosis *d) {
    const char *const *names = wordings[d->fault.kind].names;
    const char *below = wordings[d->fault.kind].below, *above = wordings[d->fault.kind].above;
    char size[24];
    snprintf(size, sizeof size, "%.3g", fabs(d->size));
    snprintf(d->what, sizeof d->what, "as if ");
    for (const char *at = text_of(d); *at; at++) {
        const char *part = (const char[]){*at, '\0'};
        if (strncmp(at, "{size}", 6) == 0) part = size;
        if (strncmp(at, "{unit}", 6) == 0) part = d->unit;
        if (strncmp(at, "{name}", 6) == 0) part = names[d->fault.axis];
        if (strncmp(at, "{other}", 7) == 0) part = names[1 - d->fault.axis];
        if (strncmp(at, "{way}", 5) == 0) part = d->size < 0 ? (below ? below : "small") : above ? above : "large";
        words_add(d->what, sizeof d->what, "%s", part);
        if (*at == '{') at += strcspn(at, "}");
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
