/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_INDEX_ORDERS_H
#define HEATLADDER_REPORTS_INDEX_ORDERS_H

/* Ladders of gates, by scene. */

#include "verification/page/page.h"

/* The order that each ladder in space or time reaches, on the band that is expected: a line a gate, grouped by the
 * scenes as named, NULL last.  Nothing where no gate has a ladder. */
void orders_put(const struct page_gate *gate, int count, const char *const scene[], FILE *out);

/* The errors of a scene's ladders in space, a curve a method and the second-order particles first. */
void orders_put_scene(const struct page_gate *gate, int count, const char *scene, FILE *out);

#endif
