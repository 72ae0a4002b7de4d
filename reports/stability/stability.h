/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_STABILITY_STABILITY_H
#define HEATLADDER_REPORTS_STABILITY_STABILITY_H

struct failure;

/* The data of the figures of stability into `dir`; progress goes to standard output. */
int stability_write(const char *dir, struct failure *why);

#endif
