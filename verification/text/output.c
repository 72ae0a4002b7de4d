/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files are written in memory, then put in their places whole.
 *
 * POSIX has open_memstream, but glibc's drops data when memory runs out, without an error from ferror or fclose. This
 * stream ends the program instead (fopencookie: glibc, musl).  rename() replaces a file in one step (POSIX), so a
 * reader sees either the old text or the new one.  All bytes are in memory before the file is opened, and interrupts
 * wait during the short writing, so no partial file remains.  Files that belong together are all written under
 * temporary names first; only a few renames separate the first from the last. */
#define _GNU_SOURCE
#include "verification/text/output.h"

#include "solver/status.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PATH_LENGTH = 4096, INTERRUPTS = 3 };

/* ---- Interrupts ---- */

/* A thread's signal mask would not hold interrupts, as any other thread may take them: handlers of the whole process
 * note them.  poll() and sleep return early then, so that a waiting caller sees them at once. */
static const int interrupts[INTERRUPTS] = {SIGINT, SIGTERM, SIGHUP};
static atomic_int noted; /* the last interrupt that waits; a handler can reach nothing else */
static int held;         /* calls of hold without release */
static struct sigaction before[INTERRUPTS];

static void note(int signal) {
    atomic_store(&noted, signal);
}

void output_hold(void) {
    struct sigaction wait = {.sa_handler = note};
    sigemptyset(&wait.sa_mask);
#pragma omp critical(output_hold)
    {
        for (int k = 0; held == 0 && k < INTERRUPTS; k++) {
            sigaction(interrupts[k], NULL, &before[k]);
            if (before[k].sa_handler != SIG_IGN) sigaction(interrupts[k], &wait, NULL);
        }
        held++;
    }
}

int output_noted(void) {
    return atomic_load(&noted);
}

void output_release(void) {
    int signal = 0;
#pragma omp critical(output_hold)
    {
        if (--held == 0) {
            for (int k = 0; k < INTERRUPTS; k++) sigaction(interrupts[k], &before[k], NULL);
            signal = atomic_exchange(&noted, 0);
        }
    }
    if (signal) raise(signal);
}

/* ---- Places ---- */

static int refuse_path(const char *path, struct failure *why) {
    return refuse(why, STATUS_INPUT, "cannot write '%.300s': %s", path, strerror(errno));
}

static int is_standard(const char *path) {
    return strcmp(path, "-") == 0;
}

/* The files of `-` go to a copy of standard output, and the text of the program to standard error. */
enum { STANDARD = 63 };

static int claim_standard(struct failure *why) {
    fflush(stdout);
    if (fcntl(STANDARD, F_GETFD) != -1)
        return refuse(why, STATUS_INPUT, "-: standard output takes one file, the others need names");
    if (fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STANDARD) != STANDARD || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
        return refuse_path("-", why);
    return STATUS_OK;
}

