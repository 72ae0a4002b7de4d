/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_SOLVE_RUNS_H
#define HEATLADDER_VERIFICATION_SOLVE_RUNS_H

/* Shared state of the runs of one program: the number in progress, the outcome of each case, and whether the program
 * was found.  All functions are thread-safe. */

struct failure;
struct progress;
struct runs;

/* Runs at most `jobs` cases at a time, of about `total`. *progress shows the current one; NULL for no output.
 * Release with runs_free. */
struct runs *runs_create(int jobs, int total, struct progress *progress);
void runs_free(struct runs *r);

enum runs_turn {
    RUNS_NOW,    /* the caller runs the case, then calls runs_end */
    RUNS_BEFORE, /* it was already run, with the outcome *why and *seconds */
    RUNS_APART,  /* as RUNS_NOW, but in another directory, since this one has the answer of another case */
    RUNS_OVER    /* no further case is run, for the reason *why */
};

/* Waits for a turn, and for the end of the same case if it is running.  `dir` is the directory of the case and
 * `text` its file; NULL for a run that is not shared.  `row` and `dx` are shown. */
enum runs_turn runs_begin(struct runs *r, const char *dir, const char *text, const char *row, const char *dx,
                          double *seconds, struct failure *why);

/* Call after RUNS_NOW and RUNS_APART (dir NULL); `code` is the exit status as in a shell. */
void runs_end(struct runs *r, const char *dir, int code, double seconds, const struct failure *why);

/* 1 if the first case could not be run at all, with the reason in *why. */
int runs_absent(const struct runs *r, struct failure *why);

#endif
