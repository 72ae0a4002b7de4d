/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pamplona, Silva, Bucar, Vasco 2019 (COB-2019-0748): Figures 5 and 6; Table 1 and Figures 7 and 8 have files
 * of their own. */
#include "reports/pamplona/pamplona.h"

#include "reports/figure/figure.h"

#include "solver/status.h"
#include "reports/pamplona/plate.h"
#include "reports/figure/published.h"

/* Isotherms at the four times of Table 1. */
static int write_isotherms(const char *name, const char *title, const char *words, const char *dir,
                           struct failure *why) {
    char command[PLATE_TIMES][200], label[PLATE_TIMES][40];
    struct figure_series series[PLATE_TIMES + 1] = {{0}};
    struct published t;
    if (published_read(&t, "pamplona_table1", why)) return why->status;
    for (int k = 0; k < PLATE_TIMES; k++) {
        snprintf(command[k], sizeof command[k], "run plate %s --t-end %s", words, t.where[k]);
        snprintf(label[k], sizeof label[k], "%s s", t.where[k]);
        series[k] = (struct figure_series){label[k], command[k], FIGURE_ISOTHERMS, 0};
    }
    struct figure figure = {name, title, series};
    return figure_write(&figure, dir, why);
}

int pamplona_write(const char *dir, struct failure *why) {
    if (pamplona_table1_write(dir, why) || pamplona_fig7_write(dir, why) ||
        write_isotherms("pamplona_fig5",
                        "Pamplona 2019, Figure 5: isotherms of Brookshaw's SPH and of the exact solution",
                        plate_words[PLATE_SPH], dir, why) ||
        write_isotherms("pamplona_fig6", "Pamplona 2019, Figure 6: isotherms of FTCS and of the exact solution",
                        plate_words[PLATE_FTCS], dir, why))
        return why->status;
    return STATUS_OK;
}
