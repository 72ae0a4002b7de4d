/* Orders of accuracy, and tables of errors, against what is printed. */
#include "verification/claims/kit.h"
#include "verification/claims/measures.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Half the width of the band around an order: as in gates.def. */
static const double BAND = 0.1;

/* "label: rest" -> rest, the label cut off; the whole where there is none. */
static char *unlabel(char *part) {
    char *colon = strchr(part, ':');
    if (!colon) return part;
    *colon = '\0';
    return colon + 1;
}

/* "ORDER | label: ladder's words | label: ...": the first is the published setting. */
static void take_order(const char *argument, struct claims_measured *m) {
    char part[320];
    struct slope s;
    int held[2] = {1, 1}, setting = 0;
    claims_kit_part(&argument, part, sizeof part);
    double order = atof(part);
    for (; claims_kit_part(&argument, part, sizeof part); setting++) {
        const char *words = unlabel(part);
        if (claims_kit_slope(&s, m, "ladder %s", words)) return;
        claims_kit_number(m, s.value, "", "order %s", part);
        held[setting > 0] &= s.n >= 4 && order - BAND <= s.ci[0] && s.ci[1] <= order + BAND;
    }
    claims_kit_decide(m, held[0], held[1],
                      "the 95 %% interval of the slope must lie within %g +- %g in the first setting (as published) "
                      "and in the others, if any",
                      order, BAND);
}

/* "METHOD dx:E dx:E ...": leaves the method's name in *part; how many pairs there are. */
static int read_pairs(char *part, double *dx, double *E, const char **printed, int max) {
    char *rest = part + strcspn(part, " "), *at = NULL;
    int n = 0;
    if (*rest) *rest++ = '\0';
    for (char *word = strtok_r(rest, " ", &at); word && n < max; word = strtok_r(NULL, " ", &at)) {
        char *colon = strchr(word, ':');
        if (!colon) continue;
        dx[n] = atof(word);
        printed[n] = colon + 1;
        E[n++] = atof(colon + 1);
    }
    return n;
}

enum { COLUMNS = 8 };

/* "ORDER METHOD dx:E ... | ...": the slope of what is printed. */
static void take_printed_order(const char *argument, struct claims_measured *m) {
    char part[320];
    double dx[COLUMNS], E[COLUMNS];
    const char *printed[COLUMNS];
    int held = 1;
    while (claims_kit_part(&argument, part, sizeof part)) {
        double order = atof(part);
        char *method = part + strcspn(part, " ") + 1;
        int n = read_pairs(method, dx, E, printed, COLUMNS);
        double slope = slope_fit(dx, E, n).value;
        claims_kit_number(m, slope, "", "slope of %s", method);
        held &= fabs(slope - order) <= BAND;
    }
    claims_kit_decide(m, held, 1, "slope of the printed numbers within %g of the printed order", BAND);
}

/* Units of the last printed digit between the printed number and the measured one. */
static double units(const char *printed, double measured) {
    char *end;
    double value = strtod(printed, &end);
    const char *point = strchr(printed, '.'), *power = strchr(printed, 'e');
    double digits = point ? (double)((power ? power : end) - point - 1) : 0;
    return fabs(measured - value) / pow(10, (power ? atof(power + 1) : 0) - digits);
}

/* "scene and options | METHOD dx:E ... | METHOD dx:E ..." */
static void take_table(const char *argument, struct claims_measured *m) {
    char part[320], options[160];
    double dx[COLUMNS], E[COLUMNS], worst = 1;
    const char *printed[COLUMNS];
    claims_kit_part(&argument, options, sizeof options);
    const char *rest = strchr(options, ' ');
    int scene = (int)(rest - options), cells = 0, held = 0;
    while (claims_kit_part(&argument, part, sizeof part)) {
        int n = read_pairs(part, dx, E, printed, COLUMNS);
        for (int i = 0; i < n; i++, cells++) {
            struct claims_kit_run run;
            int bad = claims_kit_run(&run, m, "run %.*s %s%s --dx %.10g", scene, options, part, rest, dx[i]);
            double measured = run.result.error.l1, ratio = measured / E[i];
            claims_kit_free(&run);
            if (bad) return;
            int near = units(printed[i], measured) <= 1 || fabs(ratio - 1) <= 0.02;
            if (!near) claims_kit_number(m, ratio, "", "measured over printed, %s at dx = %g", part, dx[i]);
            if (!(units(printed[i], measured) <= 1) && !(fabs(ratio - 1) <= fabs(worst - 1))) worst = ratio;
            held += near;
        }
    }
    claims_kit_number(m, cells, "", "errors compared");
    claims_kit_number(m, held, "", "within 2 %% or a unit of the last digit");
    claims_kit_number(m, worst, "", "worst ratio of those more than a unit of the last digit off");
    claims_kit_decide(m, fabs(worst - 1) <= 0.10, held == cells,
                      "every error within 2 %% or one unit of its last digit; within 10 %% leaves a choice open");
}

const struct claims_measure claims_order_measures[] = {
    {"order", take_order}, {"printed_order", take_printed_order}, {"table", take_table}, {0}};
