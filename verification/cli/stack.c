/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The limits of stacks. */
#include "verification/cli/stack.h"

#include "solver/status.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

double stack_size(const char *text) {
    char *end;
    long number = strtol(text, &end, 10);
    if (end == text || number < 0) return -1;
    end += strspn(end, " \t");
    char unit = *end ? (char)toupper((unsigned char)*end++) : 'K';
    end += strspn(end, " \t");
    static const char units[] = "BKMG";
    static const double kilobytes[] = {1.0 / 1024, 1, 1024, 1024.0 * 1024};
    const char *at = *end ? NULL : strchr(units, unit);
    return at ? (double)number * kilobytes[at - units] : -1;
}

int stack_check(struct failure *why) {
    static const char *const names[] = {"OMP_STACKSIZE", "GOMP_STACKSIZE"};
    struct rlimit limit;
    if (getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
        limit.rlim_cur < 1024 * (rlim_t)STACK_LEAST)
        return refuse(why, STATUS_INPUT, "a stack of %.0f kB is too small; at least %d kB: ulimit -s %d",
                      (double)limit.rlim_cur / 1024, STACK_LEAST, STACK_LEAST);
    for (int i = 0; i < 2; i++) {
        const char *text = getenv(names[i]);
        double size = text ? stack_size(text) : -1;
        if (size >= 0 && size < STACK_LEAST)
            return refuse(why, STATUS_INPUT, "%s=%.40s is too small; at least %dK, or unset", names[i], text,
                          STACK_LEAST);
    }
    return STATUS_OK;
}
