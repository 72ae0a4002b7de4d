/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FAULT_MELTING_H
#define HEATLADDER_VERIFICATION_FAULT_MELTING_H

#include "solver/field.h"
#include "verification/fault/faulty.h"

/* Solves a rod with phases, with that fault, by enthalpy on cells of size dx, m.  Allocates *out. */
void melting_solve(const struct faulty *f, double dx, struct field *out);

#endif
