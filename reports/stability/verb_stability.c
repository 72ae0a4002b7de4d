/* heatladder stability: the data of the figures of where methods fail. */
#include "verification/command/verb.h"

#include "verification/command/request.h"
#include "reports/stability/stability.h"

int verb_stability(const struct request *r, struct failure *why) {
    return stability_write(r->dir ? r->dir : "reports/out", why);
}
