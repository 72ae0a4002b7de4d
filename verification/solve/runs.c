/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs cases in parallel.  A case is identified by its directory; two rows that request the same case get the same
 * answer, and the later one waits without a turn of its own. */
#include "verification/solve/runs.h"

#include "solver/status.h"
#include "verification/text/output.h"
#include "verification/text/progress.h"

#include <omp.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { NOT_EXECUTABLE = 126, NOT_FOUND = 127 }; /* exit statuses of a shell */

struct run {
    char *dir, *text;
    int over;
    double seconds;
    struct failure end;
};

struct waiter { /* in order of arrival */
    const char *dir, *text;
    struct waiter *next;
};

struct runs {
    struct waiter *first;
    pthread_mutex_t lock;
    pthread_cond_t changed;
    int jobs, going, ended, total, absent, answered;
    double start;
    struct run *run;
    size_t count;
    struct failure absence;
    struct progress *progress;
};

struct runs *runs_create(int jobs, int total, struct progress *progress) {
    struct runs *r = xcalloc(1, sizeof *r);
    r->jobs = jobs, r->total = total, r->progress = progress;
    r->start = omp_get_wtime();
    pthread_mutex_init(&r->lock, NULL);
    pthread_cond_init(&r->changed, NULL);
    return r;
}

void runs_free(struct runs *r) {
    for (size_t i = 0; i < r->count; i++) {
        free(r->run[i].dir);
        free(r->run[i].text);
    }
    pthread_cond_destroy(&r->changed);
    pthread_mutex_destroy(&r->lock);
    free(r->run);
    free(r);
}

static char *copy(const char *text) {
    return xcheck(strdup(text), strlen(text) + 1, 1);
}

static struct run *find(const struct runs *r, const char *dir) {
    for (size_t i = 0; dir && i < r->count; i++)
        if (strcmp(r->run[i].dir, dir) == 0) return &r->run[i];
    return NULL;
}

static void show(const struct runs *r, const char *row, const char *dx) {
    double spent = omp_get_wtime() - r->start, left = r->ended ? spent / r->ended * (r->total - r->ended) : 0;
    if (!r->progress) return;
    if (r->ended && left > 0)
        progress_now(r->progress, "%s, dx %s: run %d of %d, some %.0f s left", row, dx, r->ended + r->going, r->total,
                     left);
    else
        progress_now(r->progress, "%s, dx %s: run %d", row, dx, r->ended + r->going);
}

/* Call with the lock held.  Returns 1 if no further case is to be run. */
static int is_over(const struct runs *r, struct failure *why) {
    if (output_noted())
        refuse(why, STATUS_NUMERICAL, "--solver: interrupted by signal %d", output_noted());
    else if (r->absent)
        *why = r->absence;
    return output_noted() || r->absent;
}

/* Whether the same case is already running: its end is awaited without a turn. */
static int is_held_up(const struct runs *r, const struct waiter *w) {
    const struct run *same = find(r, w->dir);
    return same && strcmp(same->text, w->text) == 0;
}

/* Turns are given in order of arrival, so that rows which alternate finish together. */
static int is_next(const struct runs *r, const struct waiter *w) {
    const struct waiter *first = r->first;
    while (is_held_up(r, first) && first != w) first = first->next;
    return first == w && r->going < r->jobs && !is_held_up(r, w);
}

/* Call with the lock held; *r->run may be reallocated during the wait. */
static enum runs_turn wait_for_turn(struct runs *r, const struct waiter *w, double *seconds, struct failure *why) {
    for (;;) {
        const struct run *same = find(r, w->dir);
        if (same && same->over && strcmp(same->text, w->text) == 0) {
            *seconds = same->seconds, *why = same->end;
            return RUNS_BEFORE;
        }
        if (is_over(r, why)) return RUNS_OVER;
        if (is_next(r, w)) return same ? RUNS_APART : RUNS_NOW;
        pthread_cond_wait(&r->changed, &r->lock);
    }
}

enum runs_turn runs_begin(struct runs *r, const char *dir, const char *text, const char *row, const char *dx,
                          double *seconds, struct failure *why) {
    struct waiter me = {.dir = dir, .text = text}, **at;
    pthread_mutex_lock(&r->lock);
    for (at = &r->first; *at;) at = &(*at)->next;
    *at = &me;
    enum runs_turn turn = wait_for_turn(r, &me, seconds, why);
    for (at = &r->first; *at != &me;) at = &(*at)->next;
    *at = me.next;
    if (turn == RUNS_NOW && dir) {
        r->run = xgrow(r->run, r->count, r->count + 1, sizeof *r->run);
        r->run[r->count++] = (struct run){.dir = copy(dir), .text = copy(text)};
    }
    if (turn == RUNS_NOW || turn == RUNS_APART) {
        r->going++;
        show(r, row, dx);
    }
    pthread_cond_broadcast(&r->changed); /* another waiter may be first now */
    pthread_mutex_unlock(&r->lock);
    return turn;
}

void runs_end(struct runs *r, const char *dir, int code, double seconds, const struct failure *why) {
    pthread_mutex_lock(&r->lock);
    struct run *run = find(r, dir);
    r->going--;
    r->ended++;
    if (run) run->over = 1, run->seconds = seconds, run->end = *why;
    if (code != NOT_EXECUTABLE && code != NOT_FOUND) {
        r->answered = 1;
    } else if (!r->answered && !r->absent) {
        r->absent = 1;
        r->absence = *why;
    }
    pthread_cond_broadcast(&r->changed);
    pthread_mutex_unlock(&r->lock);
}

int runs_absent(const struct runs *r, struct failure *why) {
    if (r->absent) *why = r->absence;
    return r->absent;
}
