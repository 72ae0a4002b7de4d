/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sentences for faults. */
#include "verification/fault/wording.h"

#include "solver/words.h"
#include "verification/fault/diagnosis.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const axes[] = {"x", "y", "z"};
static const char *const pairs[] = {"x and y", "y and z", "x and z"};
static const char *const k_pairs[] = {"k_x and k_y", "k_y and k_z", "k_x and k_z"};
static const char *const others[] = {"k_x were k_y", "k_y were k_x", "k_z were k_x",
                                     "k_x were k_z", "k_y were k_z", "k_z were k_y"};
static const char *const across[] = {" across x", " across y", " across z", " across x and y", " across x, y and z"};
static const char *const along[] = {" along x", " along y", " along z"};
static const char *const materials[] = {"first", "second"};
static const char *const sides[] = {"side x_lo holds",         "side x_hi holds", "side y_lo holds",
                                    "side y_hi holds",         "side z_lo holds", "side z_hi holds",
                                    "sides of given flux hold"};
static const char *const walls[] = {"the walls were those", "side x_lo were that", "side x_hi were that",
                                    "side y_lo were that",  "side y_hi were that", "side z_lo were that",
                                    "side z_hi were that"};
static const char *const cooled[] = {
    " of side x_lo", " of side x_hi", " of side y_lo", " of side y_hi", " of side z_lo", " of side z_hi", "s"};
static const char *const corners[] = {
    "the corner x_lo, y_lo",       "the corner x_hi, y_lo",       "the corner x_lo, y_hi",
    "the corner x_hi, y_hi",       "the corner x_lo, y_lo, z_lo", "the corner x_hi, y_lo, z_lo",
    "the corner x_lo, y_hi, z_lo", "the corner x_hi, y_hi, z_lo", "the corner x_lo, y_lo, z_hi",
    "the corner x_hi, y_lo, z_hi", "the corner x_lo, y_hi, z_hi", "the corner x_hi, y_hi, z_hi",
    "the edge y_lo, z_lo",         "the edge y_hi, z_lo",         "the edge y_lo, z_hi",
    "the edge y_hi, z_hi",         "the edge x_lo, z_lo",         "the edge x_hi, z_lo",
    "the edge x_lo, z_hi",         "the edge x_hi, z_hi",         "the edge x_lo, y_lo",
    "the edge x_hi, y_lo",         "the edge x_lo, y_hi",         "the edge x_hi, y_hi"};
static const char *const laws[] = {"were that of the initial temperature",
                                   "were that of the reference temperature",
                                   "were that of side x_lo",
                                   "were that of side x_hi",
                                   "were that of side y_lo",
                                   "were that of side y_hi",
                                   "had harmonic or geometric means, which let no heat into a cell with k = 0"};
static const char *const means[] = {"the arithmetic mean", "the geometric mean", "the arithmetic or geometric mean",
                                    "another mean"};

/* {size}: absolute value, in {unit} or as the text states.  {way}: `below` if the size is negative, `above`
 * otherwise; without these words "small" and "large".  {name}: the name of the fault's axis, `any` for FAULT_ANY. */
static const struct {
    const char *text;
    const char *const *names;
    const char *any;
    const char *below, *above;
} wordings[] = {
    [FAULT_CLOCK] = {"as if the run had stopped {size} {unit} {way}", NULL, NULL, "early", "late"},
    [FAULT_CONDUCTIVITY] = {.text = "as if the conductivity were {size} % too {way}"},
    [FAULT_SWAP] = {"as if {name} were in each other's place", k_pairs, "two conductivities", NULL, NULL},
    [FAULT_ISOTROPIC] = {"as if {name}", others, NULL, NULL, NULL},
    [FAULT_TRANSPOSED] = {"as if {name} were swapped", pairs, "two axes", NULL, NULL},
    [FAULT_SOURCE] = {.text = "as if the source were {size} % too {way}"},
    [FAULT_SOURCE_TIME] = {"as if the source were that of {size} {unit} {way}", NULL, NULL, "earlier", "later"},
    [FAULT_FROZEN] = {.text = "as if the source kept its first value"},
    [FAULT_WALL_TIME] = {"as if {name} of {size} {unit} {way}", walls, "the walls were those", "earlier", "later"},
    [FAULT_WALL_SWING] = {.text = "as if the change of the walls in time were {size} % too {way}"},
    [FAULT_WALL_FROZEN] = {.text = "as if the walls kept their first values"},
    [FAULT_CAPACITY] = {.text = "as if rho c of the second material were that of the first"},
    [FAULT_DIFFUSIVITY] = {.text = "as if a mean of diffusivities stood for the mean of conductivities between two "
                                   "materials"},
    [FAULT_AXIS] = {"as if k_{name} were {size} % too {way}", axes, NULL, NULL, NULL},
    [FAULT_RHO_C] = {"as if rho c of the {name} material were {size} % too {way}", materials, NULL, NULL, NULL},
    [FAULT_COEFFICIENT] = {"as if the heat transfer coefficient{name} were {size} % too {way}", cooled, "s", NULL,
                           NULL},
    [FAULT_NEAR_WALL] = {.text =
                             "as if Robin walls took the temperature of the cell, half a cell inside, for that of "
                             "the wall"},
    [FAULT_WALL] = {"as if what {name} were {size} % too {way}", sides, "a side holds", NULL, NULL},
    [FAULT_CORNER] = {"as if {size} % of what sides hold were lost at {name}", corners, "a corner", NULL, NULL},
    [FAULT_EXTENT] = {"as if the sides{name} were {size} cells further {way}", across, "", "in", "out"},
    [FAULT_START_SHIFT] = {"as if the initial data were {size} cells too far {way}{name}", along, "", "down", "up"},
    [FAULT_START_WIDTH] = {"as if the jumps of the initial data were {size} cells further {way}{name}", along, "",
                           "in", "out"},
    [FAULT_SAMPLES] = {.text = "as if the initial data were values at the points, where means over cells are due"},
    [FAULT_INTERFACE] = {"as if the interface were {size} cells too far {way}", NULL, NULL, "down", "up"},
    [FAULT_LAW] = {"as if k(T) {name}", laws, "were that of another temperature", NULL, NULL},
    [FAULT_MEAN] = {"as if {name} of two conductivities stood for the harmonic one", means, "another mean", NULL,
                    NULL},
    [FAULT_AMPLITUDE] = {.text = "as if all temperatures were {size} % too {way}, or heat were gained everywhere"},
    [FAULT_OFFSET] = {"all temperatures are {size} K too {way}", NULL, NULL, "low", "high"},
    [FAULT_SOME_STEPS] = {"as if runs at some spacings had stopped one step {way}: `while (t < t_end)` with a sum of "
                          "rounded steps does so",
                          NULL, NULL, "early", "late"},
    [FAULT_NOISE] = {.text = "answers differ by {size} K from run to run: random numbers, threads or an unset "
                             "variable"},
    [FAULT_DIGITS] = {.text = "as if temperatures were rounded to {size} digits"},
    [FAULT_UNSTABLE] = {.text = "the run is unstable, up to {size} K: the time step is above its limit"},
};

