/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of methods. */
#include "solver/method.h"

#include "solver/problem.h"

#include <string.h>

#define METHOD(name) extern const struct method method_##name;
#include "solver/methods.def"
#undef METHOD

#define METHOD(name) &method_##name,
const struct method *const methods[] = {
#include "solver/methods.def"
    NULL};
#undef METHOD

const struct method *method_find(const char *name) {
    for (int i = 0; methods[i]; i++)
        if (strcmp(methods[i]->name, name) == 0) return methods[i];
    return NULL;
}

int method_solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                 struct failure *why) {
    if (options_check(o, why)) return why->status;
    if (o->dx == 0) return refuse(why, STATUS_INPUT, "--dx is missing: a spacing in m");
    if (o->dt > p->t_end)
        return refuse(why, STATUS_INPUT, "--dt %g: a step exceeds the end time; take at most %g s", o->dt, p->t_end);
    return m->solve(m, p, o, f, why);
}
