/* Files in memory (POSIX open_memstream), put in place whole. */
#include "verification/text/output.h"

#include "solver/status.h"
#include "verification/text/atomic_file.h"

#include <stdarg.h>
#include <stdlib.h>
#include <sys/stat.h>

static int path_of(char *path, size_t size, struct failure *why, const char *format, va_list arguments) {
    int length = vsnprintf(path, size, format, arguments);
    if (length >= 0 && (size_t)length < size) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "the path '%.100s...' is too long", path);
}

int output_open(struct output *o, struct failure *why, const char *path, ...) {
    va_list arguments;
    *o = (struct output){0};
    va_start(arguments, path);
    int status = path_of(o->path, sizeof o->path, why, path, arguments);
    va_end(arguments);
    if (status) return status;
    o->out = open_memstream(&o->text, &o->size);
    return o->out ? STATUS_OK : refuse(why, STATUS_NUMERICAL, "out of memory for '%.200s'", o->path);
}

void output_end(struct output *o) {
    if (!o->out) return;
    int failed = ferror(o->out);
    if (fclose(o->out) || failed) { /* out of memory */
        free(o->text);
        o->text = NULL;
    }
    o->out = NULL;
}

int output_close(struct output *o, int count, struct failure *why) {
    struct atomic_file *file = xcalloc((size_t)count, sizeof *file);
    int status = STATUS_OK;
    for (int i = 0; i < count; i++) {
        output_end(&o[i]);
        file[i] = (struct atomic_file){o[i].path, o[i].text, o[i].size};
        if (!o[i].text) status = refuse(why, STATUS_NUMERICAL, "out of memory for '%.200s'", o[i].path);
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

static int join(char *path, size_t size, struct failure *why, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    int status = path_of(path, size, why, format, arguments);
    va_end(arguments);
    return status;
}

int output_directory(const char *dir, const char *name, struct failure *why) {
    char path[1024];
    if (join(path, sizeof path, why, "%s/%s", dir, name)) return why->status;
    mkdir(dir, 0777); /* the check tells where it cannot be made */
    return atomic_file_check(path, why);
}
