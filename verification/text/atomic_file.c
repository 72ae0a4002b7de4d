/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rename() replaces a file in one step (POSIX), so a reader sees either the old text or the new one.  All bytes are
 * in memory before the file is opened, and interrupts wait during the short writing, so no partial file remains.
 * Files that belong together are all written under temporary names first; only a few renames separate the first from
 * the last. */
#include "verification/text/atomic_file.h"

#include "solver/status.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PATH_LENGTH = 4096, INTERRUPTS = 3 };

/* A thread's signal mask would not hold interrupts, as any other thread may take them: handlers of the whole process
 * note them.  poll() and sleep return early then, so that a waiting caller sees them at once. */
static const int interrupts[INTERRUPTS] = {SIGINT, SIGTERM, SIGHUP};
static atomic_int noted; /* the last interrupt that waits; a handler can reach nothing else */
static int held;         /* calls of hold without release */
static struct sigaction before[INTERRUPTS];

static void note(int signal) {
    atomic_store(&noted, signal);
}

void atomic_file_hold(void) {
    struct sigaction wait = {.sa_handler = note};
    sigemptyset(&wait.sa_mask);
#pragma omp critical(atomic_file)
    {
        for (int k = 0; held == 0 && k < INTERRUPTS; k++) {
            sigaction(interrupts[k], NULL, &before[k]);
            if (before[k].sa_handler != SIG_IGN) sigaction(interrupts[k], &wait, NULL);
        }
        held++;
    }
}

int atomic_file_noted(void) {
    return atomic_load(&noted);
}

void atomic_file_release(void) {
    int signal = 0;
#pragma omp critical(atomic_file)
    {
        if (--held == 0) {
            for (int k = 0; k < INTERRUPTS; k++) sigaction(interrupts[k], &before[k], NULL);
            signal = atomic_exchange(&noted, 0);
        }
    }
    if (signal) raise(signal);
}

static int refuse_path(const char *path, struct failure *why) {
    return refuse(why, STATUS_INPUT, "cannot write '%.300s': %s", path, strerror(errno));
}

/* A file that may be written in a directory that may not: no other name can be put beside it. */
static int is_alone(const char *path) {
    char directory[PATH_LENGTH];
    const char *slash = strrchr(path, '/');
    int length =
        snprintf(directory, sizeof directory, "%.*s", slash ? (int)(slash - path) + 1 : 1, slash ? path : ".");
    return length < PATH_LENGTH && access(path, W_OK) == 0 && access(directory, W_OK) != 0;
}

/* 1 for a file that must be written in place. */
static int is_special(const char *path) {
    struct stat s;
    return stat(path, &s) == 0 && (!S_ISREG(s.st_mode) || is_alone(path));
}

/* The name that the file is written under first; 0, or -1 where the path is too long. */
static int beside(const char *path, char *name) {
    int length = snprintf(name, PATH_LENGTH, "%s.%ld.part", path, (long)getpid());
    if (length < PATH_LENGTH) return 0;
    errno = ENAMETOOLONG;
    return -1;
}

int atomic_file_check(const char *path, struct failure *why) {
    char name[PATH_LENGTH];
    if (!path) return STATUS_OK;
    if (is_special(path)) {
        int special = open(path, O_WRONLY);
        return special < 0 || close(special) ? refuse_path(path, why) : STATUS_OK;
    }
    if (beside(path, name)) return refuse_path(path, why);
    atomic_file_hold();
    int file = open(name, O_WRONLY | O_CREAT | O_EXCL, 0666);
    int bad = file < 0 || close(file) || unlink(name);
    int status = bad ? refuse_path(path, why) : STATUS_OK;
    atomic_file_release();
    return status;
}

static int put(int file, const char *bytes, size_t size) {
    while (size > 0) {
        ssize_t n = write(file, bytes, size);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return -1;
        bytes += n;
        size -= (size_t)n;
    }
    return 0;
}

static int remove_part(const char *name) {
    int error = errno;
    unlink(name);
    errno = error;
    return -1;
}

/* Writes the temporary file next to `path`, with the permissions of the old file.  Returns 0, or -1 with errno set
 * and nothing left behind. */
static int prepare(const char *path, const char *bytes, size_t size) {
    char name[PATH_LENGTH];
    struct stat was;
    if (beside(path, name)) return -1;
    int file = open(name, O_WRONLY | O_CREAT | O_EXCL, stat(path, &was) ? 0666 : was.st_mode & 0666);
    if (file < 0) return -1;
    int bad = put(file, bytes, size);
    bad = close(file) || bad;
    return bad ? remove_part(name) : 0;
}

/* Renames the part, or removes it. */
static int put_in_place(const char *path, int keep) {
    char name[PATH_LENGTH];
    if (beside(path, name)) return -1;
    if (keep && rename(name, path) == 0) return 0;
    return remove_part(name);
}

static int write_special(const struct atomic_file *f, struct failure *why) {
    int special = open(f->path, O_WRONLY | O_TRUNC);
    int bad = special < 0 || put(special, f->bytes, f->size);
    return bad || close(special) ? refuse_path(f->path, why) : STATUS_OK;
}

static char *real_path(const char *path) {
    char *real = realpath(path, NULL); /* so that a link stays a link */
    return xcheck(real || errno == ENOMEM ? real : strdup(path), PATH_LENGTH, 1);
}

static int write_all(const struct atomic_file *files, int count, char **real, struct failure *why) {
    int status = STATUS_OK, prepared = 0;
    for (int i = 0; i < count; i++) /* first, since the program ends where memory is out */
        if (!is_special(files[i].path)) real[i] = real_path(files[i].path);
    for (; prepared < count; prepared++) {
        const struct atomic_file *f = &files[prepared];
        if (real[prepared] && prepare(real[prepared], f->bytes, f->size)) {
            status = refuse_path(f->path, why);
            break;
        }
    }
    for (int i = 0; i < prepared; i++) {
        if (!real[i] && !status)
            status = write_special(&files[i], why);
        else if (real[i] && put_in_place(real[i], !status) && !status)
            status = refuse_path(files[i].path, why);
    }
    return status;
}

int atomic_file_write_all(const struct atomic_file *files, int count, struct failure *why) {
    char **real = xcalloc((size_t)count, sizeof *real);
    atomic_file_hold();
    int status = write_all(files, count, real, why);
    atomic_file_release();
    for (int i = 0; i < count; i++) free(real[i]);
    free(real);
    return status;
}
