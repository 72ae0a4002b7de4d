/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_STABILITY_CONSISTENCY_H
#define HEATLADDER_VERIFICATION_STABILITY_CONSISTENCY_H

struct failure;
struct experiment;

/* Error of the derivatives of a particle method for a smooth function, on a lattice of spacing options.dx far from
 * walls: sum |approximate - exact| / sum |exact| over 16 points, (-1 + 0.137 i, 0.9 - 0.119 i) m, in *error.  First
 * derivatives if the method applies them twice, else kappa_x T_xx + kappa_y T_yy.  Returns a status of
 * solver/status.h. */
int consistency_error(const struct experiment *e, double *error, struct failure *why);

#endif
