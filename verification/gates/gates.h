/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_GATES_H
#define HEATLADDER_VERIFICATION_GATES_GATES_H

/* Gates: statements that must hold, each with its bounds and the reason for them.  A new one is a row of one of the
 * tables *.def. */

#include "solver/status.h"
#include "verification/gates/measures.h"

#include <stddef.h>

struct program;
struct command;
struct experiment;

enum gate_tier { TIER_QUICK, TIER_FULL }; /* quick: in every run; full: left out by --quick */

struct gate {
    const char *id;
    enum gate_tier tier;
    const char *measure; /* a row of measures.def */
    const char *command; /* as a user would type it after the program's name */
    double lo, hi;       /* the band of the measure */
    double ceiling;      /* bound of the error in addition; NAN for none */
    const char *why;     /* the fault that it sees, and where the bounds come from */
};

enum { GATES_COMMAND = 4096, GATES_SOLVER = 2000 }; /* letters of a command, and of what runs a program */

struct gate_result {
    struct gate gate;
    int line;                  /* line of gates.def or battery.def with the expressions of the bounds; 0: numbers */
    struct command *read;      /* owned: of gates_read; NULL where it was refused, or not read yet */
    struct failure refused;    /* STATUS_OK where it was not */
    char typed[GATES_COMMAND]; /* text from gates_command */
    struct measured measured;
    double seconds;
    int executed;
};

struct gates {
    int declared;
    int executed;
    int interrupted, planned;   /* the signal that cut the run off, and the rows of before; else 0 */
    struct gate_result *result; /* declared of them, in the order of the table */
    char *text;                 /* owned: of a file that the rows were read from; NULL for none */
    char **kept;                /* owned: `texts` of them, of gates_keep */
    int texts;
    const struct program *program; /* that answers all of them; NULL: each by its own command */
    const char *origin;            /* words of `verify` without which these rows are not there; NULL for none */
};

/* The rows of the table, then one for each scene's reference, of these those that gates_choose leaves; its status.
 * End with gates_free. */
int gates_collect(const char *only, const char *skip, int quick, struct gates *g, struct failure *why);
void gates_free(struct gates *g);

/* One more row, whose texts outlive *g. */
void gates_add(struct gates *g, const struct gate *gate);
/* A copy of a row's text, which goes with *g. */
const char *gates_keep(struct gates *g, const char *text);

/* Leaves those whose id matches one of the globs `only` and none of `skip` (words_match; NULL: all, none), of the
 * quick tier alone where asked.  STATUS_OK; or STATUS_INPUT where a glob matches no row at all, or none is left. */
int gates_choose(struct gates *g, const char *only, const char *skip, int quick, struct failure *why);

/* The command of a row as it was read is freed. */
void gates_forget(struct gate_result *r);

/* Another command of the i-th row, to be read again. */
void gates_retype(struct gates *g, int i, const char *command);

/* Reads a command, for another program where there is one; with `results` it depends on the files that are there.
 * STATUS_OK or *why; command_free in either case. */
int gates_read_row(const struct gate *gate, const struct program *program, struct command *c, struct failure *why);
/* Reads the commands of all rows, each once, for g->program where there is one. */
void gates_read(struct gates *g);

/* The experiment of a command at its finest rung, for the expressions of bounds. */
struct experiment gates_finest(const struct command *c);

/* How many runs another program makes of them where none fails: cases that rows share count once. */
int gates_runs(struct gates *g);

/* The rungs of a row that was read, 1 of a run. */
int gates_rungs(const struct gate_result *r);

/* Runs all: in parallel, the heaviest first; those of a command one after the other, without a word. */
void gates_run(struct gates *g);

/* Runs all by the command of g->program, `jobs` cases side by side, and says of each row how it ended on standard
 * error.  An interrupt, which the caller holds (text/atomic_file.h), leaves the rows that are not judged yet.
 * STATUS_OK; STATUS_INPUT with *why where the program is not there. */
int gates_run_program(struct gates *g, int jobs, struct failure *why);

/* After an interrupt: leaves the rows that were judged. */
void gates_cut(struct gates *g, int signal);

/* One row, its time and its typed command too. */
void gates_run_row(struct gates *g, struct gate_result *result, const struct program *program);

/* 1 for a ladder in space: --seeds draws each of its rungs several times. */
int gates_is_drawn(const struct gate *gate);

/* One row, answered by *program where there is one (NULL: by its own command); never fails silently: what cannot be
 * run is a failed verdict with its reason. */
void gates_judge(const struct gate *gate, const struct program *program, struct measured *m);

/* The command that repeats the verdict, without the program's name. */
void gates_command(const struct gate *gate, const struct program *program, char *text, size_t size);

/* Letters of a row's group, its id up to the first slash; 1 where two ids have the same. */
size_t gates_group_length(const char *id);
int gates_same_group(const char *a, const char *b);
/* 1 where no row before the i-th has its group. */
int gates_begins_group(const struct gates *g, int i);

/* 1 where it passed; where it did not, and was not skipped: what a program says is not for it counts nowhere. */
int gates_holds(const struct gate_result *r);
int gates_fails(const struct gate_result *r);

/* How many there are of each verdict: of the group of `id`, or of all (NULL). */
struct gates_tally {
    int judged, passed, failed, undecided; /* judged: all that are not skipped */
    int skipped;
    double seconds;
};
struct gates_tally gates_tally(const struct gates *g, const char *id);

/* STATUS_OK where as many were executed as declared, none failed and one passed at least; STATUS_INCONCLUSIVE where
 * none failed, but some did not decide; STATUS_SKIPPED where a program skipped all; STATUS_NUMERICAL where a program
 * answered none that can be judged; else STATUS_GATE. */
int gates_status(const struct gates *g);

/* wording_all of those that do not hold. */
void gates_diagnosis(const struct gates *g, char *text, size_t size);

/* 1 where a row of the table gates an order of that scene and method. */
int gates_has_order(const char *scene, const char *method);

/* The rows of a battery with more rungs, or for a code of a given order in time.  rungs: in all, for rows of fewer,
 * the further ones by halving; their ceilings fall with the order that the band is for.  time_order: rows of measure
 * slope_time get the band [P - 0.2, P + 0.5].  0 for either: as the rows are. */
void refine_gates(struct gates *g, int rungs, double time_order);

#endif
