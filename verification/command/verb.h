/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_COMMAND_VERB_H
#define HEATLADDER_VERIFICATION_COMMAND_VERB_H

/* The verbs of the command line.  A new one is a row of verbs.def and a file verbs/verb_<name>.c. */

struct failure;
struct request;

struct verb {
    const char *name;
    const char *positionals; /* blank-separated: SCENE, METHOD; [TOPIC] may be left out */
    const char *required;    /* options that must be given: keys of option.h, blank-separated */
    const char *options;     /* all that may be given */
    const char *sceneless;   /* those that may be given without a SCENE, where it may be left out; else NULL */
    const char *about;       /* one line */
    /* A status of solver/status.h; *why, empty when called, says why where there is something to say. */
    int (*act)(const struct request *r, struct failure *why);
};

extern const struct verb verbs[]; /* ended by a NULL name */

const struct verb *verb_find(const char *name); /* NULL where there is none */

#define VERB(name, positionals, required, options, sceneless, about)                                                 \
    int verb_##name(const struct request *r, struct failure *why);
#include "verification/command/verbs.def"
#undef VERB

#endif
