/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_MEASURES_H
#define HEATLADDER_VERIFICATION_GATES_MEASURES_H

/* Measures of gates, by name.  A new measure is a row of measures.def and a function. */

#include "solver/field.h"
#include "verification/fault/diagnosis.h"
#include "verification/text/number.h"
#include "verification/text/verdict.h"

struct experiment;
struct failure;
struct ladder;
struct command;
struct result;

/* The rungs of a ladder, coarsest first, for a chart and a table. */
struct rungs {
    int n;            /* 0 if there is no ladder */
    char axis[60];    /* name of x, with its unit: "dx [m]" */
    const char *norm; /* norm of the errors: "E1" */
    double x[NUMBERS_MAX];
    double error[NUMBERS_MAX]; /* NaN if the run failed */
    int counts[NUMBERS_MAX];   /* 1 if the rung counts for the slope */
};

struct measured {
    double value;
    double ci[2]; /* 95 % interval of a slope; else the value twice */
    double dt;    /* s: time step of the finest rung; 0: unknown */
    double error; /* bounded by a ceiling: E1; for a ladder its norm at the finest rung that counts; NaN: none */
    enum verdict verdict;
    char reason[400];
    struct diagnosis found; /* the common fault that the errors resemble; its evidence is owned */
    char diagnosis[340];    /* in words; "" if none is named */
    struct rungs rungs;
    struct field field; /* owned: the finest answer of a row that does not hold; n = 0: none */
    double *due;        /* owned: K, at its points, what the answer is compared with */
    char due_is[40];    /* "exact", "second run", "T to 7 digits" */
    double due_scale;   /* K: a difference that a picture must have room for; 0: none */
};

struct measure {
    const char *name;
    const char *about; /* one line, with the unit */
    const char *says;  /* the value with its unit, "the error E1 is {value}"; "" for a reason of its own */
    int ceiling;       /* 1: a built-in gate needs a ceiling on the error */
    /* Fills *m, judged by lo <= value <= hi. */
    void (*take)(const struct command *r, double lo, double hi, struct measured *m);
};

extern const struct measure measures[]; /* ended by a NULL name */

#define MEASURE(name, ceiling, about, says)                                                                          \
    void measures_##name(const struct command *r, double lo, double hi, struct measured *m);
#include "verification/gates/measures.def"
#undef MEASURE

/* A failure with its reason (skipped if the program skips the case). */
void measures_fail(struct measured *m, const struct failure *why);

/* Frees what *m owns. */
void measures_free(struct measured *m);

/* Keeps a diagnosis with its evidence, and its words if it names a fault. */
void measures_diagnosed(struct measured *m, const struct diagnosis *d);

/* Runs, judges and diagnoses a ladder by its band, into *l, which is released by ladder_free.  Returns its status: if
 * it is not 0, *m fails; otherwise *m has the slope, the verdict, the finest error and the fault. */
int measures_ladder(const struct command *r, double lo, double hi, struct ladder *l, struct measured *m);

/* Runs once; its field goes into *f unless f is NULL.  Returns its status: if it is not 0, *m fails; otherwise *m
 * has its E1. */
int measures_run(const struct experiment *e, struct result *r, struct field *f, struct measured *m);

/* The measure of that name.  If there is none, returns NULL, and *m fails with the nearest valid name. */
const struct measure *measures_find(const char *name, struct measured *m);

#endif
