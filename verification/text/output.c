/* Files in memory (POSIX open_memstream), put in place whole. */
#include "verification/text/output.h"

#include "solver/status.h"
#include "verification/text/atomic_file.h"

#include <stdarg.h>
#include <stdlib.h>
#include <sys/stat.h>

static int refuse_path(const char *path, struct failure *why) {
    return refuse(why, STATUS_INPUT, "the path '%.100s...' is too long", path);
}

FILE *output_open(struct output *o, const char *path, ...) {
    va_list arguments;
    *o = (struct output){0};
    va_start(arguments, path);
    int length = vsnprintf(o->path, sizeof o->path, path, arguments);
    va_end(arguments);
    o->too_long = length < 0 || (size_t)length >= sizeof o->path;
    return o->out = xcheck(open_memstream(&o->text, &o->size), 1, BUFSIZ);
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
        if (o[i].too_long) status = refuse_path(o[i].path, why);
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

int output_directory(const char *dir, const char *name, struct failure *why) {
    char path[1024];
    if ((size_t)snprintf(path, sizeof path, "%s/%s", dir, name) >= sizeof path) return refuse_path(path, why);
    mkdir(dir, 0777); /* the check tells where it cannot be made */
    return atomic_file_check(path, why);
}
