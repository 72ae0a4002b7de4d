/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_PROGRESS_H
#define HEATLADDER_VERIFICATION_TEXT_PROGRESS_H

/* Progress of long work on standard error: on a terminal one line that is overwritten; in a pipe, and within another
 * progress, only the lines of progress_print. */

struct progress {
    const char *what;
    int done, total;
    int shown; /* 1 on a terminal */
};

/* `total` pieces of work, named by `what`. */
struct progress progress_start(const char *what, int total);
void progress_tick(struct progress *p); /* from any thread */
void progress_end(struct progress *p);  /* takes the line away */

/* Shows the current activity, on a terminal only; and prints a permanent line anywhere. printf-like, from any
 * thread. */
void progress_now(struct progress *p, const char *format, ...) __attribute__((format(printf, 2, 3)));
void progress_print(struct progress *p, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
