#ifndef HEATLADDER_VERIFICATION_PAGE_PRINT_H
#define HEATLADDER_VERIFICATION_PAGE_PRINT_H

struct gates;

/* The verdicts on standard output: each gate with `all`, else how many of each group hold; then every gate that does
 * not hold in full, with the command that shows it; then one line that says what held. */
void print_gates(const struct gates *g, int all, double seconds);

/* Those that do not hold as annotations of GitHub Actions, on standard error: an error a failure, a warning where
 * none was decided. */
void print_annotations(const struct gates *g);

#endif
