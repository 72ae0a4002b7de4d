/* Orders of accuracy, and tables of errors, against what is printed. */
#include "verification/claims/kit.h"

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

/* "ORDER TABLE METHOD | ...": the slope of what is printed (reports/published). */
static void take_printed_order(const char *argument, struct claims_measured *m) {
    char part[80], name[40], method[24];
    double order, dx[PUBLISHED_COLUMNS];
    int held = 1;
    while (claims_kit_part(&argument, part, sizeof part)) {
        struct published t;
        if (sscanf(part, "%lf %39s %23s", &order, name, method) != 3 || claims_kit_published(&t, m, name)) return;
        int row = published_row(&t, method);
        for (int i = 0; i < t.columns; i++) dx[i] = atof(t.where[i]);
        double slope = row < 0 ? NAN : slope_fit(dx, t.value[row], t.columns).value;
        claims_kit_number(m, slope, "", "slope of %s %s", name, method);
        held &= fabs(slope - order) <= BAND;
    }
    claims_kit_decide(m, held, 1, "slope of the printed numbers within %g of the printed order", BAND);
}

/* "TABLE | scene and options": every error of the table, run again. */
static void take_table(const char *argument, struct claims_measured *m) {
    char name[40], options[160];
    double worst = 1;
    struct published t;
    claims_kit_part(&argument, name, sizeof name);
    claims_kit_part(&argument, options, sizeof options);
    if (claims_kit_published(&t, m, name)) return;
    int scene = (int)strcspn(options, " "), held = 0;
    for (int r = 0; r < t.rows; r++) claims_kit_quote(m, &t, r);
    for (int r = 0; r < t.rows; r++)
        for (int i = 0; i < t.columns; i++) {
            struct command_run run;
            int bad = claims_kit_run(&run, m, "run %.*s %s%s --dx %s", scene, options, t.method[r], options + scene,
                                     t.where[i]);
            double measured = run.result.error.l1, ratio = measured / t.value[r][i];
            command_run_free(&run);
            if (bad) return;
            int digits = fabs(published_units(t.cell[r][i], measured)) <= 1;
            int near = digits || fabs(ratio - 1) <= 0.02;
            if (!near)
                claims_kit_number(m, ratio, "", "measured over printed, %s at dx = %s", t.method[r], t.where[i]);
            if (!digits && !(fabs(ratio - 1) <= fabs(worst - 1))) worst = ratio;
            held += near;
        }
    claims_kit_number(m, t.rows * t.columns, "", "errors compared");
    claims_kit_number(m, held, "", "within 2 %% or a unit of the last digit");
    claims_kit_number(m, worst, "", "worst ratio of those more than a unit of the last digit off");
    claims_kit_decide(m, fabs(worst - 1) <= 0.10, held == t.rows * t.columns,
                      "every error within 2 %% or one unit of its last digit; within 10 %% leaves a choice open");
}

const struct claims_measure claims_order_measures[] = {
    {"order", take_order}, {"printed_order", take_printed_order}, {"table", take_table}, {0}};
