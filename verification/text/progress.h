#ifndef HEATLADDER_VERIFICATION_TEXT_PROGRESS_H
#define HEATLADDER_VERIFICATION_TEXT_PROGRESS_H

/* A line on a terminal that shows how far long work has come; nothing in a pipe, nor within another progress. */

struct progress {
    const char *what;
    int done, total;
    int shown; /* 1 on a terminal */
};

/* `total` pieces of work, named by `what`. */
struct progress progress_start(const char *what, int total);
void progress_tick(struct progress *p); /* from any thread */
void progress_end(struct progress *p);  /* takes the line away */

#endif
