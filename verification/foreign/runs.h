/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_RUNS_H
#define HEATLADDER_VERIFICATION_FOREIGN_RUNS_H

/* Shared state of the runs of one program: the number in progress, the outcome of each case, and whether the program
 * was found.  All functions are thread-safe. */

struct failure;
struct progress;
struct runs;

/* At most `jobs` at a time, of some `total` cases.  *progress shows what is run; NULL for nowhere.  End with
 * runs_free. */
struct runs *runs_create(int jobs, int total, struct progress *progress);
void runs_free(struct runs *r);

enum runs_turn {
    RUNS_NOW,    /* the caller runs the case, then calls runs_end */
    RUNS_BEFORE, /* it was run: *why and *seconds say how it ended */
    RUNS_APART,  /* as RUNS_NOW, but in another directory: this one has another case's answer */
    RUNS_OVER    /* no more is run, for the reason *why */
};

/* Waits for a turn, and for the end of the same case where it is being run.  `dir` is the directory of the case and
 * `text` its file; NULL for a run that is shared with none.  `row` and `dx` are shown. */
enum runs_turn runs_begin(struct runs *r, const char *dir, const char *text, const char *row, const char *dx,
                          double *seconds, struct failure *why);

/* After RUNS_NOW and RUNS_APART (dir NULL); `code` is the exit status, as a shell has it. */
void runs_end(struct runs *r, const char *dir, int code, double seconds, const struct failure *why);

/* 1 where the first case could not be run at all, with the reason in *why. */
int runs_absent(const struct runs *r, struct failure *why);

#endif
