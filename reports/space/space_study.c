/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cube-step: the error on the slice just above z = 0 by the first- and the second-order operator, and E1 of four
 * methods against spacing, with the jump midway between particles. */
#include "reports/space/space_study.h"

#include "reports/figure/figure.h"

#define ONE_KAPPA " --set kappa_y=0.01 --set kappa_z=0.01"
#define SLICE(method)                                                                                                \
    FIGURE_FIELD("slice, " method, "run cube-step " method " --h 1.1" ONE_KAPPA " --domain whole --dx 4/80",         \
                 FIGURE_ERROR, 0.025)
#define ERROR(method, more)                                                                                          \
    FIGURE_READ("error, " method, "run cube-step " method " " more ONE_KAPPA " --dx %s", "dx [m],E1", "dx error_l1", \
                dx)

static const char *const dx[] = {"4/40", "4/80", "4/120", NULL};

static const struct figure_series series[] = {SLICE("fo_ssph"),
                                              SLICE("so_ssph"),
                                              ERROR("fo_ssph", "--h 1.1"),
                                              ERROR("so_ssph", "--h 1.1"),
                                              ERROR("brookshaw", "--h 1.1"),
                                              ERROR("ftcs", "--fourier 0.05"),
                                              {0}};

int space_study_write(const char *dir, struct failure *why) {
    static const struct figure figure = {"space_fig1", "cube-step: a jump in space, midway between particles",
                                         series};
    return figure_write(&figure, dir, why);
}
