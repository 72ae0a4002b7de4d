/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Statuses, failures and memory. */
#include "solver/status.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int status_exit(int status) {
    return status == STATUS_NOT_APPLICABLE ? STATUS_INPUT : status == STATUS_UNSTABLE ? STATUS_NUMERICAL : status;
}

int status_refused(int status) {
    return status == STATUS_INPUT || status == STATUS_NOT_APPLICABLE;
}

int refuse(struct failure *f, int status, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(f->text, sizeof f->text, format, arguments);
    va_end(arguments);
    f->status = status;
    f->exchanged = 0;
    return status;
}

void *xcalloc(size_t count, size_t size) {
    return xcheck(calloc(count ? count : 1, size), count, size);
}

void *xgrow(void *old, size_t used, size_t count, size_t size) {
    void *block = xcalloc(count, size);
    if (used) memcpy(block, old, used * size);
    free(old);
    return block;
}
