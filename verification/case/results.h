/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_RESULTS_H
#define HEATLADDER_VERIFICATION_CASE_RESULTS_H

/* Cases written now and answers judged later: DIR/SCENE/DX/case and DIR/SCENE/DX/out.csv. */

#include "solver/problem.h"
#include "verification/case/experiment.h"
#include "verification/text/number.h"

enum { RESULTS_PATH = 1024 };

/* The fewest digits that read back as `value`; for a whole number below 1e6 all digits. */
void results_number(double value, char text[40]);

/* The subdirectory of `dir` with this number as its name, in any notation; if there is none, the name with the
 * fewest digits.  Returns 0, or -1 if the path is too long. */
int results_directory(const char *dir, double value, char path[RESULTS_PATH]);

/* STATUS_OK if `dir` is a readable directory, else STATUS_INPUT. */
int results_directory_check(const char *dir, struct failure *why);

/* The subdirectories of `dir` with positive numbers as names, at most NUMBERS_MAX.  Returns STATUS_OK, or
 * STATUS_INPUT with *why if there are none or more. */
int results_list(const char *dir, struct numbers *found, struct failure *why);

struct results_known { /* settings of the cases that are judged together */
    unsigned long set; /* bits of the known parameters */
    struct problem *p; /* with their values in p->param */
    int mapped;        /* 1 if *map is known */
    struct mapping *map;
    double *aspect; /* dy over dx, 0: unknown */
};

struct rows;

/* Compares the parameters and the mapping of a case file with the known ones, and adds new ones. */
int results_case_params(const struct rows *r, const struct scene *s, struct results_known *known,
                        struct failure *why);

/* "NAME=VALUE,NAME=VALUE" of the parameters given (bits of `set`), in the order of the scene's table, then dy over
 * dx (0: not given) and the mapping; "" if none was given.  Returns 0, or -1 if the text is too long. */
int results_setting(const struct scene *s, const struct problem *p, unsigned long set, const struct mapping *map,
                    double aspect, char text[PROGRAM_SETTING]);

/* DIR/SCENE, or DIR/SCENE/SETTING if there is a setting.  Returns 0, or -1 if the path is too long. */
int results_of_scene(const char *dir, const struct scene *s, const char *setting, char path[RESULTS_PATH]);

/* 1 if that directory exists. */
int results_has(const char *dir, const struct scene *s, const char *setting);

/* Reads parameters and mapping from the case files of DIR/SCENE, which must agree with each other and with the known
 * ones.  Directories without a case file are skipped. */
int results_params(const char *dir, const struct scene *s, const char *setting, const struct numbers *dx,
                   struct results_known *known, struct failure *why);

struct results_place { /* DIR/SCENE/SETTING/DX/RUNG; "" to omit a level */
    const char *dir, *setting, *rung;
    const struct mapping *map; /* map of the case; NULL for none */
    int seeds;                 /* draws of each case, in subdirectories seed=1 and so on; 0 for one, without a seed */
};

/* Writes the case for each number in `dx`, as typed, and appends these directories to DIR/cases.txt.  An identical
 * existing case is kept; a different one is refused if it already has an answer. */
int results_write(const struct results_place *at, const struct scene *s, const struct problem *p,
                  const struct options *o, const char *dx, int *written, struct failure *why);

extern const char *const results_answers[]; /* names of an answer in its directory, ended by NULL */

/* Returns 1 and the path, of `size` characters, if `dir` has an answer (out.csv, out.npy, out.dat); else 0 and the
 * path of the first of these. */
int results_answer(const char *dir, char *path, unsigned long size);

#endif
