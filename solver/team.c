/* Threads only where processors are idle.
 *
 * Threads that share a sweep wait for each other, and a thread whose processor is taken by another program keeps all
 * waiting for as long as the system's time slice lasts, a thousand times longer than the wait of a sweep.  So a march
 * begins alone and takes others only while the system has processors without work: the fourth field of Linux's
 * /proc/loadavg counts what is running.  Once together, threads that wait keep their processors busy, so that less
 * processor time than threads x time means that another program has taken some: the march goes on alone. */
#include "solver/team.h"

#include <omp.h>
#include <stdio.h>
#include <time.h>

static const double PERIOD = 2e-3; /* s, between looks: a hundred times what a look takes */
static const double SHARE = 0.9;   /* of the processor time of a quiet machine */
enum { PATIENCE_MOST = 64 };

static double now(clockid_t clock) {
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Processors that run nothing, this thread aside; all others where the system does not tell. */
static int idle_processors(void) {
    int all = omp_get_num_procs(), running = 1;
    FILE *in = fopen("/proc/loadavg", "r");
    if (!in) return all - 1;
    if (fscanf(in, "%*f %*f %*f %d/", &running) != 1) running = 1;
    fclose(in);
    return running < all ? all - running : 0;
}

void team_look(struct team *t, double wall, double cpu, int idle) {
    if (t->size > 1) {
        if (cpu >= SHARE * t->size * wall) {
            t->patience = 0;
            return;
        }
        t->size = 1;
        t->patience = t->patience == 0 ? 1 : t->patience < PATIENCE_MOST ? 2 * t->patience : PATIENCE_MOST;
        t->alone = t->patience;
    } else if (t->alone > 0) {
        t->alone--;
    } else {
        t->size = 1 + idle < t->most ? 1 + idle : t->most;
    }
}

struct team team_start(int most) {
    struct team t = {.most = most, .size = 1};
    if (most > 1) team_look(&t, 0, 0, idle_processors());
    t.wall = now(CLOCK_MONOTONIC), t.cpu = now(CLOCK_PROCESS_CPUTIME_ID);
    return t;
}

int team_size(struct team *t) {
    if (t->most < 2) return 1;
    double wall = now(CLOCK_MONOTONIC);
    if (wall - t->wall < PERIOD) return t->size;
    double cpu = now(CLOCK_PROCESS_CPUTIME_ID);
    team_look(t, wall - t->wall, cpu - t->cpu, t->size > 1 || t->alone > 0 ? 0 : idle_processors());
    t->wall = now(CLOCK_MONOTONIC), t->cpu = cpu;
    return t->size;
}
