/* heatladder plan: what a run would store and do, and why. */
#include "verification/command/verb.h"

#include "verification/text/json.h"
#include "verification/choose/plan.h"
#include "verification/choose/plan_print.h"
#include "verification/command/request.h"

#include <stdio.h>

int verb_plan(const struct request *r, struct failure *why) {
    struct plan plan;
    if (r->rungs.dx.count > 1 || r->rungs.dt.count > 1 || r->rungs.fourier.count > 1)
        return refuse(why, STATUS_INPUT, "plan takes one --dx, and one --dt or --fourier");
    if (plan_make(&r->experiment, &plan, why)) return why->status;
    if (r->json) {
        struct json j = json_on(stdout);
        json_object(&j, NULL);
        plan_print_json(&r->experiment, &plan, &j);
        json_end(&j);
    } else {
        plan_print_text(&r->experiment, &plan);
    }
    return STATUS_OK;
}
