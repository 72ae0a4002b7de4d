/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A program has ended when no process of its group is left.  Waiting for the shell alone would let this program read
 * what a background process is still writing. */
#include "verification/solve/process.h"

#include "solver/status.h"
#include "solver/words.h"
#include "verification/text/output.h"
#include "verification/text/utf8.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <omp.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

enum { LINE = 400, SAID = 3, QUOTED = 120, SKIPPED = 77, OVERDUE = 124, SIGNALLED = 128 };
static const double GRACE = 2;  /* s that processes started by a program may outlive it */
static const double MERCY = 1;  /* s from SIGTERM to SIGKILL */
static const int PATIENCE = 20; /* ms between two looks */
enum {
    AT_ONCE = 4,
    AT_END = 512
}; /* blocks of output per look; and a number that exceeds the capacity of any pipe */

enum end { ENDED, LEFT_OTHERS, TIMED_OUT, INTERRUPTED };

struct running {
    const struct process *process;
    pid_t child;
    int output;         /* read end of the pipe that it prints to; -1 once that has ended */
    int reaped, status; /* the state of the shell */
    double start, end;  /* s */
    char line[LINE];    /* the line being printed */
    size_t length;
    char said[SAID][QUOTED + 1]; /* the last lines that are not blank, the newest last */
};

/* $0 is the command, $1 its TMPDIR. */
static int spawn(struct running *r, int out) {
    char *argv[] = {
        "sh", "-c", "TMPDIR=\"$1\" exec /bin/sh -c \"$0\"", (char *)r->process->command, (char *)r->process->dir,
        NULL};
    posix_spawn_file_actions_t files;
    posix_spawnattr_t how;
    sigset_t ignored; /* ignored by this program, not by the command */
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&how);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    sigemptyset(&ignored);
    sigaddset(&ignored, SIGXFSZ);
    posix_spawnattr_setsigdefault(&how, &ignored);
    int error = posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (!error) error = posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
    if (!error) error = posix_spawn_file_actions_adddup2(&files, out, STDERR_FILENO);
    if (!error) error = posix_spawn(&r->child, "/bin/sh", &files, &how, argv, environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&how);
    return error;
}

/* Returns 0 or an errno. */
static int start(struct running *r) {
    int ends[2];
    if (pipe(ends)) return errno;
    for (int i = 0; i < 2; i++) fcntl(ends[i], F_SETFD, FD_CLOEXEC);
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    r->output = ends[0];
    int error = spawn(r, ends[1]);
    close(ends[1]);
    r->start = omp_get_wtime();
    return error;
}

/* A line of a stack: "  File ...", " at Main.main(...)", "#1 ...".  Fortran begins a line of text with one blank. */
static int is_frame(const char *line) {
    return strncmp(line, "  ", 2) == 0 || strncmp(line, " at ", 4) == 0 ||
           (*line == '#' && isdigit((unsigned char)line[1]));
}

/* The reason is the last line of C or Python, but Java and Fortran print a stack after it and Rust a note: the last
 * lines are quoted, without a stack. */
static void keep_line(struct running *r, const char *line) {
    if (!line[strspn(line, " ")] || (*r->said[SAID - 1] && is_frame(line))) return;
    memmove(r->said[0], r->said[1], sizeof r->said - sizeof r->said[0]);
    snprintf(r->said[SAID - 1], sizeof r->said[0], "%.*s", QUOTED, line + strspn(line, " "));
    utf8_clean(r->said[SAID - 1]); /* a character may be cut */
}

/* Prints the first `length` bytes of the line, cleaned: the text is foreign and must not control the terminal. */
static void print_line(struct running *r, size_t length) {
    char rest[LINE];
    size_t more = r->length - length;
    memcpy(rest, r->line + length, more);
    r->line[length] = '\0';
    utf8_clean(r->line);
    fprintf(stderr, "%s: %s\n", r->process->label, r->line);
    keep_line(r, r->line);
    memcpy(r->line, rest, r->length = more);
}

static void take_text(struct running *r, const char *text, size_t n) {
    for (size_t i = 0; i < n; i++) {
        if (text[i] == '\n') {
            print_line(r, r->length);
            continue;
        }
        if (r->length == LINE - 1) print_line(r, r->length);
        r->line[r->length++] = (unsigned char)text[i] < ' ' ? ' ' : text[i];
    }
}

/* Passes on what the program has printed so far, with lines longer than the buffer in parts.  It reads at most
 * `most` blocks: a program that prints without end would otherwise keep the caller from timeouts and interrupts. */
