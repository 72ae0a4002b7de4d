/* heatladder case: the cases of a ladder, for a program that runs elsewhere and is judged later (--results). */
#include "verification/command/verb.h"

#include "references/scene.h"
#include "solver/status.h"
#include "verification/command/request.h"
#include "verification/foreign/results.h"

#include <stdio.h>

int verb_case(const struct request *r, struct failure *why) {
    const struct experiment *e = &r->experiment;
    int written;
    if (results_write(r->into, e->scene, &e->problem, &e->options, r->rungs.dx.text, &written, why))
        return why->status;
    printf("%d cases of %s in %s, named in %s/cases.txt; when %s/%s/DX/out.csv are there:\n"
           "  heatladder ladder %s NAME --results %s\n",
           written, e->scene->name, r->into, r->into, r->into, e->scene->name, e->scene->name, r->into);
    return STATUS_OK;
}
