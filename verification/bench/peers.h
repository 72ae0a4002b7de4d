/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_BENCH_PEERS_H
#define HEATLADDER_VERIFICATION_BENCH_PEERS_H

/* Programs that others would use, beside our methods: error against time, each a row with the command that stands in
 * for a method (foreign/program.h). */

#include "verification/bench/bench.h"

#include <stdio.h>

enum { PEERS_SIZES = 8, PEERS_SETTING = 60, PEERS_FAILURE = 200 };

enum peers_kind { PEERS_THEIRS, PEERS_OURS, PEERS_WHOLE, PEERS_RATE };
extern const char *const peers_kind_words[]; /* in the order of the enum */

struct peer {
    const char *scene, *side; /* its extent along x, m */
    const char *who;
    enum peers_kind kind; /* theirs; ours; ours without symmetry; ours for its updates per second */
    /* Theirs: the command, a setting behind it, and `exit status 77` where it is not installed.  Ours: method and
     * options. */
    const char *command;
    const char *settings; /* tolerances, the tightest first: --time-error of ours; "" where there are none */
    double gate[2];       /* the band of its order; 0 for none */
    int serial;           /* 1: it knows no threads, or is the slower of two */
    int n[PEERS_SIZES];   /* cells along x, coarsest first, ended by 0 */
};

extern const struct peer peers_table[]; /* by scene, ended by one without a scene */
extern const char peers_versions[];     /* a command that prints the versions of those that are installed */

struct peers_runs {         /* of one size, with so many threads */
    int count;              /* repeats; 0: there is no time */
    struct bench_time time; /* of the solve, s */
    double error, updates;  /* E1; time steps times particles */
    double start_up;        /* of the first, s */
    char failure[PEERS_FAILURE];
};

struct peers_size {
    int n;
    char setting[PEERS_SETTING];
    struct peers_runs with[2]; /* one thread; all of them */
};

struct peers_row {
    const struct peer *peer; /* NULL ends the rows */
    int sizes, missing;      /* 1: not installed, all else of the row is void */
    struct peers_size size[PEERS_SIZES];
    char order[60]; /* the verdict on its order */
};

struct peers {
    int threads; /* set by the caller: how many all of them are */
    FILE *runs;  /* likewise: gets a line a run, CSV */
    struct peers_row *row;
};

/* Measures the rows of a table, of one scene where it is named, one process after the other.  What has settings gets
 * the loosest whose error is within 5 % of the tightest's, so that none pays for accuracy which its grid does not
 * have; what is timed of ours then is a run at the time step that --time-error found.  All solve the same for 0.1 s
 * before.  STATUS_OK, or STATUS_INPUT for a scene without a row. */
int peers_run(const struct peer *table, const char *scene, struct peers *all, struct failure *why);
void peers_free(struct peers *all);

/* The whole table as text: orders, seconds at an error, what was aimed at and reached, what failed. */
void peers_print(const struct peers *all, FILE *out);

/* The data of one scene's chart, with one thread or with all (`many`), where what knows no threads stands for itself.
 */
void peers_print_data(const struct peers *all, const char *scene, int many, FILE *out);

#endif
