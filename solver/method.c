/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of methods. */
#include "solver/method.h"

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
    return m->solve(m, p, o, f, why);
}
