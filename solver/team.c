/* Threads only where they are seen to pay.
 *
 * Threads that share a sweep wait for each other: to be woken, and for a thread whose processor is taken by another
 * program as long as the system's time slice lasts, a thousand times longer than a sweep; where there is little work
 * in a sweep, waiting is most of it.  So a loop begins alone and measures its rate, which with the work that is left
 * tells how long it will take alone, T.  While the system has processors without work (the fourth field of Linux's
 * /proc/loadavg counts what is running) it has a thread made and goes on; when that begins to run it tells how long
 * waking takes.  Then two stretches with others are tried, one that wakes them and one that is judged, and they stay
 * while a stretch takes less time by LOSS than it takes one thread at its best.
 *
 * A trial is begun where   lost + wake + 2 stretch <= LOSS T,   lost: by all trials before; wake: what the thread
 * took to begin, or the most that a trial has lost, if that is more; 2 stretch: both last twice as long as alone.  So
 * the run takes 1.05 T at most as long as no trial loses more than was foreseen.  What one loses beyond that comes on
 * top, once: the next trial foresees it.  Looks of one thread alone are LOSS of the time so far apart: a trial
 * that begins that much later loses no more. */
#include "solver/team.h"

#include <math.h>
#include <omp.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static const double LOSS = 0.05;  /* half of what may be lost in all */
static const double ALONE = 1e-3; /* s, before the first look, which reads a small file and makes a thread: 50 us */
static const double TOGETHER = 1e-4; /* s, of a trial at least: 100 readings of a clock that takes 1 us */

/* Two hold it, and the last one to leave frees it: neither waits for the other. */
struct team_probe {
    double made;
    _Atomic double began; /* 0 until then */
    atomic_flag left;
};

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void leave(struct team_probe *p) {
    if (atomic_flag_test_and_set(&p->left)) free(p);
}

static void *begin_to_run(void *probe) {
    struct team_probe *p = probe;
    atomic_store(&p->began, now());
    leave(p);
    return NULL;
}

/* NULL where the system has no thread to give; others are not tried then. */
static struct team_probe *probe_make(void) {
    struct team_probe *p = malloc(sizeof *p);
    pthread_t thread;
    if (!p) return NULL;
    *p = (struct team_probe){.made = now(), .left = ATOMIC_FLAG_INIT};
    if (pthread_create(&thread, NULL, begin_to_run, p)) {
        free(p);
        return NULL;
    }
    pthread_detach(thread);
    return p;
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
        t->lost += fmax(0, wall - alone);
        if (t->woken && wall > (1 - LOSS) * alone) t->size = 1, t->wake = fmax(t->wake, t->lost - t->before);
        t->woken = 1;
    } else {
        t->rate = fmax(t->rate, work / wall);
        double left = fmax(0, t->total - t->done) / t->rate, stretch = fmax(TOGETHER, t->piece / t->rate);
        if (t->lost + t->wake + 2 * stretch > LOSS * (elapsed - t->lost + left)) return;
        t->size = 1 + idle < t->most ? 1 + idle : t->most;
        t->woken = 0, t->before = t->lost;
    }
}

struct team team_start(int most, double total) {
    double begin = most > 1 ? now() : 0;
    return (struct team){.most = most, .size = 1, .total = total, .wake = HUGE_VAL, .begin = begin, .look = begin};
}

/* Whether it is known what waking takes; sees to it that it will be. */
static void ask_probe(struct team *t, int idle) {
    if (t->wake < HUGE_VAL) return;
    if (!t->probe) {
        double begin = now();
        if (idle > 0) t->probe = probe_make();
        t->lost += now() - begin;
    } else {
        double began = atomic_load(&t->probe->began);
        if (began > 0) t->wake = began - t->probe->made;
    }
}

int team_size(struct team *t, double work) {
    if (t->most < 2) return 1;
    double at = now(), wall = at - t->look, elapsed = at - t->begin;
    t->work += work, t->done += work, t->piece = work;
    if (wall < (t->size > 1 ? TOGETHER : fmax(ALONE, LOSS * elapsed)) || t->work == 0) return t->size;
    int idle = t->size > 1 ? 0 : idle_processors();
    ask_probe(t, idle);
    team_look(t, wall, t->work, elapsed, idle);
    t->look = now(), t->work = 0;
    return t->size;
}

void team_end(struct team *t) {
    if (t->probe) leave(t->probe);
    t->probe = NULL;
}
