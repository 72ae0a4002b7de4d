/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder completion: what bash completes, on standard output. */
#include "verification/command/manual.h"
#include "verification/command/verb.h"

#include "solver/status.h"

int verb_completion(const struct request *r, struct failure *why) {
    (void)r, (void)why;
    manual_completion(stdout);
    return STATUS_OK;
}
