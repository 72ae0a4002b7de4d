/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Interrupts of the verbs that write many files: the program dies of the signal, every file is whole or not there,
 * and nothing is left beside them.  The signal comes at a chosen call of the C library, so that a test is the same
 * each time: when a clock is read amid the runs, when a file is opened that is not in its place yet, when it is put
 * there. */
#include "verification/ladder/command.h"
#include "verification/cli/verb.h"
#include "verification/text/whole_file.h"

#include "solver/status.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <fcntl.h>
#include <glob.h>
#include <omp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum call { CLOCK, OPEN, RENAME, CALLS };

static struct {
    enum call call;
    int at, signal; /* the at-th such call raises it; 0: none does */
} planned;
static atomic_int calls[CALLS];

static void count(enum call call) {
    if (atomic_fetch_add(&calls[call], 1) + 1 == planned.at && call == planned.call) raise(planned.signal);
}

/* In place of the library's own. */
double omp_get_wtime(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    count(CLOCK);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int open(const char *path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    int mode = flags & O_CREAT ? va_arg(arguments, int) : 0;
    va_end(arguments);
    int file = openat(AT_FDCWD, path, flags, mode);
    if (flags & O_CREAT) count(OPEN);
    return file;
}

int rename(const char *from, const char *to) {
    int bad = renameat(AT_FDCWD, from, AT_FDCWD, to);
    count(RENAME);
    return bad;
}

/* ---- A verb in a process of its own ---- */

static char whole[UNIT_PATH], cut[UNIT_PATH], scratch[UNIT_PATH];

static int make_directories(void **state) {
    (void)state;
    return !scratch_directory(whole, "heatladder-whole") || !scratch_directory(cut, "heatladder-cut") ||
           !scratch_directory(scratch, "heatladder-tmp");
}

/* Removes the files of a directory; how many they were. */
static size_t clear(const char *dir) {
    char pattern[UNIT_PATH + 8];
    glob_t found = {0};
    snprintf(pattern, sizeof pattern, "%s/*", dir);
    size_t n = glob(pattern, 0, NULL, &found) ? 0 : found.gl_pathc;
    for (size_t i = 0; i < n; i++) unlink(found.gl_pathv[i]);
    globfree(&found);
    return n;
}

static int remove_directories(void **state) {
    (void)state;
    clear(whole);
    clear(cut);
    return remove(whole) || remove(cut) || remove(scratch);
}

/* The status of `heatladder LINE DIR`, as from waitpid. */
static int end_of(const char *line, const char *dir) {
    char text[400];
    int status;
    pid_t child = fork();
    assert_order(child, >=, 0);
    if (child == 0) {
        char *word[20];
        struct failure why;
        setenv("TMPDIR", scratch, 1);
        if (planned.at) signal(planned.signal, SIG_DFL);
        if (!freopen("/dev/null", "w", stdout) || !freopen("/dev/null", "w", stderr)) _exit(99);
        snprintf(text, sizeof text, "%s %s", line, dir);
        int n = command_words(text, word, 20);
        const struct verb *v = verb_find(word[0]);
        void *options = xcalloc(1, v->size);
        status = command_parse(v->syntax, v->own, n, word, options, &why);
        _exit(status ? 98 : v->act(options, &why));
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return status;
}

/* Each file of `cut` stands in `whole` with the same bytes.  How many there are. */
static size_t compare(void) {
    char pattern[UNIT_PATH + 32], other[UNIT_PATH + 64];
    glob_t found = {0};
    snprintf(pattern, sizeof pattern, "%s/*", cut);
    size_t n = glob(pattern, 0, NULL, &found) ? 0 : found.gl_pathc;
    for (size_t i = 0; i < n; i++) {
        size_t size[2];
        snprintf(other, sizeof other, "%s%s", whole, strrchr(found.gl_pathv[i], '/'));
        char *here = whole_file_at(found.gl_pathv[i], &size[0]), *there = whole_file_at(other, &size[1]);
        if (!there) fail_msg("%s: no such file is made", found.gl_pathv[i]);
        assert_int_equal(size[0], size[1]);
        assert_memory_equal(here, there, size[0]);
        free(here);
        free(there);
    }
    globfree(&found);
    return n;
}

/* The files of `cut` after an interrupt at that call. */
static size_t interrupted(const char *line, enum call call, int at, int number) {
    planned.call = call, planned.at = at, planned.signal = number;
    int status = end_of(line, cut);
    planned.at = 0;
    if (!WIFSIGNALED(status)) fail_msg("%s: status %d, no %d-th call of %d", line, status, at, call);
    assert_int_equal(WTERMSIG(status), number);
    size_t files = compare();
    assert_int_equal(clear(cut), files);
    assert_int_equal(clear(scratch), 0);
    return files;
}

/* A set of files that belong together is there in full or not at all. */
static void report_is_whole(void **state) {
    (void)state;
    assert_int_equal(end_of("report", whole), 0);
    assert_int_equal(interrupted("report", OPEN, 1, SIGINT), 0);
    assert_int_equal(interrupted("report", CLOCK, 2, SIGTERM), 0);
    size_t files = interrupted("report", OPEN, 2, SIGTERM);
    assert_order(files, >, 0);
    assert_int_equal(interrupted("report", RENAME, 1, SIGHUP), files);
    clear(whole);
}

static void studies_leave_nothing(void **state) {
    (void)state;
    const char *const lines[] = {"report stability", "report operators", "bench --scene rod-cosine"};
    for (int i = 0; i < 3; i++) {
        assert_int_equal(interrupted(lines[i], OPEN, 1, SIGINT), 0);
        assert_int_equal(interrupted(lines[i], CLOCK, 1, SIGTERM), 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(report_is_whole),
        cmocka_unit_test(studies_leave_nothing),
    };
    return cmocka_run_group_tests_name("interrupts", tests, make_directories, remove_directories);
}
