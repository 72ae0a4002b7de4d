/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files in memory, then moved into place as a whole.  POSIX has open_memstream, but glibc's drops data when memory
 * runs out, without an error from ferror or fclose.  This stream ends the program instead (fopencookie: glibc,
 * musl). */
#define _GNU_SOURCE
#include "verification/text/output.h"

#include "solver/status.h"
#include "verification/text/atomic_file.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static int refuse_path(const char *path, struct failure *why) {
    return refuse(why, STATUS_INPUT, "the path '%.100s...' is too long", path);
}

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

int output_close(struct output *o, int count, struct failure *why) {
    struct atomic_file *file = xcalloc((size_t)count, sizeof *file);
    int status = STATUS_OK;
    for (int i = 0; i < count; i++) {
        output_end(&o[i]);
        file[i] = (struct atomic_file){o[i].path, o[i].text, o[i].size};
        if (o[i].too_long) status = refuse_path(o[i].path, why);
    }
    if (!status) status = atomic_file_write_all(file, count, why);
    output_drop(o, count);
    free(file);
    return status;
}

void output_drop(struct output *o, int count) {
    for (int i = 0; i < count; i++) {
        output_end(&o[i]);
        free(o[i].text);
        o[i] = (struct output){0};
    }
}

int output_directory(const char *dir, const char *name, struct failure *why) {
    char path[1024];
    if ((size_t)snprintf(path, sizeof path, "%s/%s", dir, name) >= sizeof path) return refuse_path(path, why);
    int error = mkdir(dir, 0777) ? errno : EEXIST;
    if (!atomic_file_check(path, why)) return STATUS_OK;
    return error == EEXIST
               ? why->status
               : refuse(why, STATUS_INPUT, "cannot make the directory '%.300s': %s", dir, strerror(error));
}
