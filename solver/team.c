/* Threads only where they are seen to pay.
 *
 * Threads that share a sweep wait for each other, and a thread whose processor is taken by another program keeps all
 * waiting for as long as the system's time slice lasts, a thousand times longer than the wait of a sweep; where there
 * is little work in a sweep, waiting is most of it.  So a march begins alone and measures its rate.  While the system
 * has processors without work (the fourth field of Linux's /proc/loadavg counts what is running) it tries a stretch
 * with others, and goes on so while that takes less time by GAIN than alone.  A trial is begun where LOSS of the time
 * since the beginning is more than all that trials have lost and what this one may, TRIAL: a march of length T takes
 * at most T/(1 - LOSS), and what a stretch at its end loses beyond TRIAL, however busy the machine is and however
 * small the sweep.  Within 0.2 s there is no trial. */
#include "solver/team.h"

#include <omp.h>
#include <stdio.h>
#include <time.h>

static const double ALONE = 1e-3;    /* s, between looks at one thread: fifty times what a look takes */
static const double TOGETHER = 1e-4; /* s, between looks at several, which ask the clock alone */
static const double TRIAL = 1e-2;    /* s: to wake a processor and wait for it; 2 to 19 ms were seen on two */
static const double GAIN = 1.1, LOSS = 0.05;

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
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

void team_look(struct team *t, double wall, double work, double elapsed, int idle) {
    if (t->size > 1) {
        double alone = work / t->rate;
        if (wall * GAIN <= alone) return;
        if (wall > alone) t->lost += wall - alone;
        t->size = 1;
    } else {
        t->rate = work / wall;
        if (t->lost + TRIAL <= LOSS * elapsed) t->size = 1 + idle < t->most ? 1 + idle : t->most;
    }
}

struct team team_start(int most) {
    double begin = most > 1 ? now() : 0;
    return (struct team){.most = most, .size = 1, .begin = begin, .look = begin};
}

int team_size(struct team *t, double work) {
    if (t->most < 2) return 1;
    double at = now(), wall = at - t->look;
    t->work += work;
    if (wall < (t->size > 1 ? TOGETHER : ALONE) || t->work == 0) return t->size;
    team_look(t, wall, t->work, at - t->begin, t->size > 1 ? 0 : idle_processors());
    t->look = now(), t->work = 0;
    return t->size;
}
