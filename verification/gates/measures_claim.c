/* A claim's verdict as a gate: gates.c has one for every row of claims.def. */
#include "verification/gates/measures_claim.h"

#include "solver/method.h"
#include "verification/claims/claims.h"
#include "verification/command/request.h"

#include <math.h>
#include <stdio.h>

void measures_claim_take(const struct request *r, double lo, double hi, struct measured *m) {
    struct claims c;
    struct failure why = {0};
    *m = (struct measured){.error = NAN};
    if (!claims_collect(r->only, &c, &why)) claims_run(&c);
    m->value = m->ci[0] = m->ci[1] = claims_hold(&c);
    m->verdict = verdict_within(m->value, lo, hi);
    snprintf(m->reason, sizeof m->reason, "%.300s", why.text);
    for (int i = 0; i < c.count; i++) {
        const struct claims_measured *measured = &c.result[i].measured;
        int holds = claims_holds(c.result[i].row, measured);
        if (holds && i > 0) continue;
        snprintf(m->reason, sizeof m->reason, "%s: %.250s", claims_verdict_words[measured->verdict],
                 measured->reason);
        if (!holds) break;
    }
    claims_free(&c);
}
