/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Limits against h/dx: published, von Neumann, measured, per method, kernel and dimension. */
#include "reports/stability/stability.h"

#include "verification/stability/step_limit.h"

#include <math.h>
#include <stdlib.h>

enum { RATIOS = 101, METHODS = 3, KERNELS = 3, DIMS = 2, CASES = DIMS * METHODS * KERNELS * RATIOS };
static const char *const names[METHODS] = {"so_ssph", "fo_ssph", "brookshaw"};

static double ratio_of(int k) {
    return 0.5 + 0.025 * k;
}

struct point {
    int found; /* 0: refused */
    struct step_limit limit;
};

static void find(int i, struct point *point) {
    struct failure why;
    int k = i % RATIOS, kernel = i / RATIOS % KERNELS, method = i / (RATIOS * KERNELS) % METHODS;
    int dim = 1 + i / (RATIOS * KERNELS * METHODS);
    struct model_problem b = stability_model(names[method], dim, (enum kernel_name)kernel, ratio_of(k));
    struct step_limit *l = &point->limit;
    point->found = !step_limit_model(&b, &why) && !step_limit_predict(&b, l, &why);
    /* by trying: every 0.1 on a rod; on a square every 0.25, and every 0.5 past 1.5 */
    int stride = dim == 1 ? 4 : k <= 40 ? 10 : 20;
    if (point->found && k % stride == 0) step_limit_measure(&b, &l->measured, &why);
}

static void print(FILE *out, const struct point *point, double h) {
    const struct step_limit *l = &point->limit;
    if (!point->found)
        fprintf(out, "%.4g,nan,nan,nan,nan,nan\n", h);
    else
        fprintf(out, "%.4g,%.6g,%.6g,%.6g,%.6g,%.3g\n", h, l->published, l->von_neumann, l->measured, l->beta,
                fmax(0, l->grows * l->growth));
}

static int differences(FILE *out, struct failure *why) {
    static const char *const method[] = {"ftcs", "ftcs_flux"};
    for (int i = 0; i < 4; i++) {
        struct model_problem b = stability_model(method[i % 2], 1 + i / 2, KERNEL_CUBIC, 0);
        struct step_limit l;
        if (step_limit_model(&b, why) || step_limit_predict(&b, &l, why) || step_limit_measure(&b, &l.measured, why))
            return why->status;
        stability_block(out, "published,von_neumann,measured", "%s %dD", method[i % 2], b.dim);
        fprintf(out, "%.6g,%.6g,%.6g\n", l.published, l.von_neumann, l.measured);
    }
    return STATUS_OK;
}

int stability_limits_page(FILE *out, struct failure *why) {
    struct point *point = xcalloc(CASES, sizeof *point);
    stability_head(out, "The largest stable step: published, by von Neumann's analysis, by trying",
                   "limit so_ssph --dim 1 --kernel quartic --h 1.1");
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < CASES; i++) find(CASES - 1 - i, &point[CASES - 1 - i]); /* the widest stencils first */
    for (int i = 0; i < CASES; i++) {
        if (i % RATIOS == 0)
            stability_block(out, "h/dx,published,von_neumann,measured,beta,growth", "%s %s %dD",
                            names[i / (RATIOS * KERNELS) % METHODS], kernel_words[i / RATIOS % KERNELS],
                            1 + i / (RATIOS * KERNELS * METHODS));
        print(out, &point[i], ratio_of(i % RATIOS));
    }
    free(point);
    return differences(out, why);
}
