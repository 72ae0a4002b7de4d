/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of verbs, from verbs.def. */
#include "verification/command/verb.h"

#include <stddef.h>
#include <string.h>

#define VERB(name, positionals, required, options, sceneless, about)                                                 \
    {#name, positionals, required, options, sceneless, about, verb_##name},
const struct verb verbs[] = {
#include "verification/command/verbs.def"
    {0}};
#undef VERB

const struct verb *verb_find(const char *name) {
    for (const struct verb *v = verbs; v->name; v++)
        if (strcmp(v->name, name) == 0) return v;
    return NULL;
}