int output_folders(const char *path, struct failure *why) {
    char folder[PATH_LENGTH];
    if ((size_t)snprintf(folder, sizeof folder, "%s", path) >= sizeof folder) {
        errno = ENAMETOOLONG;
        return refuse_path(path, why);
    }
    for (char *slash = folder; (slash = strchr(slash + 1, '/'));) {
        *slash = '\0';
        if (mkdir(folder, 0777) && errno != EEXIST)
            return refuse(why, STATUS_INPUT, "cannot make the directory '%.300s': %s", folder, strerror(errno));
        *slash = '/';
    }
    return STATUS_OK;
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

int output_check(const char *path, struct failure *why) {
    char name[PATH_LENGTH];
    if (!path) return STATUS_OK;
    if (is_standard(path)) return claim_standard(why);
    if (output_folders(path, why)) return why->status;
    if (is_special(path)) {
        int special = open(path, O_WRONLY);
        return special < 0 || close(special) ? refuse_path(path, why) : STATUS_OK;
    }
    if (beside(path, name)) return refuse_path(path, why);
    output_hold();
    int file = open(name, O_WRONLY | O_CREAT | O_EXCL, 0666);
    int bad = file < 0 || close(file) || unlink(name);
    int status = bad ? refuse_path(path, why) : STATUS_OK;
    output_release();
    return status;
}

int output_directory(const char *dir, const char *name, struct failure *why) {
    char path[PATH_LENGTH];
    if ((size_t)snprintf(path, sizeof path, "%s/%s", dir, name) >= sizeof path) errno = ENAMETOOLONG, *path = '\0';
    return *path ? output_check(path, why) : refuse_path(dir, why);
}

/* ---- In memory ---- */

struct memory { /* contents of a stream; text and size belong to the caller */
    char **text;
    size_t *size, room;
};

static ssize_t memory_write(void *cookie, const char *bytes, size_t count) {
    struct memory *m = cookie;
    size_t used = *m->size, least = used + count + 1;
    if (least > m->room) {
        m->room = least > 2 * m->room ? least : 2 * m->room;
        *m->text = xgrow(*m->text, used, m->room, 1);
    }
    memcpy(*m->text + used, bytes, count);
    *m->size += count;
    (*m->text)[*m->size] = '\0';
    return (ssize_t)count;
}

static int memory_close(void *cookie) {
    free(cookie);
    return 0;
}

FILE *output_stream(char **text, size_t *size) {
    struct memory *m = xcalloc(1, sizeof *m);
    *m = (struct memory){text, size, BUFSIZ};
    *text = xcalloc(BUFSIZ, 1);
    *size = 0;
    return xcheck(fopencookie(m, "w", (cookie_io_functions_t){.write = memory_write, .close = memory_close}), 1,
                  BUFSIZ);
}

FILE *output_open(struct output *o, const char *path, ...) {
    va_list arguments;
    *o = (struct output){0};
    va_start(arguments, path);
    int length = vsnprintf(o->path, sizeof o->path, path, arguments);
    va_end(arguments);
    o->too_long = length < 0 || (size_t)length >= sizeof o->path;
    return o->out = output_stream(&o->text, &o->size);
}

void output_end(struct output *o) {
    if (o->out) fclose(o->out);
    o->out = NULL;
}

void output_drop(struct output *o, int count) {
    for (int i = 0; i < count; i++) {
        output_end(&o[i]);
        free(o[i].text);
        o[i] = (struct output){0};
    }
}

/* ---- Into place ---- */

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

static int write_special(const struct output *o, struct failure *why) {
    int standard = is_standard(o->path), to = standard ? STANDARD : open(o->path, O_WRONLY | O_TRUNC);
    int bad = to < 0 || put(to, o->text, o->size);
    return bad || (!standard && close(to)) ? refuse_path(o->path, why) : STATUS_OK;
}

static char *real_path(const char *path) {
    char *real = realpath(path, NULL); /* so that a link stays a link */
    return xcheck(real || errno == ENOMEM ? real : strdup(path), PATH_LENGTH, 1);
}

/* real: NULL for a special file. */
static int write_all(const struct output *o, int count, char **real, struct failure *why) {
    int status = STATUS_OK, prepared = 0;
    for (; prepared < count && !status; prepared += !status)
        if (real[prepared] && prepare(real[prepared], o[prepared].text, o[prepared].size))
            status = refuse_path(o[prepared].path, why);
    for (int i = 0; i < prepared; i++) {
        if (!real[i] && !status)
            status = write_special(&o[i], why);
        else if (real[i] && put_in_place(real[i], !status) && !status)
            status = refuse_path(o[i].path, why);
    }
    return status;
}

int output_close(struct output *o, int count, struct failure *why) {
    char **real = xcalloc((size_t)count, sizeof *real);
    int status = STATUS_OK;
    for (int i = 0; i < count; i++) { /* memory for the paths first, since the program ends where it runs out */
        output_end(&o[i]);
        if (o[i].too_long) status = refuse(why, STATUS_INPUT, "the path '%.100s...' is too long", o[i].path);
        if (!is_standard(o[i].path) && !is_special(o[i].path)) real[i] = real_path(o[i].path);
    }
    output_hold();
    if (!status) status = write_all(o, count, real, why);
    output_release();
    for (int i = 0; i < count; i++) free(real[i]);
    free(real);
    output_drop(o, count);
    return status;
}
