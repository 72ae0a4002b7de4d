/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `limit` with every method, every stepper, and every value of each of its options: a number or a reason, whatever is
 * asked. */
#include "solver/method.h" /* before cmocka.h, which makes a macro of `fail` */
#include "solver/time/stepper.h"
#include "solver/words.h"

#include "verification/case/command.h"
#include "verification/stability/step_limit.h"
#include "verification/unit/near.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Eigenvalues of a cloud in the plane take a tenth of a second: there the steps alone are tried. */
static int find_limit(const struct command *r, struct failure *why) {
    struct model_problem b;
    struct step_limit l = {.von_neumann = 0};
    int status = step_limit_setup(r->experiment.method, &r->experiment.options, r->dim, r->ratio, r->field,
                                  r->contact, r->stages, &b, why);
    if (!status && !(r->dim == 2 && options_is_cloud(&b.options))) status = step_limit_predict(&b, &l, why);
    if (status) return status;
    if (isnan(l.von_neumann)) fail_msg("no limit and no reason");
    return step_limit_grows(&b, 0x1p-6, 2, why) < 0 ? why->status : STATUS_OK;
}

/* 1 where there is a limit, 0 where there is a reason that there is none. */
static int try(const char *line) {
    struct command r;
    struct failure why = {0};
    int status = command_read(line, &r, &why);
    if (!status) status = find_limit(&r, &why);
    command_free(&r);
    if (status == STATUS_OK) return 1;
    if (status != STATUS_INPUT && status != STATUS_NOT_APPLICABLE && status != STATUS_NUMERICAL)
        fail_msg("%s: status %d", line, status);
    if (!*why.text) fail_msg("%s: refused without a reason", line);
    return 0;
}

/* Tries all values of one option and returns the number that have a limit. */
static int try_option(const char *command, const struct option *o) {
    static const char *const numbers[] = {"1e-300", "3.8e-9", "0.3", "1", "4", "42", NULL};
    const char *const *value = o->words ? o->words : numbers;
    int limits = 0;
    for (; *value; value++) {
        char line[200];
        snprintf(line, sizeof line, "%s --%s %s", command, o->name, *value);
        limits += try(line);
    }
    return limits;
}

static void limits_exist_for_every_method_and_option(void **state) {
    (void)state;
    const struct command_syntax *limit = &command_syntaxes[COMMAND_LIMIT];
    for (int m = 0; methods[m]; m++)
        for (int k = 0; stepper_words[k]; k++)
            for (int dim = 1; dim <= 2; dim++) {
                char command[100];
                int limits = 0, first = k == 0; /* auto: the simplest stepper */
                if (dim == 2 && !first) continue;
                snprintf(command, sizeof command, "limit %s --dim %d --stepper %s%s", methods[m]->name, dim,
                         stepper_words[k], k && stepper_of((enum stepper_name)k)->count ? " --stages 5" : "");
                for (const struct option *o = command_options; o->name; o++)
                    if (o->value && words_among(limit->options, o->name) && !words_among("stepper dim", o->name))
                        limits += try_option(command, o);
                if (first) assert_order(limits, >, 0);
            }
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(limits_exist_for_every_method_and_option),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
