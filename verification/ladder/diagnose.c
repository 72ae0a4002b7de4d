/* From the rungs of a ladder to the diagnosis of their errors. */
#include "verification/ladder/diagnose.h"

#include "solver/field.h"
#include "verification/diagnosis/diagnosis.h"
#include "verification/ladder/ladder.h"
#include "verification/run/norms.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void diagnose_ladder(const struct experiment *e, const struct field kept[2], struct ladder *l) {
    struct diagnosis_rung rung[2];
    double *exact[2];
    if (l->n < 2 || kept[0].n == 0 || kept[1].n == 0) {
        snprintf(l->diagnosis.what, sizeof l->diagnosis.what, "none: two rungs with an answer are needed");
        return;
    }
    for (int k = 0; k < 2; k++) {
        exact[k] = xcalloc(kept[k].n, sizeof **exact);
        norms_exact(e->scene, &e->problem, &kept[k], exact[k]);
        double dt = kept[k].dt;
        if (!(dt > 0) && kept[k].steps > 0) dt = kept[k].time / (double)kept[k].steps;
        rung[k] = (struct diagnosis_rung){&kept[k], exact[k], l->x[l->n - 1 - k], dt};
    }
    diagnosis_find(&e->problem, &rung[0], &rung[1], &l->diagnosis);
    for (int k = 0; k < 2; k++) free(exact[k]);
}
