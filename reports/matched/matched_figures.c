/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Error against work on square-step: the run of Song 2018, section 5.2 (point samples, Euler, dt = 0.001 s), beside
 * the matched run.  Work is the number of pairs of particles evaluated, on the whole domain. */
#include "reports/matched/matched_figures.h"

#include "reports/figure/figure.h"

#define WORK(name, options, dx)                                                                                      \
    FIGURE_READ(name, "run square-step so_ssph --domain whole " options " --dx %s", "pairs," name ",dx [m],steps",   \
                "interactions error_l1 dx steps", dx)

static const char *const published[] = {"0.5", "0.25", "0.125", "0.1", "0.0625", "0.05", NULL}, *const matched[] = {
                                                                                                    "0.25",   "0.2",
                                                                                                    "0.125",  "0.1",
                                                                                                    "0.0625", "0.05",
                                                                                                    "0.025",  NULL};

static const struct figure_series series[] = {
    WORK("as published", "--stepper euler --dt 0.001", published),
    WORK("matched", "--stepper matched --h iso --sampling spline", matched),
    WORK("matched, without the start", "--stepper euler --fourier 0.29516 --h iso --sampling spline", matched),
    {0}};

int matched_figures_write(const char *dir, struct failure *why) {
    static const struct figure figure = {"matched_fig1", "square-step: error against work, as published and matched",
                                         series};
    return figure_write(&figure, dir, why);
}
