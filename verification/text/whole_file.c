/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A file read in one piece, into room that doubles. */
#include "verification/text/whole_file.h"

#include "solver/status.h"
#include "verification/text/output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* 1 for a named pipe: opening it without a writer would block for ever.  The shell's <(...) is a pipe below /dev. */
static int is_named_pipe(const char *path) {
    struct stat is;
    return stat(path, &is) == 0 && S_ISFIFO(is.st_mode) && strncmp(path, "/dev/", 5) != 0 &&
           strncmp(path, "/proc/", 6) != 0;
}

FILE *whole_file_open(const char *path) {
    if (is_named_pipe(path)) {
        errno = ENOTSUP;
        return NULL;
    }
    FILE *in = fopen(path, "rb");
    if (!in && errno == ENOMEM) xcheck(NULL, 1, BUFSIZ);
    return in;
}

const char *whole_file_error(void) {
    return errno == ENOTSUP ? "a named pipe, where a file is wanted" : strerror(errno);
}

char *whole_file_read(FILE *in, size_t *size) {
    size_t room = 1 << 16, used = 0, got;
    char *text = xcalloc(room, 1);
    while ((got = fread(text + used, 1, room - used - 1, in)) > 0) {
        used += got;
        if (memchr(text + used - got, '\0', got) || output_noted()) break;
        if (used + 1 == room) text = xgrow(text, used, room *= 2, 1);
    }
    if (size) *size = used;
    return text;
}

char *whole_file_at(const char *path, size_t *size) {
    FILE *in = whole_file_open(path);
    if (!in) return NULL;
    char *text = whole_file_read(in, size);
    if (ferror(in)) {
        free(text);
        text = NULL;
    }
    fclose(in);
    return text;
}
