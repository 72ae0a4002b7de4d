/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_WALLS_WALLS_STUDY_H
#define HEATLADDER_REPORTS_WALLS_WALLS_STUDY_H

struct failure;

/* Which treatment of walls that cut the lattice keeps which order, into `dir`: walls.md and .html (orders, errors,
 * largest stable step, growth, heat kept, by treatment and kind of wall), walls_error.csv (error against spacing),
 * walls_offset.csv (order and step against the offset of plane walls), walls_field.csv (the error on the disc).
 * Progress goes to standard output. */
int walls_study_write(const char *dir, struct failure *why);

#endif
