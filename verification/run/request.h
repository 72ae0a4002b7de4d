#ifndef HEATLADDER_VERIFICATION_RUN_REQUEST_H
#define HEATLADDER_VERIFICATION_RUN_REQUEST_H

/* What one command line asks for.  Filled by arguments.h; data only. */

#include "solver/method.h"
#include "solver/problem.h"

struct scene; /* references/scene.h */
struct verb;  /* verification/command/verb.h */

enum { RUNG_MAX = 32 };

struct numbers {
    int count;
    double value[RUNG_MAX];
};

struct request {
    const struct verb *verb;
    const struct scene *scene;   /* NULL where the verb takes none */
    const struct method *method; /* NULL where the verb takes none */
    const char *topic;           /* list: what to list, NULL for all; report: where to, NULL for reports/out */
    struct problem problem;      /* set up from the scene and its overridden parameters */
    int dim, stages;             /* limit: 1 or 2; of rkl2, else 0 */
    struct options options;      /* dx, dt and fourier are the first of the lists below */
    struct numbers dx;           /* m */
    struct numbers dt;           /* s; more than one: a time ladder */
    struct numbers fourier;      /* - ; more than one: a time ladder */
    struct numbers at;           /* m: x, or x and y */
    struct numbers expect;       /* lowest and highest slope that pass */
    double time;                 /* s */
    double time_error;           /* E1 that the time step may make up; 0: not asked for */
    double error;                /* choose: E1 to be reached */
    const char *solver;          /* the command of a program that stands in for the method; NULL for none */
    struct method *external;     /* owned: what `method` is then; else NULL */
    const char *only;            /* glob of gate names; NULL for all */
    const char *field_path, *json_path, *junit_path; /* NULL where not asked for */
    int warm_up;                                     /* 1: what is timed comes after 0.1 s of the same */
    int json;                                        /* 1: JSON on standard output instead of text */
    int quick;                                       /* 1: the quick tier of the gates alone */
    unsigned long given;                             /* which rows of the option table were given */
    unsigned long overridden;                        /* which parameters of the scene were given */
    char *line; /* owned: the words of a command that was given as one line; else NULL */
};

#endif
