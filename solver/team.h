#ifndef HEATLADDER_SOLVER_TEAM_H
#define HEATLADDER_SOLVER_TEAM_H

/* The number of threads of a time loop, measured while it runs; no result depends on it. */

struct team {
    int most, size;     /* threads that may be used, and of the stretch in hand */
    double work;        /* done since the last look, in a unit that takes one thread the same time throughout */
    double rate;        /* of one thread, work a second */
    double begin, look; /* s, of the march and of the last look */
    double lost;        /* s that threads have cost so far */
};

/* A team of one that may grow to `most`. */
struct team team_start(int most);
/* The threads for the next stretch, after one that did so much work (0: the first). */
int team_size(struct team *t, double work);

/* The decision of one look: the last stretches took t->size threads `wall` seconds for `work`, `elapsed` seconds
 * after the beginning; `idle` processors have nothing to do. */
void team_look(struct team *t, double wall, double work, double elapsed, int idle);

#endif
