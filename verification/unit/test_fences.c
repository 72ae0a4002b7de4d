/* SPDX-License-Identifier: GPL-3.0-or-later */
/* No array is read or written past its end.
 *
 * The allocator of this program puts a fence of NaN behind every block and fills with NaN the memory that malloc
 * returns and free releases.  A write past the end is detected when the block is freed; a read past the end, or of
 * uninitialized memory, makes the error of the run NaN.  Sanitizers detect more if they are available; this test is
 * part of every `make test`. */
#include "verification/case/command.h"
#include "verification/judge/run.h"

#include "verification/unit/near.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int broken; /* blocks whose fence was overwritten */

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define FENCED 1
#include <errno.h>
#include <malloc.h>

enum { FENCE = 64 }; /* bytes behind a block, at least; the last ones hold its size */

void *__libc_malloc(size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *block);

static size_t *size_of(char *block) {
    return (size_t *)(void *)(block + malloc_usable_size(block) / sizeof(size_t) * sizeof(size_t)) - 1;
}

static void *fence(char *block, size_t size) {
    if (!block) return NULL;
    memset(block, 0xff, malloc_usable_size(block));
    *size_of(block) = size;
    return block;
}

static void *take(size_t size) {
    return size < SIZE_MAX / 2 ? fence(__libc_malloc(size + FENCE), size) : NULL;
}

void *malloc(size_t size) {
    return take(size);
}

void *memalign(size_t alignment, size_t size) {
    return fence(__libc_memalign(alignment, size + FENCE), size);
}

void *calloc(size_t count, size_t size) {
    if (size && count > SIZE_MAX / 2 / size) return NULL;
    void *block = take(count * size); /* the compiler would merge malloc and memset into calloc */
    return block ? memset(block, 0, count * size) : NULL;
}

void free(void *block) {
    if (!block) return;
    const unsigned char *end = (unsigned char *)size_of(block);
    for (unsigned char *c = (unsigned char *)block + *size_of(block); c < end; c++)
        if (*c != 0xff) {
            __atomic_add_fetch(&broken, 1, __ATOMIC_RELAXED);
            break;
        }
    memset(block, 0xff, malloc_usable_size(block));
    __libc_free(block);
}

void *realloc(void *block, size_t size) {
    void *moved = take(size);
    if (!block || !moved) return moved;
    memcpy(moved, block, *size_of(block) < size ? *size_of(block) : size);
    free(block);
    return moved;
}

void *aligned_alloc(size_t alignment, size_t size) {
    return memalign(alignment, size);
}

int posix_memalign(void **block, size_t alignment, size_t size) {
    *block = memalign(alignment, size);
    return *block ? 0 : ENOMEM;
}
#else
#define FENCED 0
#endif

static void stays_inside(const char *line) {
    struct command r;
    struct failure why;
    struct result result;
    int before = broken;
    if (command_read(line, &r, &why)) fail_msg("%s: %s", line, why.text);
    if (run_experiment(&r.experiment, &result, NULL)) fail_msg("%s: %s", line, result.failure.text);
    command_free(&r);
    if (!(isfinite(result.error[NORM_L1]) && isfinite(result.error[NORM_LINF])))
        fail_msg("%s: E1 %g", line, result.error[NORM_L1]);
    if (broken > before) fail_msg("%s: %d blocks were written to past their end", line, broken - before);
}

static void runs_stay_within_their_arrays(void **state) {
    (void)state;
    static const char *const line[] = {
        "run rod-step so_ssph --dx 0.05",
        "run rod-step fo_ssph --dx 0.05 --stepper euler --fourier 0.2",
        "run rod-gauss so_ssph --dx 0.5 --order 4 --h 2.2",
        "run rod-cosine so_ssph --dx 0.05 --stepper rk2 --dt 0.01",
        "run rod-cosine ftcs_flux --dx 0.05 --layout node --fourier 0.4",
        "run rod-contact brookshaw --dx 0.02 --mean series --set x_c=0.013",
        "run rod-contact ftcs --dx 0.02 --fourier 0.2",
        "run plane-contact ftcs --dx 0.05 --mean series --set w1=0.41 --set w2=0.59 --fourier 0.2",
        "run rod-gauss ftcs --dx 0.25 --stepper matched --sampling spline",
        "run rod-cooling so_ssph --dx 0.05",
        "run plate so_ssph --dx 0.01 --stepper rkl2 --dt 0.3",
        "run plate fo_ssph --dx 0.01 --stepper exact",
        "run plate brookshaw --dx 0.01 --walls fixed --stepper euler --fourier 0.1",
        "run square-step so_ssph --dx 0.2 --stepper matched --h iso --set kappa_y=0.0025 --sampling spline",
        "run square-step so_ssph --dx 0.2 --layout jitter --jitter 0.2 --stepper rkl2 --dt 0.5",
        "run square-step ftcs --dx 0.2 --fourier 0.2 --sampling cell",
        "run rect-manufactured so_ssph --dx 0.05 --stepper exact",
        "run rect-manufactured fatehi_manzari --dx 0.05 --layout relaxed --jitter 0.2",
        "run rect-manufactured ftcs --dx 0.05 --fourier 0.1",
        "run plate-cooling so_ssph --dx 0.05",
    };
    for (size_t i = 0; i < sizeof line / sizeof *line; i++) stays_inside(line[i]);
}

/* The fences themselves. */
static void writes_past_an_array_are_detected(void **state) {
    (void)state;
    if (!FENCED) skip();
    int before = broken;
    volatile unsigned char *volatile block = malloc(13); /* so that the compiler does not know */
    assert_true(block[12] == 0xff);
    block[13] = 1;
    free((void *)block);
    assert_int_equal(broken, before + 1);
    volatile double *volatile past = calloc(3, sizeof *past);
    assert_true(past[2] == 0 && isnan(past[3]));
    free((void *)past);
    assert_int_equal(broken, before + 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(writes_past_an_array_are_detected),
                                       cmocka_unit_test(runs_stay_within_their_arrays)};
    return cmocka_run_group_tests_name("fences", tests, NULL, NULL);
}
