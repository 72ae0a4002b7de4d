#ifndef HEATLADDER_REPORTS_SONG_SONG_H
#define HEATLADDER_REPORTS_SONG_SONG_H

struct failure;

/* Tables 1-3 and figures 1-5 of Song, Xing, Hou, Lu 2018 into `dir`. */
int song_write(const char *dir, struct failure *why);

#endif
