/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_GATES_H
#define HEATLADDER_VERIFICATION_GATES_GATES_H

/* Gates: statements that must hold, with bounds and reasons.  A new gate is a row of gates.def. */

#include "solver/status.h"
#include "verification/gates/measures.h"

#include <stddef.h>

struct program;
struct command;
struct experiment;

enum gate_tier { TIER_QUICK, TIER_FULL }; /* --quick leaves out full */

struct gate {
    const char *id;
    enum gate_tier tier;
    const char *measure; /* a row of measures.def */
    const char *command; /* as typed after the name of the program */
    double lo, hi;       /* the band of the measure */
    double ceiling;      /* bound of the error; NAN: none */
    const char *why;     /* the fault it detects; the source of its bounds */
};

enum { GATES_COMMAND = 4096, GATES_SOLVER = 2000 }; /* characters of a command and of --solver */

struct gate_result {
    struct gate gate;
    int line;                  /* in gates.def or battery.def, with the expressions of the bounds; 0: numbers */
    struct command *read;      /* owned: of gates_read; NULL: refused or not read yet */
    struct failure refused;    /* why it was refused; STATUS_OK: it was not */
    char typed[GATES_COMMAND]; /* by gates_command */
    struct measured measured;
    double seconds;
    int executed;
};

struct gates {
    int declared;
    int executed;
    int interrupted, planned;   /* the signal of an interrupt and all rows of the run; else 0 */
    struct gate_result *result; /* `declared` rows in the order of the table */
    char *text;                 /* owned: the file of the rows; NULL for none */
    char **kept;                /* owned: `texts` texts of gates_keep */
    int texts;
    const struct program *program; /* answers all rows; NULL: each row by its own command */
    char diagnosis[560];           /* by gates_diagnose; "" if there is none */
    const char *origin;            /* words of `verify` that give these rows; NULL for none */
    int verbose;                   /* 1: progress names the rows too that the program declines */
};

/* Rows of the table and one for the reference of each scene, chosen by gates_choose, with bounds.  The status of
 * gates_choose.  End with gates_free. */
int gates_collect(const char *only, const char *skip, int quick, struct gates *g, struct failure *why);
void gates_free(struct gates *g);

/* Adds a row; its texts must outlive *g. */
void gates_add(struct gates *g, const struct gate *gate);
/* A copy of the text; gates_free frees it. */
const char *gates_keep(struct gates *g, const char *text);

/* Keeps rows with an id that matches a glob of `only` and none of `skip` (shell_match; NULL: all, none); quick: rows
 * of the quick tier.  STATUS_OK, or STATUS_INPUT if a glob matches no row or no row is left. */
int gates_choose(struct gates *g, const char *only, const char *skip, int quick, struct failure *why);

/* Frees the command of a row as read. */
void gates_forget(struct gate_result *r);

/* Sets the command of the i-th row, which is read again. */
void gates_retype(struct gates *g, int i, const char *command);

/* Reads a command; program: of another program, NULL for none.  With `results` it reads its files.  STATUS_OK, or
 * *why; command_free in either case. */
int gates_read_row(const struct gate *gate, const struct program *program, struct command *c, struct failure *why);
/* Reads the commands of all rows, each once. */
void gates_read(struct gates *g);

/* The experiment of a command at its finest rung, for the expressions of bounds. */
struct experiment gates_finest(const struct command *c);

/* "rows" for another program, else "gates"; "row" or "gate" for one of them. */
const char *gates_noun(const struct gates *g, int number);

/* Runs of another program if it declines no row and none fails; a case that rows share counts once. */
int gates_runs(struct gates *g);

/* Rungs of a row; 1 for a run. */
int gates_rungs(const struct gate_result *r);

/* Runs all rows: in parallel, heaviest first; rows of --solver one after another.  The caller may hold interrupts, as
 * for gates_run_program. */
void gates_run(struct gates *g);

/* Runs all rows by g->program, `jobs` cases at a time, and prints each verdict on standard error.  The caller holds
 * interrupts (text/output.h); an interrupt leaves the rows that are not judged yet.  STATUS_OK, or STATUS_INPUT
 * with *why if the program does not exist. */
int gates_run_program(struct gates *g, int jobs, struct failure *why);

/* After an interrupt: keeps the judged rows. */
void gates_cut(struct gates *g, int signal);

/* Judges one row; fills its seconds and typed command. */
void gates_run_row(struct gates *g, struct gate_result *result, const struct program *program);

/* 1 for a ladder in space: --seeds draws each of its rungs several times. */
int gates_is_drawn(const struct gate *gate);

/* Judges one row; program: answers it, NULL for none.  A row that cannot be run fails with its reason. */
void gates_judge(const struct gate *gate, const struct program *program, struct measured *m);

/* The command that repeats the verdict, as typed after the name of the program. */
void gates_command(const struct gate *gate, const struct program *program, char *text, size_t size);

/* Letters of the group of a row, its id up to the first slash; 1 if two ids have the same group. */
size_t gates_group_length(const char *id);
int gates_same_group(const char *a, const char *b);
/* 1 if no row before the i-th has its group. */
int gates_begins_group(const struct gates *g, int i);

/* 1 if it passed; 1 if it neither passed nor was skipped. */
int gates_holds(const struct gate_result *r);
int gates_fails(const struct gate_result *r);

/* Rows of each verdict, in the group of `id` or in all (NULL). */
struct gates_tally {
    int judged, passed, failed, undecided; /* judged: not skipped */
    int skipped;
    double seconds;
};
struct gates_tally gates_tally(const struct gates *g, const char *id);

/* STATUS_OK: all declared rows were executed, none failed and at least one passed; STATUS_INCONCLUSIVE: none failed,
 * some were inconclusive; STATUS_SKIPPED: the program skipped all; STATUS_NUMERICAL: no answer of the program can be
 * judged; otherwise STATUS_GATE. */
int gates_status(const struct gates *g);

/* Sets g->diagnosis: one fault for all rows that do not hold, or what they share; and what it leaves of each row. */
void gates_diagnose(struct gates *g);

/* 1 if a row of the table gates an order of the scene and method. */
int gates_has_order(const char *scene, const char *method);

/* More rungs, or the order of a code in time.  rungs: of each ladder in all; further rungs halve dx, and ceilings
 * fall with the order of the band.  time_order: rows of measure slope_time get the band [P - 0.2, P + 0.5].  0 for
 * either: as written. */
void gates_refine(struct gates *g, int rungs, double time_order);

#endif
