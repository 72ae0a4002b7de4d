/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FAULT_WORDING_H
#define HEATLADDER_VERIFICATION_FAULT_WORDING_H

#include <stddef.h>

struct diagnosis;

/* Writes d->what of a named fault from its kind, size and unit. */
void wording_fault(struct diagnosis *d);

/* Writes d->what and, if known, the share of the error. */
void wording_text(const struct diagnosis *d, char *text, size_t size);

#endif
