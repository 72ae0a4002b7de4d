/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_LADDER_DIAGNOSE_H
#define HEATLADDER_VERIFICATION_LADDER_DIAGNOSE_H

#include "verification/ladder/doubt.h"

struct experiment;
struct ladder;

/* Which usual fault the errors of a ladder in space look like, into l->diagnosis: from the fields of its finest rung
 * and of the one before, in that order (n = 0 where a rung has none).  *noise: by how much a program's answers differ
 * from run to run, which is all of the diagnosis where that hides the rest. */
void diagnose_ladder(const struct experiment *e, const struct field kept[2], struct ladder *l,
                     struct doubt_noise *noise);

#endif
