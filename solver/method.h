/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_METHOD_H
#define HEATLADDER_SOLVER_METHOD_H

/* A method: its name, options and solver. */

#include "solver/field.h"
#include "solver/options.h"
#include "solver/status.h"

struct problem;
struct scheme; /* space/operator.h: neighbour weights of a particle method */

struct method {
    const char *name;
    const char *about;           /* one line with its equation */
    const char *accepts;         /* valid options, separated by blanks: "stepper kernel h ..." */
    const struct scheme *scheme; /* NULL if not a particle method */
    /* See method_solve. */
    int (*solve)(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                 struct failure *why);
};

/* Returns 0 and fills *f (the caller owns its arrays), or returns a status with *why and leaves *f unchanged. */
int method_solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                 struct failure *why);

extern const struct method *const methods[]; /* ended by NULL */

const struct method *method_find(const char *name); /* NULL if unknown */

#endif
