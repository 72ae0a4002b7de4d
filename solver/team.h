#ifndef HEATLADDER_SOLVER_TEAM_H
#define HEATLADDER_SOLVER_TEAM_H

/* The number of threads of a time loop, adapted while it runs; no result depends on it. */

struct team {
    int most, size;   /* threads that may be used, and that are */
    int alone;        /* looks that still pass before others are taken again */
    int patience;     /* how many that was at the last time; 0: the last stretch together went well */
    double wall, cpu; /* s, at the last look */
};

/* A team of one that may grow to `most`. */
struct team team_start(int most);
/* The threads for the next stretch of work; looks at the machine every few milliseconds. */
int team_size(struct team *t);

/* The decision of one look: *t holds the threads of the last stretch, which had cpu seconds of processors in wall
 * seconds; `idle` processors have nothing to do. */
void team_look(struct team *t, double wall, double cpu, int idle);

#endif
