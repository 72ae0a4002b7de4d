/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_EXPERIMENT_H
#define HEATLADDER_VERIFICATION_CASE_EXPERIMENT_H

/* An experiment as asked: a problem, a method or a program, their options, and the rungs of a ladder. */

#include "references/mapping.h"
#include "references/quantity.h"
#include "solver/method.h"
#include "solver/problem.h"
#include "verification/case/norm.h"
#include "verification/case/samples.h"
#include "verification/text/number.h"

struct runs;

enum { PROGRAM_SETTING = 200, SEEDS_MAX = 16 };

/* An external program in place of a method (solve/program.h). */
struct program {
    const char *label;
    const char *solver;  /* the command; NULL with `results` */
    const char *results; /* the directory of answers, DIR/SCENE/DX; NULL with `solver` */
    const char *keep;    /* directory for case, answer and log of each rung; NULL for none */
    int seeds, seed;     /* draws of each rung, 0 for one; the current draw, from 1, for the case; 0: none */
    double timeout;      /* s; 0 for none */
    struct column_map columns;
    struct mapping map;            /* from the scene to the program's case */
    char vary[40], value[40];      /* NAME of --vary, and its value at this rung; "" for none */
    char setting[PROGRAM_SETTING]; /* directory of the parameters below SCENE; "" for SCENE itself */
    struct runs *runs;             /* shared state of the runs of one program (runs.h); NULL for none */
    const char *row;               /* the gate that runs the program, to be shown; NULL for none */
    int diagnosis;                 /* 1: a run for the diagnosis of a row, to be shown */
    char rung[100];                /* directory of this rung below DX: NAME=VALUE or dt=DT; "" for DX itself */
};

struct experiment {
    const struct scene *scene;
    const struct method *method;
    struct problem problem; /* set up from the scene and its parameters */
    struct options options;
    double memory;       /* GB, memory limit of a run; 0: the available memory */
    int growth;          /* 1: search for growing modes */
    const char *derived; /* the quantity measured in addition to the field, as typed; NULL for none */
    struct quantity quantity;
    int external; /* 1: solved by `program`; 0: by `method` */
    struct program program;
};

/* The requested rungs of a ladder; one list has several numbers. */
struct ladder_rungs {
    struct numbers dx;      /* m */
    struct numbers dt;      /* s */
    struct numbers fourier; /* dimensionless */
    double fine;            /* s: time step of one more run, the reference of a ladder in time; 0: successive runs */
    struct numbers vary;    /* values of a parameter of the program, experiment.program.vary */
    struct numbers expect;  /* band of the slope; empty if nothing is judged */
    double ceiling;         /* maximum error at the finest included rung; 0: none */
    enum norm norm;         /* norm to fit and judge */
    int diagnose;           /* 1: diagnose also if the ladder passes or nothing is judged */
    int scattered;          /* 1: the points may be at any position, so errors may scatter (judge.h) */
    int small_passes;       /* 1: an error far below the ceiling passes with any slope */
};

#endif