static void pass_on(struct running *r, int most) {
    char text[4096];
    ssize_t n = 1;
    while (most-- > 0 && r->output >= 0 && (n = read(r->output, text, sizeof text)) > 0) {
        if (r->process->log) fwrite(text, 1, (size_t)n, r->process->log);
        take_text(r, text, (size_t)n);
    }
    if (n > 0 || (n < 0 && (errno == EAGAIN || errno == EINTR))) return;
    close(r->output);
    r->output = -1;
}

/* Waits a little, at most until there is output; returns 1 if the whole group has ended.  Its processes become
 * children of this program where that is the first of a container. */
static int look(struct running *r) {
    int status;
    pid_t ended;
    poll(&(struct pollfd){.fd = r->output, .events = POLLIN}, 1, r->output < 0 ? 1 : PATIENCE);
    pass_on(r, AT_ONCE);
    while ((ended = waitpid(-r->child, &status, WNOHANG)) > 0)
        if (ended == r->child) r->reaped = 1, r->status = status, r->end = omp_get_wtime();
    return r->reaped && kill(-r->child, 0) != 0;
}

static enum end follow(struct running *r) {
    for (;;) {
        if (look(r)) return ENDED;
        if (output_noted()) return INTERRUPTED;
        if (r->reaped && omp_get_wtime() > r->end + GRACE) return LEFT_OTHERS;
        if (r->process->timeout > 0 && omp_get_wtime() > r->start + r->process->timeout) return TIMED_OUT;
    }
}

static void terminate(struct running *r) {
    double deadline = omp_get_wtime() + MERCY;
    kill(-r->child, SIGTERM);
    while (omp_get_wtime() < deadline)
        if (look(r)) return;
    kill(-r->child, SIGKILL);
    while (!r->reaped) look(r);
}

static void quote(const struct running *r, char *text, size_t size) {
    *text = '\0';
    for (int i = 0; i < SAID; i++)
        if (*r->said[i]) words_add(text, size, "%s%s", *text ? " | " : "; it said last: ", r->said[i]);
}

static int judge(const struct running *r, enum end end, struct failure *why) {
    char said[SAID * (QUOTED + 3) + 20];
    int status = r->status;
    quote(r, said, sizeof said);
    if (end == INTERRUPTED)
        return refuse(why, STATUS_NUMERICAL, "--solver: interrupted by signal %d", output_noted());
    if (end == TIMED_OUT)
        return refuse(why, STATUS_NUMERICAL, "--solver: not done after %g s (--timeout)%s", r->process->timeout,
                      said);
    if (WIFSIGNALED(status))
        return refuse(why, STATUS_NUMERICAL, "--solver: ended by signal %d%s", WTERMSIG(status), said);
    status = WEXITSTATUS(status);
    if (status == SKIPPED) return refuse(why, STATUS_SKIPPED, PROCESS_DECLINED "%s", said);
    if (status == 126 || status == 127)
        return refuse(why, STATUS_INPUT, "--solver: the program could not be run (exit status %d)%s", status, said);
    if (status) return refuse(why, STATUS_NUMERICAL, "--solver: exit status %d%s", status, said);
    if (end == LEFT_OTHERS)
        return refuse(why, STATUS_NUMERICAL,
                      "--solver: ended before what it had started, so that its answer may be unfinished (end the "
                      "command with `wait`)");
    return STATUS_OK;
}

static int code_of(const struct running *r, enum end end) {
    if (end == INTERRUPTED || end == LEFT_OTHERS) return -1;
    if (end == TIMED_OUT) return OVERDUE;
    return WIFSIGNALED(r->status) ? SIGNALLED + WTERMSIG(r->status) : WEXITSTATUS(r->status);
}

int process_declined(const char *reason) {
    return strncmp(reason, PROCESS_DECLINED, strlen(PROCESS_DECLINED)) == 0;
}

int process_run(const struct process *p, struct failure *why) {
    struct running *r = xcalloc(1, sizeof *r);
    *r = (struct running){.process = p, .output = -1};
    int error = start(r), status;
    if (error) {
        status = refuse(why, STATUS_INPUT, "--solver '%.200s': %s", p->command, strerror(error));
    } else {
        enum end end = follow(r);
        if (end != ENDED) terminate(r);
        pass_on(r, AT_END);
        if (r->length) print_line(r, r->length);
        status = judge(r, end, why);
        *p->code = code_of(r, end);
    }
    if (r->output >= 0) close(r->output);
    free(r);
    return status;
}
