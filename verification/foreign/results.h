/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_RESULTS_H
#define HEATLADDER_VERIFICATION_FOREIGN_RESULTS_H

/* Cases written now and answers judged later: DIR/SCENE/DX/case beside DIR/SCENE/DX/out.csv. */

#include "solver/problem.h"
#include "verification/foreign/program.h"
#include "verification/text/number.h"

enum { RESULTS_PATH = 1024 };

/* The fewest digits that read back as `value`; of a whole number below 1e6 all of them. */
void results_number(double value, char text[40]);

/* The subdirectory of `dir` whose name is a number of that value, however it was typed; where there is none, the one
 * of the fewest digits.  0, or -1 where the path is too long. */
int results_directory(const char *dir, double value, char path[RESULTS_PATH]);

/* STATUS_OK where `dir` is a directory that can be read, else STATUS_INPUT. */
int results_directory_check(const char *dir, struct failure *why);

/* The subdirectories of `dir` whose names are numbers > 0, at most NUMBERS_MAX.  STATUS_OK, or STATUS_INPUT with *why
 * where there are none or more. */
int results_list(const char *dir, struct numbers *found, struct failure *why);

struct results_known { /* settings of the cases that are judged together */
    unsigned long set; /* bits of the parameters that are set */
    struct problem *p; /* with them in p->param */
    int mapped;        /* 1 where *map is known */
    struct mapping *map;
    double *aspect; /* dy over dx, 0: not known */
};

/* The parameters and the mapping in the `text` of the case file at `path`, against those that are known already; new
 * ones are known then. */
int results_case_params(const char *path, const char *text, const struct scene *s, struct results_known *known,
                        struct failure *why);

/* "NAME=VALUE,NAME=VALUE" of the parameters that were set (bits of `set`), in the order of the scene's table, then
 * dy over dx (0: not given) and the mapping; "" where none was.  0, or -1 where that is too long. */
int results_setting(const struct scene *s, const struct problem *p, unsigned long set, const struct mapping *map,
                    double aspect, char text[PROGRAM_SETTING]);

/* DIR/SCENE, or DIR/SCENE/SETTING where there is a setting.  0, or -1 where the path is too long. */
int results_of_scene(const char *dir, const struct scene *s, const char *setting, char path[RESULTS_PATH]);

/* Whether that directory is there. */
int results_has(const char *dir, const struct scene *s, const char *setting);

/* Takes parameters and mapping from the case files of DIR/SCENE, which must all agree, and with what is known
 * already. Directories without a case file are passed over. */
int results_params(const char *dir, const struct scene *s, const char *setting, const struct numbers *dx,
                   struct results_known *known, struct failure *why);

struct results_place { /* DIR/SCENE/SETTING/DX/RUNG; "" for neither */
    const char *dir, *setting, *rung;
    const struct mapping *map; /* map of the case; NULL for none */
    int seeds;                 /* draws of each case, below it as seed=1 and so on; 0 for one, without a seed */
};

/* Writes the case into that place for each of the numbers in `dx`, as typed, and names these directories in
 * DIR/cases.txt, after those that stand there.  A case that is there and the same stays as it is; a different one is
 * refused where it has an answer already. */
int results_write(const struct results_place *at, const struct scene *s, const struct problem *p,
                  const struct options *o, const char *dx, int *written, struct failure *why);

#endif
