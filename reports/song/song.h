/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_SONG_SONG_H
#define HEATLADDER_REPORTS_SONG_SONG_H

struct claims_measured;
struct failure;

/* Tables 1-3 and figures 1-5 of Song, Xing, Hou, Lu 2018 into `dir`. */
int song_write(const char *dir, struct failure *why);

/* The measures, as the rows of song.def name them (claims.h). */
#define CLAIM(id, source, published, measure, argument, expected, why) void measure(struct claims_measured *m);
#define READ(...)
#include "reports/song/song.def"
#undef READ
#undef CLAIM

#endif