/* The text of the table, except for sizes with another meaning. */
static const char *text_of(const struct diagnosis *d) {
    static const double ANOTHER = 300; /* %: beyond this, another value is more likely than a factor */
    int is_wall = d->fault.kind == FAULT_WALL, is_source = d->fault.kind == FAULT_SOURCE;
    if (d->is_pace) return "as if the conductivity, or the length of each step, were {size} % too {way}";
    if (d->fault.kind == FAULT_AMPLITUDE && d->size < 0)
        return "as if all temperatures were {size} % too {way}, or heat were lost everywhere";
    if (d->fault.kind == FAULT_CLOCK && d->unit[0] == 'd')
        return "as if the run had stopped {size} {unit} {way}: one step, if steps are of that length";
    if (d->fault.kind == FAULT_OFFSET && fabs(fabs(d->size) - 273.15) < 0.5)
        return "all temperatures are {size} K too {way}: degrees Celsius and kelvin are mixed";
    if (d->fault.kind == FAULT_SOURCE_TIME && strcmp(d->unit, "steps") == 0 && fabs(fabs(d->size) - 0.5) < 0.1)
        return d->size < 0 ? "as if the source were that of {size} steps earlier: of the step's start, not its middle"
                           : "as if the source were that of {size} steps later: of the step's end, not its middle";
    if (d->fault.kind == FAULT_WALL_TIME && strcmp(d->unit, "steps") == 0 && fabs(d->size + 0.5) < 0.1)
        return "as if {name} of {size} steps earlier: of the step's start in every stage";
    if ((is_wall || is_source) && fabs(d->size + 100) < 5)
        return is_wall ? "as if what {name} were lost" : "as if the source were lost";
    if ((is_wall || is_source) && fabs(d->size + 200) < 10)
        return is_wall ? "as if what {name} had the wrong sign" : "as if the source had the wrong sign";
    if (d->fault.kind == FAULT_COEFFICIENT && d->size < -95) return "as if cooled sides were insulated";
    if (d->fault.kind == FAULT_COEFFICIENT && d->size > ANOTHER)
        return "as if the heat transfer coefficient{name} were several times too large, or the sides held";
    if (is_wall && d->size > ANOTHER) return "as if what {name} were another value";
    return wordings[d->fault.kind].text;
}

void wording_fault(struct diagnosis *d) {
    const char *const *names = wordings[d->fault.kind].names;
    const char *below = wordings[d->fault.kind].below, *above = wordings[d->fault.kind].above;
    int axis = d->fault.axis;
    char size[24];
    snprintf(size, sizeof size, d->fault.kind == FAULT_OFFSET ? "%.5g" : "%.3g", fabs(d->size));
    d->what[0] = '\0';
    for (const char *at = text_of(d); *at; at++) {
        const char *part = (const char[]){*at, '\0'};
        if (strncmp(at, "{size}", 6) == 0) part = size;
        if (strncmp(at, "{unit}", 6) == 0)
            part = strcmp(size, "1") == 0 && strcmp(d->unit, "steps") == 0 ? "step" : d->unit;
        if (strncmp(at, "{name}", 6) == 0) part = axis < 0 ? wordings[d->fault.kind].any : names[axis];
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
