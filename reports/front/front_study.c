/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The front of k = k_0 T^2 by ftcs with each mean of a pair: profiles at dx = 1/40 m, errors against spacing. */
#include "reports/front/front_study.h"

#include "reports/figure/figure.h"

#define FRONT(mean) "run front ftcs --fourier 0.1 --mean " mean " --dx "
#define MEAN(mean)                                                                                                   \
    FIGURE_FIELD("profile, " mean, FRONT(mean) "1/40", FIGURE_POINTS, 0),                                            \
        FIGURE_READ("error, " mean, FRONT(mean) "%s", "dx [m],E1", "dx error_l1", dx)

static const char *const dx[] = {"1/10", "1/20", "1/40", "1/80", "1/160", NULL};

static const struct figure_series series[] = {
    FIGURE_FIELD("exact", "reference front --at 0 --time 4", FIGURE_EXACT, 0),
    MEAN("harmonic"),
    MEAN("arithmetic"),
    MEAN("kirchhoff"),
    {0}};

int front_study_write(const char *dir, struct failure *why) {
    static const struct figure figure = {"front_means",
                                         "front: k = k_0 T^2, finite differences with three means of a pair", series};
    return figure_write(&figure, dir, why);
}
