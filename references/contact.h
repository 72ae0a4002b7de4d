/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REFERENCES_CONTACT_H
#define HEATLADDER_REFERENCES_CONTACT_H

#include "references/scene.h"

/* The slowest mode of two materials in contact, in a rectangle (dim 2) or a box (3): the functions of the scenes
 * plane-contact and box-contact.  *params: their table, in the order of contact.c. */
int contact_setup(const struct param *params, int dim, struct problem *p, struct failure *why);
struct exact contact_exact(const struct problem *p, const double *x, double t);
struct exact contact_second(const struct problem *p, const double *x, double t);

#endif
