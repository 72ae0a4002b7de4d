/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder limit: the largest stable step, as published, by von Neumann's analysis, and by trial. */
#include "verification/cli/verb.h"

#include "verification/text/json.h"
#include "verification/text/output.h"
#include "verification/stability/step_limit.h"

#include <math.h>
#include <stdio.h>

struct limit_options {
    struct command command;
    const char *json_path, *csv_path; /* NULL for none */
};

/* row: of a table (json.h), 0 for JSON */
static int write_limits(const struct model_problem *b, const struct step_limit *l, const char *path, int row,
                        struct failure *why) {
    struct output page;
    struct json j = json_table(output_open(&page, "%s", path), row);
    step_limit_json(b, l, &j);
    json_end(&j);
    return output_close(&page, 1, why);
}

static void print_wave(const double *theta, int dim) {
    printf(" (worst wave number");
    for (int a = 0; a < dim; a++) printf("%s %.4g", a ? "," : "", fabs(theta[a]));
    printf(" rad per particle)\n");
}

static void print_text(const struct model_problem *b, const struct step_limit *l) {
    int rows = model_problem_has_rows(b);
    printf("%s in %dD", b->method->name, b->dim);
    if (b->method->scheme) printf(", %s kernel, h/dx = %g", kernel_words[b->options.kernel], b->options.h);
    if (b->options.layout != LAYOUT_LATTICE) printf(", %s", layout_words[b->options.layout]);
    if (b->options.jitter > 0) printf(" %g, seed %lu", b->options.jitter, b->options.seed);
    if (b->field != 0)
        printf(", b at %g degrees, k_perp/k_par %g%s", b->field, model_problem_kappa_y(b),
               b->options.cross ? ", fluxes at corners" : "");
    else if (b->dim > 1 && model_problem_kappa_y(b) < 1)
        printf(", kappa_y/kappa_x %g%s", model_problem_kappa_y(b), b->dim == 3 ? ", kappa_z = kappa_x" : "");
    if (b->contact > 0) printf(", two materials 1 : %g", b->contact);
    if (b->options.walls != WALLS_MIRROR) printf(", walls %s", walls_words[b->options.walls]);
    printf(", %s: dt kappa/dx^2 up to\n", stepper_words[b->step.stepper]);
    if (l->source)
        printf("  %-12s %.6g (%s)\n", "published", l->published, l->source);
    else
        printf("  %-12s no number\n", "published");
    printf("  %-12s %.6g", "von Neumann", l->von_neumann);
    if (rows)
        printf(" (the eigenvalues of %zu particles)\n", l->particles);
    else
        print_wave(l->theta, b->dim);
    printf("  %-12s %.4g\n", "measured", l->measured);
    if (l->grows) printf("  %-12s %.4g kappa/dx^2: a mode grows at any step\n", "growth", l->growth);
    if (isfinite(l->beta)) printf("  %-12s %.4g (Pamplona 2019 eq. 15, dt = beta h^2/kappa)\n", "beta", l->beta);
    if (l->von_neumann == 0)
        printf("  no step is stable, whatever its size\n");
    else if (!l->grows && fabs(l->measured / l->von_neumann - 1) > 0.05)
        printf("  the run and the amplification factor disagree: one of the two is wrong\n");
    else if (l->published > 1.01 * l->von_neumann)
        printf("  the published bound lets a run blow up: it is %.3g times the true one\n",
               l->published / l->von_neumann);
    else if (l->published < 0.99 * l->von_neumann)
        printf("  the published bound takes %.3g times as many steps as are needed\n", l->von_neumann / l->published);
}

/* Steps that SPH codes take, against the stable one. */
static void print_customary(const struct model_problem *b, const struct step_limit *l) {
    struct customary_step custom[CUSTOMARY_STEPS];
    int customs = step_limit_customary(b, custom);
    if (customs > 0) printf("  steps that SPH codes take:\n");
    for (int k = 0; k < customs; k++) {
        double times = custom[k].F / l->von_neumann;
        printf("  %-12.4g %s: ", custom[k].F, custom[k].source);
        if (l->von_neumann == 0)
            printf("no step is stable\n");
        else if (times > 1)
            printf("blows up, %.3g times the stable one\n", times);
        else
            printf("stable, %.3g times as many steps as are needed\n", 1 / times);
    }
}

static int act(const void *options, struct failure *why) {
    const struct limit_options *r = options;
    const struct command *c = &r->command;
    struct step_limit l;
    struct model_problem b;
    int status = output_check(r->json_path, why);
    if (!status) status = output_check(r->csv_path, why);
    if (!status)
        status = step_limit_setup(c->experiment.method, &c->experiment.options, c->dim, c->ratio, c->field,
                                  c->contact, c->stages, &b, why);
    if (!status) status = step_limit_predict(&b, &l, why);
    if (!status) status = step_limit_measure(&b, &l.measured, why);
    if (status) return status;
    print_text(&b, &l);
    print_customary(&b, &l);
    if (r->json_path && write_limits(&b, &l, r->json_path, 0, why)) return why->status;
    return r->csv_path ? write_limits(&b, &l, r->csv_path, 1, why) : STATUS_OK;
}

static const struct option own[] = {CSV_OPTION(OPTION_PLACE(limit_options, csv_path), "the limits"),
                                    JSON_OPTION(OPTION_PLACE(limit_options, json_path), "the limits"),
                                    {0}};

const struct verb verb_limit = {&command_syntaxes[COMMAND_LIMIT], own, sizeof(struct limit_options),
                                "find the largest stable step: published, by von Neumann's analysis, and by trial",
                                act};
