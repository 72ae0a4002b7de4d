#ifndef HEATLADDER_VERIFICATION_RUN_EXTERNAL_H
#define HEATLADDER_VERIFICATION_RUN_EXTERNAL_H

/* --solver CMD: another program stands in for a method. */

struct failure;
struct field;
struct method;
struct experiment;

extern const char external_help[]; /* the case file and the CSV, for --help */

/* A method of that name, owned by the caller, which accepts no option of the model: what a label on the command line
 * stands for where another program solves. */
struct method *external_method(const char *label);

/* Solves e->problem at its dx (and dt or Fourier number, where given) by the command e->solver.  A status of
 * solver/method.h; on STATUS_OK the caller owns *f, whose `seconds` are those of the whole command, `step_seconds`
 * those that the program says it solved for (all, where it says nothing). */
int external_solve(const struct experiment *e, struct field *f, struct failure *why);

#endif
