/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_FIELD_FIELD_STUDY_H
#define HEATLADDER_REPORTS_FIELD_FIELD_STUDY_H

struct failure;

/* Writes the data of the figures of conduction along a field into `dir`: a status. */
int field_study_write(const char *dir, struct failure *why);

#endif
