/* heatladder reference: the exact solution at one point and time, with its own error bound. */
#include "verification/command/verb.h"

#include "references/scene.h"
#include "verification/text/json.h"
#include "verification/command/request.h"

#include "solver/method.h"

#include <stdio.h>

static int inside(const struct problem *p, const double x[2]) {
    for (int a = 0; a < p->dim; a++)
        if (x[a] < p->lo[a] || x[a] > p->hi[a]) return 0;
    return 1;
}

static void print_json(const struct request *r, struct exact e, struct exact second, double published) {
    struct json j = json_on(stdout);
    json_object(&j, NULL);
    json_text(&j, "scene", r->experiment.scene->name);
    json_array(&j, "at");
    for (int a = 0; a < r->experiment.problem.dim; a++) json_number(&j, NULL, r->at.value[a]);
    json_end(&j);
    json_number(&j, "time", r->time);
    json_number(&j, "temperature", e.temperature);
    json_number(&j, "error_bound", e.error_bound);
    json_number(&j, "second_form", second.temperature);
    json_number(&j, "second_error_bound", second.error_bound);
    if (r->experiment.scene->published) {
        json_number(&j, "published", published);
        json_number(&j, "difference", published - e.temperature);
    }
    json_end(&j);
}

static void print_text(const struct request *r, struct exact e, struct exact second, double published) {
    printf("%s at %g", r->experiment.scene->name, r->at.value[0]);
    if (r->experiment.problem.dim == 2) printf(", %g", r->at.value[1]);
    printf(" m, %g s\n", r->time);
    printf("  %-12s %.17g K, within %.1e K\n", "temperature", e.temperature, e.error_bound);
    printf("  %-12s %.17g K, within %.1e K\n", "second form", second.temperature, second.error_bound);
    if (r->experiment.scene->published)
        printf("  %-12s %.17g K, %+.1e K away\n", "as published", published, published - e.temperature);
}

/* "x" or "x,y" of one point. */
static const char *point(int dim, const double x[2], char *text, size_t size) {
    snprintf(text, size, dim == 2 ? "%g,%g" : "%g", x[0], x[1]);
    return text;
}

int verb_reference(const struct request *r, struct failure *why) {
    const double *x = r->at.value;
    const struct problem *p = &r->experiment.problem;
    if (!inside(p, x)) {
        char at[64], lo[64], hi[64];
        return refuse(why, STATUS_INPUT, "--at %s: outside of %s, which is %s to %s m",
                      point(p->dim, x, at, sizeof at), r->experiment.scene->name, point(p->dim, p->lo, lo, sizeof lo),
                      point(p->dim, p->hi, hi, sizeof hi));
    }
    struct exact e = r->experiment.scene->exact(p, x, r->time), second = r->experiment.scene->second(p, x, r->time);
    double published = r->experiment.scene->published ? r->experiment.scene->published(p, x, r->time) : 0;
    (r->json ? print_json : print_text)(r, e, second, published);
    return STATUS_OK;
}
