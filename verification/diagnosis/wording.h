/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_DIAGNOSIS_WORDING_H
#define HEATLADDER_VERIFICATION_DIAGNOSIS_WORDING_H

#include <stddef.h>

struct diagnosis;

/* d->what of a fault that is named, from its kind, size and unit. */
void wording_fault(struct diagnosis *d);

/* What it says, and the share of the error where there is one. */
void wording_text(const struct diagnosis *d, char *text, size_t size);

enum { WORDING_ALL = 340 };

/* What most of `count` gates look like that do not hold, by their texts of wording_text ("" where none is named):
 * the fault that most of them name, whatever its size, the middle one of its sizes (of two the smaller), and how many
 * name it.  What is off along x is one vote with what is off along x and y; heat transfer coefficients of different
 * sides are one vote, for those of all sides.  It begins with "perhaps" unless at least half of those that name a
 * fault name that one, with sizes that agree to 20 %.  "" where none names any. */
void wording_all(const char *const text[], int count, char *all, size_t size);

#endif
