#ifndef HEATLADDER_SOLVER_TEAM_H
#define HEATLADDER_SOLVER_TEAM_H

/* The number of threads of a time loop, measured while it runs; no result depends on it. */

struct team_probe;

struct team {
    int most, size;           /* threads that may be used, and of the stretch in hand */
    double total, done;       /* work of the whole loop (0: not known) and so far, in a unit that takes one thread
                                 the same time throughout */
    double work, piece;       /* since the last look, and of the last call */
    double rate;              /* of one thread at its best, work a second */
    double wake;              /* s: what a trial is known to lose at its begin; HUGE_VAL before that is known */
    double lost, before;      /* s that threads have cost so far, and had at the beginning of the last trial */
    int woken;                /* by the first stretch of a trial, which nobody judges */
    double begin, look;       /* s, of the loop and of the last look */
    struct team_probe *probe; /* a thread that is to tell `wake` */
};

/* A team of one that may grow to `most`, for so much work. */
struct team team_start(int most, double total);
/* The threads for the next stretch, after one that did so much work (0: the first). */
int team_size(struct team *t, double work);
/* To be called once, after the last stretch. */
void team_end(struct team *t);

/* The decision of one look: the last stretches took t->size threads `wall` seconds for `work`, `elapsed` seconds
 * after the beginning; `idle` processors have nothing to do. */
void team_look(struct team *t, double wall, double work, double elapsed, int idle);

#endif
