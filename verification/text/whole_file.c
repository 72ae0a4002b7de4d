/* A file read in one piece, into room that doubles. */
#include "verification/text/whole_file.h"

#include "solver/status.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

FILE *whole_file_open(const char *path) {
    FILE *in = fopen(path, "rb");
    if (!in && errno == ENOMEM) xcheck(NULL, 1, BUFSIZ);
    return in;
}

char *whole_file_read(FILE *in, size_t *size) {
    size_t room = 1 << 16, used = 0, got;
    char *text = xcalloc(room, 1);
    while ((got = fread(text + used, 1, room - used - 1, in)) > 0) {
        used += got;
        if (memchr(text + used - got, '\0', got)) break;
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
