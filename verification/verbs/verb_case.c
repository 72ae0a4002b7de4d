/* heatladder case: the cases of a ladder or of the battery, for a program that runs elsewhere and is judged later. */
#include "verification/command/verb.h"

#include "references/scene.h"
#include "solver/status.h"
#include "verification/gates/battery.h"
#include "verification/gates/refine.h"
#include "verification/command/request.h"
#include "verification/foreign/results.h"

#include <stdio.h>

static int battery(const struct request *r, struct failure *why) {
    struct gates g = {0};
    int written, order = r->order ? r->order : 2;
    char rungs[40] = "";
    if (r->more_rungs) snprintf(rungs, sizeof rungs, " --rungs %d", r->more_rungs);
    int status = battery_add(order, r->draw, &g, why);
    refine_gates(&g, r->more_rungs, r->time_order);
    if (!status) status = battery_write(&g, r->into, &written, why);
    if (!status)
        printf("%d cases of %d gates in %s, named in %s/cases.txt; when each has its out.csv beside it:\n"
               "  heatladder verify --order %d --seed %lu%s --results %s\n",
               written, g.declared, r->into, r->into, order, r->draw, rungs, r->into);
    gates_free(&g);
    return status;
}

int verb_case(const struct request *r, struct failure *why) {
    const struct experiment *e = &r->experiment;
    int written;
    if (r->battery) return battery(r, why);
    if (results_write(&(struct results_place){r->into, "", "", &e->program.map}, e->scene, &e->problem, &e->options,
                      r->rungs.dx.text, &written, why))
        return why->status;
    printf("%d cases of %s in %s, named in %s/cases.txt; when %s/%s/DX/out.csv are there:\n"
           "  heatladder ladder %s NAME --results %s\n",
           written, e->scene->name, r->into, r->into, r->into, e->scene->name, e->scene->name, r->into);
    return STATUS_OK;
}
