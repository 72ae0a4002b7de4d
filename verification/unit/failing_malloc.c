/* A C library that is out of memory from the FAIL_AT-th allocation on (glibc): preloaded by scripts/check_program. */
#include <errno.h>
#include <stdlib.h>

extern void *__libc_malloc(size_t size);
extern void *__libc_realloc(void *block, size_t size);
extern void *__libc_calloc(size_t count, size_t size);

static long allocations = -1, limit = -2;

static int fails(void) {
    if (limit == -2) {
        limit = -1;
        const char *text = getenv("FAIL_AT");
        limit = text ? atol(text) : -1;
    }
    if (limit < 0 || __sync_add_and_fetch(&allocations, 1) < limit) return 0;
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
