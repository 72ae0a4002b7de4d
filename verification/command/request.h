/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_COMMAND_REQUEST_H
#define HEATLADDER_VERIFICATION_COMMAND_REQUEST_H

/* Codes that can have other rows of the battery: all but slab/..., periodic/... alone for particles without walls,
 * all of them for codes in three dimensions. */
enum profile { PROFILE_ALL, PROFILE_PARTICLES, PROFILE_SLABS };
extern const char *const arguments_profiles[]; /* the words for them, and NULL */

/* What one command line asks for.  Filled by arguments.h; data only. */

#include "verification/ladder/ladder.h"
#include "verification/run/experiment.h"

struct verb; /* verification/command/verb.h */

struct request {
    const struct verb *verb;
    struct experiment experiment; /* scene and method are NULL where the verb takes none; dx, dt and fourier are the
                                     first of the ladder's lists */
    struct ladder_rungs rungs;
    const char *topic;       /* list: what to list; report: the study; NULL for all */
    const char *dir;         /* where files go; NULL where none is given */
    double ratio;            /* limit: kappa_y/kappa_x; 0: 1 */
    double contact;          /* limit: k and rho c of the second material over those of the first; 0: one */
    int dim, stages;         /* limit: 1 or 2; of rkl2, else 0 */
    struct numbers at;       /* m: x, or x and y */
    struct numbers origin;   /* dx: of the lattice of a round body */
    struct numbers time;     /* s */
    int times;               /* > 1: so many, evenly from time.value[0] to [1]; 0: those of `time` */
    const char *points;      /* reference: file of points, - for standard input; NULL for `at` */
    const char *what;        /* reference: the columns asked for; NULL for the temperature */
    const char *into;        /* case: the directory of cases */
    struct method *external; /* owned: what the method is where a program stands in for it; else NULL */
    char *only;              /* owned: globs of names, of gates or claims (words_match); NULL for all */
    char *skip;              /* owned: verify: globs of the gates to leave out; NULL for none */
    enum profile profile;    /* which rows of the battery a code of this kind can have */
    const char *gates_path;  /* verify: the file of rows; NULL for the built-in ones */
    int more_rungs;          /* battery: rungs of each ladder in all; 0: as the rows are */
    double time_order;       /* battery: of the code in time; 0: any of 0.9 or more */
    int order;               /* battery: of the code in space; 0: 2 */
    unsigned long draw;      /* battery: the seed of its draw; 0: as it is written */
    int jobs;                /* verify: cases of a program side by side; 0: 1 */
    int battery;             /* case: 1: the cases of the battery */
    const char *bench_scene; /* bench: the one scene; NULL for all */
    const char *field_path, *json_path, *junit_path, *page_path; /* NULL where not asked for */
    int warm_up;                                                 /* 1: what is timed comes after 0.1 s of the same */
    int json;                                                    /* 1: JSON on standard output instead of text */
    int verbose;                                                 /* 1: every gate, not only the groups */
    int quick;                                                   /* 1: the quick tier of the gates alone */
    unsigned char *given;     /* owned: for each row of the option table 1 where it was given */
    unsigned long overridden; /* which parameters of the scene were given */
    char *typed;              /* owned: the command after the program's name, quoted for a shell */
    char *line;               /* owned: the words of a command that was given as one line; else NULL */
};

#endif
