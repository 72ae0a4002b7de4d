/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A temporary directory. */
#include "verification/solve/scratch.h"

#include "solver/status.h"
#include "verification/text/shell.h"

#include <errno.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { DESCRIPTORS = 8 }; /* for the levels of a directory */

int scratch_open(struct scratch *s, struct failure *why) {
    const char *parent = getenv("TMPDIR");
    if (!parent || *parent != '/' || strlen(parent) > SCRATCH_PATH - 60 || !shell_is_plain(parent)) parent = "/tmp";
    snprintf(s->dir, sizeof s->dir, "%.195s/heatladder-XXXXXX", parent);
    if (mkdtemp(s->dir)) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "cannot make a directory in '%.195s': %s", parent, strerror(errno));
}

/* Gives a directory the permissions that removing its entries needs. */
static int open_up(const char *path, const struct stat *is, int type, struct FTW *at) {
    (void)is, (void)at;
    if ((type != FTW_D && type != FTW_DNR) || chmod(path, S_IRWXU) || type == FTW_D) return 0;
    return access(path, R_OK | X_OK) ? 0 : nftw(path, open_up, DESCRIPTORS, FTW_PHYS); /* not read before */
}

static int remove_one(const char *path, const struct stat *is, int type, struct FTW *at) {
    (void)is, (void)type, (void)at;
    remove(path);
    return 0;
}

void scratch_close(struct scratch *s) {
    nftw(s->dir, open_up, DESCRIPTORS, FTW_PHYS);
    nftw(s->dir, remove_one, DESCRIPTORS, FTW_DEPTH | FTW_PHYS);
}
