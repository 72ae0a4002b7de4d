/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Calls that end with a status, whatever happens inside them, and print numbers with a point in any locale.
 *
 * The solvers and references end the program where memory is out (solver/out_of_memory.c); here they jump back to the
 * call.  They run on one thread (the library is compiled without OpenMP), so that no other frame is skipped. */
#undef calloc
#undef realloc
#undef free
#include "references/library/guard.h"

#include "solver/status.h"
#include "solver/time/transform.h"

#include <gsl/gsl_errno.h>
#include <locale.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdlib.h>

/* Before each block; both NULL once it is kept. */
struct link {
    struct link *before, *after;
};

static pthread_mutex_t one_call = PTHREAD_MUTEX_INITIALIZER; /* guards all below */
static struct link blocks = {&blocks, &blocks};
static jmp_buf out_of_memory;

static void unlink_block(struct link *l) {
    if (!l->before) return;
    l->before->after = l->after;
    l->after->before = l->before;
    *l = (struct link){NULL, NULL};
}

static void *link_block(struct link *l) {
    if (!l) return NULL;
    *l = (struct link){&blocks, blocks.after};
    blocks.after->before = l;
    blocks.after = l;
    return l + 1;
}

void *guard_calloc(size_t count, size_t size) {
    if (size && count > ((size_t)-1 - sizeof(struct link)) / size) return NULL;
    return link_block(calloc(1, sizeof(struct link) + count * size));
}

void *guard_realloc(void *block, size_t size) {
    struct link *old = block ? (struct link *)block - 1 : NULL;
    if (old) unlink_block(old);
    struct link *l = realloc(old, sizeof *l + size);
    if (!l && old) link_block(old);
    return link_block(l);
}

void guard_free(void *block) {
    if (!block) return;
    unlink_block((struct link *)block - 1);
    free((struct link *)block - 1);
}

void *guard_keep(void *block) {
    if (block) unlink_block((struct link *)block - 1);
    return block;
}

void *xcheck(void *block, size_t count, size_t size) {
    (void)count, (void)size;
    if (!block) longjmp(out_of_memory, 1);
    return block;
}

/* Statuses of GSL are checked where they matter. */
static void gsl_failed(const char *reason, const char *file, int line, int error) {
    (void)reason, (void)file, (void)line;
    if (error == GSL_ENOMEM) longjmp(out_of_memory, 1);
}

int guard_call(int (*body)(void *argument, struct failure *why), void *argument, struct failure *why) {
    pthread_mutex_lock(&one_call);
    gsl_error_handler_t *host = gsl_set_error_handler(gsl_failed);
    locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0), before = c ? uselocale(c) : (locale_t)0;
    int status;
    if (setjmp(out_of_memory))
        status = refuse(why, STATUS_MEMORY, "out of memory");
    else
        status = body(argument, why);
    transform_forget();
    while (blocks.after != &blocks) guard_free(blocks.after + 1);
    gsl_set_error_handler(host);
    if (c) uselocale(before), freelocale(c);
    pthread_mutex_unlock(&one_call);
    return status;
}

/* The team of a library without OpenMP. */
int omp_get_num_threads(void);
int omp_get_thread_num(void);

int omp_get_num_threads(void) {
    return 1;
}

int omp_get_thread_num(void) {
    return 0;
}
