/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FAULT_DIAGNOSE_H
#define HEATLADDER_VERIFICATION_FAULT_DIAGNOSE_H

/* The fault that the errors of a ladder match. */

#include "verification/fault/diagnosis.h"

struct experiment;
struct ladder;

/* For an open ladder (struct ladder): sets *d from the fields of its two finest rungs.  If equal runs of a program
 * differ so far that they hide the errors, that is the diagnosis.  A fault that is named goes to the judge
 * (ladder_explained).  Else *d names nothing. */
void diagnose_ladder(const struct experiment *e, struct ladder *l, struct diagnosis *d);

#endif
