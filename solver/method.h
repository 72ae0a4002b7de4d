/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_METHOD_H
#define HEATLADDER_SOLVER_METHOD_H

/* A method: its name, options and solver. */

#include "solver/field.h"
#include "solver/options.h"
#include "solver/status.h"

struct problem;
struct scheme; /* space/operator.h: how a particle method weights its neighbours */

struct method {
    const char *name;
    const char *about;   /* one line, with its equation */
    const char *accepts; /* the options that have a meaning here, separated by blanks: "stepper kernel h ..." */
    const struct scheme *scheme; /* NULL for a method that is not a particle method */
    /* As method_solve. */
    int (*solve)(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                 struct failure *why);
};

/* 0 and a filled *f (its arrays owned by the caller), or a status with *why filled and *f untouched. */
int method_solve(const struct method *m, const struct problem *p, const struct options *o, struct field *f,
                 struct failure *why);

extern const struct method *const methods[]; /* ended by NULL */

const struct method *method_find(const char *name); /* NULL where there is none */

#endif
