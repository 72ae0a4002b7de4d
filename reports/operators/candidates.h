/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_OPERATORS_CANDIDATES_H
#define HEATLADDER_REPORTS_OPERATORS_CANDIDATES_H

/* The clouds and the operators that the study puts side by side. */

#include "solver/options.h"

#include <stdio.h>

struct cloud_kind {
    const char *name, *options;
    enum layout_name layout;
    double jitter;
};

struct candidate_operator {
    const char *method, *options;
    int materials; /* how many it knows */
};

enum { CLOUDS = 5, OPERATORS = 15 };
extern const struct cloud_kind operators_clouds[CLOUDS];
extern const struct candidate_operator operators[OPERATORS];

enum { OPERATORS_LATTICE = 0, OPERATORS_JITTER_03 = 3, OPERATORS_CLOUD_RELAXED = 4 }; /* of the clouds */

/* An operator by itself on a cloud. */
struct trait {
    int status;        /* STATUS_OK, or why there is none */
    double least;      /* weight, kappa/dx^2 */
    double limit;      /* dx^2/kappa; 0 where a mode grows at any step */
    double neighbours; /* of a row */
    double seconds;    /* of assembly, a particle, one thread; NaN but at jitter 0.3 */
};

/* Of each operator of one material on each cloud: [operator * CLOUDS + cloud]; to be freed. */
struct trait *operators_take_traits(void);
void operators_traits(const struct trait *all, FILE *csv, FILE *md);

/* What one chooses by. */
struct choice {
    double drift;       /* the largest of rod-cosine's heat on a cloud, of the heat at the start */
    double order[2];    /* least and largest on the clouds: rect-manufactured, wall-composite */
    double worst;       /* E1 of a cloud over that of the lattice */
    double step[2];     /* dx^2/kappa, on the lattice and at jitter 0.3 */
    double pairs[3];    /* of neighbours for an error of 1e-3, on three clouds; NaN: not reached */
    int growing, draws; /* of jittered clouds: with a mode that grows, and all */
    int failed;         /* clouds on which a mode grows or the operator refuses */
};

/* One table for all operators, and the rows of it to csv. */
void operators_choice(const struct choice choice[OPERATORS], FILE *csv, FILE *md);

/* How often a mode grows on jittered clouds, and at what rate; counted in choice. To be freed. */
struct growth_cell;
struct growth_cell *operators_take_growth(struct choice choice[OPERATORS]);

/* Every kind of cloud to csv, those that grow to md. */
void operators_growth(const struct growth_cell *all, FILE *csv, FILE *md, FILE *figure);

#endif
