/* heatladder page: one page of what the other targets have left in a directory. */
#include "verification/command/verb.h"

#include "reports/index/index.h"
#include "solver/status.h"
#include "verification/command/request.h"

#include <stdio.h>

int verb_page(const struct request *r, struct failure *why) {
    const char *dir = r->dir ? r->dir : "reports/out";
    if (index_write(dir, why)) return why->status;
    printf("page: %s/index.html\n", dir);
    return STATUS_OK;
}
