/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arrays of an outline. */
#include "solver/outline.h"

void outline_hold(struct outline *o, const char *what, size_t bytes, enum outline_phase from, enum outline_phase to) {
    if (bytes == 0) return;
    if (o->count < OUTLINE_ARRAYS) o->array[o->count++] = (struct outline_array){what, bytes, from, to};
    for (int i = (int)from; i <= (int)to; i++) o->bytes[i] += bytes;
}
