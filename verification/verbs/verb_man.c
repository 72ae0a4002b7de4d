/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder man: the manual page, on standard output. */
#include "verification/command/manual.h"
#include "verification/command/verb.h"

#include "solver/status.h"

int verb_man(const struct request *r, struct failure *why) {
    (void)r, (void)why;
    manual_page(stdout);
    return STATUS_OK;
}
