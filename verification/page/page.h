/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_PAGE_PAGE_H
#define HEATLADDER_VERIFICATION_PAGE_PAGE_H

#include "verification/gates/gates.h"

#include <stdio.h>

struct ladder;
struct ladder_rungs;

/* Verdicts of gates for readers. */

enum { PAGE_ORIGIN = 400 }; /* letters of when, where and by what */

/* The verdict of all and where it was made (as page_origin), what most failures look like, then what failed in
 * full, then a word a group, then every gate, folded away. */
void page_put_gates(const struct gates *g, const char *made, FILE *out);
/* How many gates of that scene hold, and the gates, folded away. */
void page_put_scene(const struct gates *g, const char *scene, FILE *out);

/* The order to draw beside a ladder: the whole number next to the middle of the band where that is in the band, else
 * the middle. */
double page_order(double lo, double hi);

/* The ladder of a gate, drawn and as a table; nothing where it has none. */
void page_put_ladder(const struct gate_result *r, FILE *out);
/* Those of all gates that hold, each folded away: page_put_gates draws the others. */
void page_put_ladders(const struct gates *g, FILE *out);

/* The order that each ladder reaches, on the band that is expected: a line a gate, grouped by the names of scenes or
 * of gates, NULL last, and the command that makes it (NULL: none).  Nothing where no gate has a ladder. */
void orders_put(const struct gates *g, const char *const name[], const char *command, FILE *out);
/* The same for all ladders: by their own names where they are few, else by scene. */
void orders_put_all(const struct gates *g, FILE *out);
/* The errors of a scene's ladders in space, a curve a method and the second-order particles first. */
void orders_put_scene(const struct gates *g, const char *scene, FILE *out);

/* When, where and by which version something is made: now, here, by this one. */
void page_origin(char *text, size_t size);

/* A page of its own at `path`, whole or not at all, with the command that makes it, which is typed after the
 * program's name.  A status of solver/status.h. */
int page_gates_write(const struct gates *g, const char *title, const char *command, const char *path,
                     struct failure *why);
int page_ladder_write(const struct ladder *l, const struct ladder_rungs *asked, const char *command, const char *path,
                      struct failure *why);

/* The verdicts on standard output: each gate with `all`, else how many of each group hold; then the reason, diagnosis
 * and command of every gate that does not hold, with `all` its numbers and why too; then one line of counts. */
void print_gates(const struct gates *g, int all, double seconds);

/* Those that do not hold as annotations of GitHub Actions, on standard error: an error a failure, a warning where
 * none was decided. */
void print_annotations(const struct gates *g);

/* The verdicts as JUnit XML, reasons included.  STATUS_OK, or STATUS_INPUT with *why filled. */
int junit_write(const struct gates *g, const char *path, struct failure *why);

/* The Markdown that this project writes: headings, paragraphs, lists, tables, code, `code`, *emphasis*, links.  A
 * heading of level n becomes one of level n + deeper. */
void markdown_write(FILE *out, FILE *in, int deeper);

#endif
