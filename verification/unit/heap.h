/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_HEAP_H
#define HEATLADDER_VERIFICATION_UNIT_HEAP_H

/* Counts the heap allocations of a test program, including libraries: these functions replace those of the C
 * library.  If a sanitizer manages the heap, or the library is another, HEAP_COUNTED is 0 and nothing is counted. */

#include <stdlib.h>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define HEAP_COUNTED 1
#include <errno.h>
#include <malloc.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *block, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *block);

static size_t heap_now, heap_most;

static void *heap_add(void *block) {
    size_t now = __atomic_add_fetch(&heap_now, malloc_usable_size(block), __ATOMIC_RELAXED);
    if (now > heap_most) heap_most = now; /* tests that read it have one thread */
    return block;
}

static void heap_take(void *block) {
    __atomic_sub_fetch(&heap_now, malloc_usable_size(block), __ATOMIC_RELAXED);
}

void *malloc(size_t size) {
    return heap_add(__libc_malloc(size));
}

void *calloc(size_t count, size_t size) {
    return heap_add(__libc_calloc(count, size));
}

void *realloc(void *block, size_t size) {
    heap_take(block);
    return heap_add(__libc_realloc(block, size));
}

void *memalign(size_t alignment, size_t size) {
    return heap_add(__libc_memalign(alignment, size));
}

void *aligned_alloc(size_t alignment, size_t size) {
    return memalign(alignment, size);
}

int posix_memalign(void **block, size_t alignment, size_t size) {
    *block = memalign(alignment, size);
    return *block ? 0 : ENOMEM;
}

void free(void *block) {
    heap_take(block);
    __libc_free(block);
}

/* Blocks are not mapped by pages of their own then: each counts for its size, and at most 24 bytes more. */
static void heap_begin(void) {
    mallopt(M_MMAP_MAX, 0);
}

#else
#define HEAP_COUNTED 0
static size_t heap_now, heap_most;
static void heap_begin(void) {
}
#endif

#endif
