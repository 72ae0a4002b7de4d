/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Signals, memory, threads and the path of the program. */
#include "verification/cli/surroundings.h"

#include "verification/case/command.h"

#include <errno.h>
#include <gsl/gsl_errno.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <omp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* GSL's own handler aborts at any error.  Callers check statuses; only a lack of memory ends the program, as in
 * xcalloc. */
static void gsl_failed(const char *reason, const char *file, int line, int error) {
    if (error != GSL_ENOMEM) return;
    fprintf(stderr, "heatladder: out of memory (GSL, %s:%d: %s)\n", file, line, reason);
    _Exit(STATUS_NUMERICAL);
}

/* Without memory or a thread for a team OpenMP exits with status 1, which means a failed gate here. */
static int over; /* 1: main ends the program */

static void ended_by_others(void) {
    if (over) return;
    fputs("heatladder: OpenMP is out of memory or threads; OMP_NUM_THREADS=1 needs no others\n", stderr);
    _Exit(STATUS_NUMERICAL);
}

/* Without memory FFTW aborts in the calling thread. */
static void fftw_failed(int signal) {
    (void)signal;
    if (errno != ENOMEM) return;
    fputs("heatladder: out of memory (FFTW)\n", stderr);
    _Exit(STATUS_NUMERICAL);
}

/* OpenMP's constructor may exit too, before main; functions of .preinit_array run earlier.  A second call does no
 * harm. */
static void expect_others(void) {
    atexit(ended_by_others);
}

#ifdef __ELF__
__attribute__((section(".preinit_array"), used)) static void (*const before_libraries)(void) = expect_others;
#endif

static void take_signals(void) {
    struct sigaction abort = {.sa_handler = fftw_failed, .sa_flags = (int)SA_RESETHAND};
    sigemptyset(&abort.sa_mask);
    sigaction(SIGABRT, &abort, NULL);
    signal(SIGXFSZ, SIG_IGN); /* write() then fails, and the partial file is removed */
}

/* The stack of the thread that starts a team lists its threads; 100,000 do not fit. */
static void limit_threads(void) {
    if (omp_get_max_threads() > COMMAND_THREADS) omp_set_num_threads(COMMAND_THREADS);
}

/* Freed pages stay with the program for the next run of the same size.  New pages from the system cost as much time
 * as a transform of the field in them. */
static void keep_pages(void) {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 32 << 20); /* bytes: the upper limit of this parameter */
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

/* The absolute path of the program, as typed or found by PATH; NULL if there is none.  The caller frees it. */
static char *program_path(const char *typed) {
    char candidate[4096];
    if (strchr(typed, '/')) return realpath(typed, NULL);
    for (const char *dir = getenv("PATH"); dir && *dir; dir += strcspn(dir, ":"), dir += *dir == ':') {
        int length = (int)strcspn(dir, ":");
        int used = snprintf(candidate, sizeof candidate, "%.*s/%s", length ? length : 1, length ? dir : ".", typed);
        if (used < (int)sizeof candidate && access(candidate, X_OK) == 0) return realpath(candidate, NULL);
    }
    return NULL;
}

/* Sets $HEATLADDER for programs of --solver to the path of this program, unless it is set. */
static void set_path(const char *typed) {
    char *path = program_path(typed);
    const char *set = getenv("HEATLADDER");
    if (set && !*set) unsetenv("HEATLADDER"); /* empty: unset */
    if (path && setenv("HEATLADDER", path, 0)) xcheck(NULL, 1, strlen(path));
    free(path);
}

/* Waiting threads give up their processor: on a busy machine a run with spinning threads took 14 times as long.
 * OpenMP reads this choice when it is loaded, so the program starts again.  Programs of --solver keep their own. */
void surroundings_wait_passively(const struct command *c, char *const *argv) {
#ifdef __linux__
    if (c->experiment.options.threads < 2 || c->external) return;
    if (getenv("OMP_WAIT_POLICY") || getenv("GOMP_SPINCOUNT")) return;
    if (setenv("OMP_WAIT_POLICY", "passive", 1) == 0) execv("/proc/self/exe", argv);
#else
    (void)c, (void)argv;
#endif
}

void surroundings_prepare(const char *typed) {
    gsl_set_error_handler(gsl_failed);
    expect_others();
    take_signals();
    keep_pages();
    limit_threads();
    set_path(typed);
}

void surroundings_leave(void) {
    over = 1;
}
