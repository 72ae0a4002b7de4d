/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_FOREIGN_VTK_FILE_H
#define HEATLADDER_VERIFICATION_FOREIGN_VTK_FILE_H

#include <stddef.h>

struct column_map;
struct failure;
struct samples;

/* Whether a text starts as a legacy VTK file, or as one of XML (VTU), which is not read. */
int vtk_file_is(const char *text, size_t size);
int vtk_file_is_xml(const char *text, size_t size);

/* Reads the points and the point data T (and w where it is wanted) of legacy ASCII VTK; `text` is the whole file,
 * ended by a NUL.  Cell data are refused: they have no points.  Into *s, whose path and dim are set. */
int vtk_file_read(const char *text, size_t size, const struct column_map *c, struct samples *s, struct failure *why);

#endif
