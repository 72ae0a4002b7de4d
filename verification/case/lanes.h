/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CASE_LANES_H
#define HEATLADDER_VERIFICATION_CASE_LANES_H

struct failure;

/* Sets *lanes from the environment variable HEATLADDER_LANES; 0 if it is not set.  STATUS_INPUT if this machine does
 * not have that width. */
int lanes_forced(int *lanes, struct failure *why);

#endif
