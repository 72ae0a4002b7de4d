/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_SCRATCH_PATH_H
#define HEATLADDER_VERIFICATION_UNIT_SCRATCH_PATH_H

/* Files and directories of a test, below TMPDIR. */

#include <stdio.h>
#include <stdlib.h>

enum { UNIT_PATH = 300 };

static inline char *scratch_template(char path[UNIT_PATH], const char *name) {
    const char *dir = getenv("TMPDIR");
    int length = snprintf(path, UNIT_PATH, "%.200s/%.60s.XXXXXX", dir && *dir ? dir : "/tmp", name);
    return length < UNIT_PATH ? path : NULL;
}

/* mkdtemp and mkstemp of NAME.XXXXXX; `path` is filled. */
static inline char *scratch_directory(char path[UNIT_PATH], const char *name) {
    return mkdtemp(scratch_template(path, name));
}

static inline int scratch_file(char path[UNIT_PATH], const char *name) {
    return mkstemp(scratch_template(path, name));
}

#endif
