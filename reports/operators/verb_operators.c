/* heatladder operators: the discrete Laplacians side by side. */
#include "verification/command/verb.h"

#include "reports/operators/operators.h"
#include "verification/command/request.h"

int verb_operators(const struct request *r, struct failure *why) {
    return operators_write(r->dir ? r->dir : "reports/out", why);
}
