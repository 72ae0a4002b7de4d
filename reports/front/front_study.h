/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_FRONT_FRONT_STUDY_H
#define HEATLADDER_REPORTS_FRONT_FRONT_STUDY_H

struct failure;

/* The front of k = k_0 T^2 by finite differences with each mean of a pair, into `dir`: front_means.csv. */
int front_study_write(const char *dir, struct failure *why);

#endif
