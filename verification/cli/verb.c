/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of verbs, from verbs.def. */
#include "verification/cli/verb.h"

#include "solver/status.h"
#include "solver/words.h"

#include <string.h>

#define VERB(name) &verb_##name,
const struct verb *const verbs[] = {
#include "verification/cli/verbs.def"
    NULL};
#undef VERB

/* Verbs of 3.0, and their replacements. */
static const char *const removed[][2] = {{"man", "man heatladder, once it is installed, or heatladder VERB --help"},
                                         {"completion", "scripts/completion.bash, which make install installs"}};

const struct verb *verb_find(const char *name) {
    for (int i = 0; verbs[i]; i++)
        if (strcmp(verbs[i]->syntax->name, name) == 0) return verbs[i];
    return NULL;
}

static int add_rows(const struct verb *v, const struct option *table, const struct option **list, int n) {
    for (const struct option *o = table; o && o->name && n < VERB_ROWS; o++) {
        if (*o->name && command_option(v->syntax, v->own, o->name) != o) continue;
        if (!*o->name && n && !*list[n - 1]->name) n--; /* a heading without options */
        list[n++] = o;
    }
    return n && !*list[n - 1]->name ? n - 1 : n;
}

int verb_options(const struct verb *v, const struct option *list[VERB_ROWS]) {
    return add_rows(v, v->own, list, add_rows(v, command_options, list, 0));
}

int verb_unknown(const char *name, struct failure *why) {
    const char *names[WORDS_MAX] = {0};
    for (size_t i = 0; i < sizeof removed / sizeof *removed; i++)
        if (strcmp(removed[i][0], name) == 0)
            return refuse(why, STATUS_INPUT, "%s is removed; use %s", name, removed[i][1]);
    for (int i = 0; verbs[i]; i++) names[i] = verbs[i]->syntax->name;
    return words_unknown(names, "verb", name, why);
}
