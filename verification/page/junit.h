/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_PAGE_JUNIT_H
#define HEATLADDER_VERIFICATION_PAGE_JUNIT_H

struct failure;
struct gates;

/* The verdicts as JUnit XML, reasons included.  STATUS_OK, or STATUS_INPUT with *why filled. */
int junit_write(const struct gates *g, const char *path, struct failure *why);

#endif
