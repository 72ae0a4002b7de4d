/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A C library that is out of memory from the FAIL_AT-th allocation on, or with FAIL_ONCE at that one alone (glibc):
 * preloaded by scripts/check_memory.  FAIL_COUNT is a file that gets the number of allocations. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

extern void *__libc_malloc(size_t size);
extern void *__libc_realloc(void *block, size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_memalign(size_t alignment, size_t size);

static long allocations = -1, limit = -2;
static int once;

static int fails(void) {
    if (limit == -2) {
        limit = -1;
        const char *text = getenv("FAIL_AT");
        limit = text ? atol(text) : -1;
        once = getenv("FAIL_ONCE") != NULL;
    }
    long at = __sync_add_and_fetch(&allocations, 1);
    if (limit < 0 || (once ? at != limit : at < limit)) return 0;
    errno = ENOMEM;
    return 1;
}

void *malloc(size_t size) {
    return fails() ? NULL : __libc_malloc(size);
}

void *realloc(void *block, size_t size) {
    return fails() ? NULL : __libc_realloc(block, size);
}

void *calloc(size_t count, size_t size) {
    return fails() ? NULL : __libc_calloc(count, size);
}

void *memalign(size_t alignment, size_t size) {
    return fails() ? NULL : __libc_memalign(alignment, size);
}

void *aligned_alloc(size_t alignment, size_t size) {
    return memalign(alignment, size);
}

int posix_memalign(void **block, size_t alignment, size_t size) {
    void *found = memalign(alignment, size);
    if (found) *block = found;
    return found ? 0 : ENOMEM;
}

__attribute__((destructor)) static void tell(void) {
    const char *path = getenv("FAIL_COUNT");
    FILE *out = path ? fopen(path, "w") : NULL;
    if (out) fprintf(out, "%ld\n", allocations);
    if (out) fclose(out);
}
