/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Song 2018: statements of its text that no table or figure shows. */
#include "reports/ledger/claim.h"
#include "reports/song/song.h"

#include <math.h>

/* Euler's largest step by von Neumann, in dx^2/kappa, square lattice, h = 1.1 dx.  0, or 1 with *m failed. */
static int largest_step(const char *method, double *step, struct claims_measured *m) {
    struct model_problem b;
    struct step_limit limit;
    if (claim_model(&b, &limit, m, "limit %s --dim 2 --h 1.1", method)) return 1;
    *step = limit.von_neumann;
    return 0;
}

/* "METHOD | OTHER": interactions for a given time, and the error of the same particles. */
void song_text_resources(struct claims_measured *m) {
    double step[2];
    struct result run[2];
    char method[40];
    for (int i = 0; i < 2; i++) {
        if (!claim_part(&m->argument, method, sizeof method) || largest_step(method, &step[i], m) ||
            claim_result(&run[i], m,
                         "run rect-manufactured %s --set k_y=0.02 --dx 0.05 --stepper euler --fourier 0.1", method))
            return;
        claim_number(m, step[i], "dx^2/kappa", "largest step of %s", method);
        claim_number(m, (double)run[i].cost.interactions / (double)run[i].cost.updates, "",
                     "its interactions a particle and step");
        claim_number(m, run[i].error.l1, "", "its E1 on rect-manufactured");
    }
    double work = ((double)run[0].cost.interactions / step[0]) / ((double)run[1].cost.interactions / step[1]);
    claim_number(m, work, "", "interactions for the same time, the first over the second");
    claim_decide(m, work < 1, run[0].error.l1 <= run[1].error.l1,
                 "fewer interactions for the same time with the same particles; and no larger error");
}

/* The heat through the wall of eq. 4 at two times: of a Neumann condition it would be the given one at both. */
void song_text_robin(struct claims_measured *m) {
    static const double time[2] = {500, 2000};
    struct result run;
    double flux[2];
    for (int i = 0; i < 2; i++) {
        if (claim_result(&run, m, "run rod-cooling so_ssph --dx 0.3/20 --quantity flux_x_hi --t-end %g", time[i]))
            return;
        flux[i] = run.derived_exact;
        claim_number(m, flux[i], "W m^-2", "through the cooled end at %g s", time[i]);
    }
    claim_decide(m, fabs(flux[1] / flux[0] - 1) <= 1e-9, 1,
                 "the heat through the wall does not depend on its temperature");
}
