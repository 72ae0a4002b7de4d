#ifndef HEATLADDER_VERIFICATION_TEXT_OUTPUT_H
#define HEATLADDER_VERIFICATION_TEXT_OUTPUT_H

/* A file written in memory, then put in its place whole (atomic_file.h).
 *
 *     if (output_open(&page, why, "%s/%s.csv", dir, name)) return why->status;
 *     fprintf(page.out, ...);
 *     return output_close(&page, 1, why); */

#include <stdio.h>

struct failure;

struct output {
    FILE *out; /* to be written to; NULL once closed */
    char path[1024], *text;
    size_t size;
};

/* Opens a file in memory; its place is a path, printf-like.  STATUS_OK, or with *why filled STATUS_INPUT (the path is
 * too long) or STATUS_NUMERICAL (no memory). */
int output_open(struct output *o, struct failure *why, const char *path, ...) __attribute__((format(printf, 3, 4)));

/* Ends the writing: `text` is what was written.  Not needed before output_close. */
void output_end(struct output *o);

/* Puts `count` files that belong together in their places, or with *why filled none of them.  Frees them. */
int output_close(struct output *o, int count, struct failure *why);

/* Frees them without a trace; also where some were never opened (zeroed). */
void output_drop(struct output *o, int count);

/* Makes the directory where it is not there, and checks that `name` can be written in it. */
int output_directory(const char *dir, const char *name, struct failure *why);

#endif
