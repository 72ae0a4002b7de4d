/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_PAGE_PRINT_H
#define HEATLADDER_VERIFICATION_PAGE_PRINT_H

struct gates;

/* The verdicts on standard output: each gate with `all`, else how many of each group hold; then the reason, diagnosis
 * and command of every gate that does not hold, with `all` its numbers and why too; then one line of counts. */
void print_gates(const struct gates *g, int all, double seconds);

/* Those that do not hold as annotations of GitHub Actions, on standard error: an error a failure, a warning where
 * none was decided. */
void print_annotations(const struct gates *g);

#endif
