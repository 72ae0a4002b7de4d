/* heatladder claims: what the two papers state, measured. */
#include "verification/command/verb.h"

#include "solver/method.h"
#include "reports/ledger/claims.h"
#include "reports/ledger/claims_write.h"
#include "reports/papers.h"
#include "verification/command/request.h"
#include "verification/text/output.h"

#include <stdio.h>

static int run(const struct request *r, struct claims *c, struct failure *why) {
    if (r->dir && output_directory(r->dir, "claims.csv", why)) return why->status;
    if (claims_collect(papers_claims, r->only, c, why)) return why->status;
    claims_run(c);
    (r->json ? claims_write_json : r->dir ? claims_write_changed : claims_write_text)(c, stdout);
    return r->dir ? claims_write_files(c, r->dir, why) : STATUS_OK;
}

int verb_claims(const struct request *r, struct failure *why) {
    struct claims claims = {0};
    int status = run(r, &claims, why);
    if (!status && !claims_hold(&claims)) status = STATUS_GATE;
    claims_free(&claims);
    return status;
}
