/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A directory that is removed when its run ends, however either ends. */
#include "verification/solve/scratch.h"

#include "solver/status.h"
#include "verification/text/shell.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

/* $0 is the directory.  rm fails if another process writes into it meanwhile, and is then repeated. */
static const char guard[] = "read -r group; read -r end\n"
                            "[ -z \"$group\" ] || kill -s KILL -- \"-$group\" 2>/dev/null\n"
                            "for try in 1 2 3; do rm -rf -- \"$0\" 2>/dev/null && exit\n"
                            "chmod -R u+rwx -- \"$0\" 2>/dev/null; done";

static int start_guard(struct scratch *s, const int ends[2]) {
    char *argv[] = {"sh", "-c", (char *)guard, s->dir, NULL};
    posix_spawn_file_actions_t files;
    posix_spawnattr_t how;
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&how);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP); /* out of reach of signals from the terminal */
    int error = posix_spawn_file_actions_adddup2(&files, ends[0], STDIN_FILENO);
    if (!error) error = posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    if (!error) error = posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    if (!error) error = posix_spawn(&s->guard, "/bin/sh", &files, &how, argv, environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&how);
    return error;
}

int scratch_descriptor(int descriptor) {
    enum { ABOVE = 10 };
    int raised = fcntl(descriptor, F_DUPFD_CLOEXEC, ABOVE);
    if (raised >= 0) close(descriptor);
    return raised;
}

int scratch_open(struct scratch *s, struct failure *why) {
    const char *parent = getenv("TMPDIR");
    int ends[2] = {-1, -1}, error = 0;
    if (!parent || *parent != '/' || strlen(parent) > SCRATCH_PATH - 60 || !shell_is_plain(parent)) parent = "/tmp";
    snprintf(s->dir, sizeof s->dir, "%.195s/heatladder-XXXXXX", parent);
    if (!mkdtemp(s->dir))
        return refuse(why, STATUS_INPUT, "cannot make a directory in '%.195s': %s", parent, strerror(errno));
#pragma omp critical(                                                                                                \
    foreign_spawn) /* no other program may inherit an end of the pipe before it is marked close-on-exec */
    {
        if (pipe(ends)) error = errno;
        for (int i = 0; i < 2 && !error; i++)
            if ((ends[i] = scratch_descriptor(ends[i])) < 0) error = errno;
        if (!error) error = start_guard(s, ends);
    }
    if (ends[0] >= 0) close(ends[0]);
    s->pipe = ends[1];
    if (!error) return STATUS_OK;
    if (ends[1] >= 0) close(ends[1]);
    rmdir(s->dir);
    return refuse(why, STATUS_INPUT, "cannot run /bin/sh: %s", strerror(error));
}

void scratch_close(struct scratch *s) {
    close(s->pipe);
    while (waitpid(s->guard, NULL, 0) < 0 && errno == EINTR) continue;
}
