/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conduction along a field: the patch on its ring, errors and the leak against spacing, the largest step against the
 * angle of the field; fluxes at faces and at corners, and so_ssph. */
#include "reports/field/field_study.h"

#include "reports/figure/figure.h"
#include "solver/status.h"
#include "verification/case/command.h"
#include "verification/gates/measures.h"

#include <stdio.h>

#define PATCH " --set data=patch --t-end 5 --dx "
#define EACH(part, columns, keys, values, before, after)                                                             \
    FIGURE_READ(part "faces", before "ftcs" after, columns, keys, values),                                           \
        FIGURE_READ(part "corners", before "ftcs --cross corner" after, columns, keys, values),                      \
        FIGURE_READ(part "so_ssph", before "so_ssph" after, columns, keys, values)
#define ERRORS(part, before, after, values) EACH(part ", ", "dx [m],E1", "dx error_l1", values, before, after)

static const char *const ring[] = {"2/40", "2/64", "2/100", "2/160", "2/256", NULL};
static const char *const angle[] = {"1",  "5",  "10", "15", "20", "25", "30", "35", "40", "45",
                                    "50", "55", "60", "65", "70", "75", "80", "85", "90", NULL};

static const struct figure_series patches[] = {
    FIGURE_FIELD("faces", "run ring ftcs" PATCH "2/64", FIGURE_ISOTHERMS, 0),
    FIGURE_FIELD("corners", "run ring ftcs --cross corner" PATCH "2/64", FIGURE_CLOUD, 0),
    FIGURE_FIELD("so_ssph", "run ring so_ssph" PATCH "2/64", FIGURE_CLOUD, 0),
    {0}};

static const struct figure_series errors[] = {
    ERRORS("ring", "run ring ", " --set w=0.1 --dx %s", ring), ERRORS("patch", "run ring ", PATCH "%s", ring), {0}};

static const struct figure_series steps[] = {
    EACH("0.01, ", "angle [degrees],dt", "field von_neumann", angle, "limit ", " --dim 2 --ratio 0.01 --field %s"),
    EACH("0.3, ", "angle [degrees],dt", "field von_neumann", angle, "limit ", " --dim 2 --ratio 0.3 --field %s"),
    {0}};

/* The leak of `aligned` at k_par/k_perp = 1000, as in the gates. */
static int write_leak(FILE *out, struct failure *why) {
    static const char *const method[] = {"ftcs", "ftcs --cross corner", "so_ssph"};
    static const char *const name[] = {"faces", "corners", "so_ssph"}, *const line =
                                                                           "run aligned %s --t-end 0.02 --dx";
    static const int cells[] = {12, 16, 24, 32, 48, 64};
    figure_head(out, "aligned: the leak of a field along the isotherms", "verify --only 'aligned/*' --verbose");
    for (int m = 0; m < 3; m++) {
        figure_block(out, "dx [m],leak", "%s", name[m]);
        for (size_t k = 0; k < sizeof cells / sizeof *cells; k++) {
            char text[100], dx[20];
            struct command c;
            struct measured measured = {0};
            snprintf(text, sizeof text, line, method[m]);
            snprintf(dx, sizeof dx, "1/%d", cells[k]);
            int status = command_read_with(text, (const char *const[]){dx, NULL}, &c, why);
            if (!status) measures_leak(&c, -1, 1, &measured);
            command_free(&c);
            if (status) return status;
            fprintf(out, "%.9g,%.9g\n", 1. / cells[k], measured.value);
        }
    }
    return STATUS_OK;
}

int field_study_write(const char *dir, struct failure *why) {
    static const struct figure figures[] = {
        {"field_patch", "ring: a patch spreads along circles, t = 5 s, dx = 2/64 m", patches},
        {"field_error", "conduction along a field: error against spacing", errors},
        {"field_step", "largest Euler step by the angle of the field, von Neumann", steps},
        {0}};
    static const struct figure_page leak = {"field_leak", write_leak};
    if (figure_pages(&leak, 1, dir, why)) return why->status;
    return figure_write_all(figures, dir, why);
}
