/* Pamplona, Silva, Bucar, Vasco 2019 (COB-2019-0748): Figures 5 and 6 as rows; Table 1 and Figures 7 and 8 have files
 * of their own. */
#include "reports/pamplona/pamplona.h"

#include "reports/page/figure.h"
#include "reports/pamplona/plate.h"
#include "reports/pamplona/xi.h"

#include "solver/method.h"

#define SPH                                                                                                          \
    "run plate brookshaw --kernel quartic --h 1.2 --volume tuned --xi 1.643 --walls fixed --dx 0.005 --stepper rk2 " \
    "--dt 0.1623 --t-end "
#define FTCS "run plate ftcs --walls fixed --dx 0.005 --dt 0.08169 --t-end "
#define FOUR_TIMES(what)                                                                                             \
    (const struct figure_series[]) {                                                                                 \
        {"28.9 s", what "28.8894", REPORT_FIGURE_ISOTHERMS, 0},                                                      \
            {"57.9 s", what "57.9411", REPORT_FIGURE_ISOTHERMS, 0},                                                  \
            {"87.0 s", what "86.9928", REPORT_FIGURE_ISOTHERMS, 0},                                                  \
            {"115.9 s", what "115.8822", REPORT_FIGURE_ISOTHERMS, 0}, {0},                                           \
    }

static const struct figure figures[] = {
    {"pamplona_fig5",
     "Pamplona 2019, Figure 5: isotherms of Brookshaw's SPH and of the exact solution",
     FOUR_TIMES(SPH),
     {0.1, 0.1, 0.9}},
    {"pamplona_fig6",
     "Pamplona 2019, Figure 6: isotherms of FTCS and of the exact solution",
     FOUR_TIMES(FTCS),
     {0.1, 0.1, 0.9}},
};

int pamplona_write(const char *dir, struct failure *why) {
    if (pamplona_plate_write(dir, why) || pamplona_xi_write(dir, why)) return why->status;
    for (size_t i = 0; i < sizeof figures / sizeof *figures; i++)
        if (figure_write(&figures[i], dir, why)) return why->status;
    return STATUS_OK;
}
