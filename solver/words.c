/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The nearest valid word, by edit distance: insertions, deletions, substitutions and swaps of two neighbours
 * (Damerau 1964), each counted as one. */
#include "solver/words.h"

#include "solver/status.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { LENGTH_MAX = 63 }; /* letters beyond these are not compared */

static int least(int a, int b) {
    return a < b ? a : b;
}

/* d[i][j] is the distance between the first i letters of a and the first j of b. */
static int distance(const char *a, const char *b) {
    int d[LENGTH_MAX + 1][LENGTH_MAX + 1];
    int m = least((int)strlen(a), LENGTH_MAX), n = least((int)strlen(b), LENGTH_MAX);
    for (int i = 0; i <= m; i++) d[i][0] = i;
    for (int j = 0; j <= n; j++) d[0][j] = j;
    for (int i = 1; i <= m; i++)
        for (int j = 1; j <= n; j++) {
            d[i][j] = least(d[i - 1][j - 1] + (a[i - 1] != b[j - 1]), least(d[i - 1][j], d[i][j - 1]) + 1);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = least(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[m][n];
}

int words_index(const char *const *words, const char *word) {
    for (int i = 0; words[i]; i++)
        if (strcmp(words[i], word) == 0) return i;
    return -1;
}

const char *words_nearest(const char *const *words, const char *word) {
    const char *nearest = NULL;
    int edits = ((int)strlen(word) + 1) / 2 + 1; /* a word without half in common is not near */
    for (int i = 0; words[i]; i++) {
        int begun = *word && strncmp(words[i], word, strlen(word)) == 0, d = begun ? 0 : distance(words[i], word);
        if (d >= edits) continue;
        edits = d;
        nearest = words[i];
    }
    return nearest;
}

int words_add(char *text, size_t size, const char *format, ...) {
    size_t used = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    int more = vsnprintf(text + used, size - used, format, arguments);
    va_end(arguments);
    return more < 0 || (size_t)more >= size - used ? -1 : 0;
}

void words_join(const char *const *words, char *text, size_t size) {
    text[0] = '\0';
    for (int i = 0; words[i]; i++) words_add(text, size, "%s%s", i ? ", " : "", words[i]);
}

int words_among(const char *blank_separated, const char *word) {
    size_t length = strlen(word);
    if (length == 0) return 0;
    for (const char *at = blank_separated; (at = strstr(at, word)); at += length) {
        int starts = at == blank_separated || at[-1] == ' ';
        int ends = at[length] == '\0' || at[length] == ' ';
        if (starts && ends) return 1;
    }
    return 0;
}

int words_unknown(const char *const *words, const char *what, const char *word, struct failure *why) {
    char valid[400], hint[100] = "";
    const char *nearest = words_nearest(words, word);
    words_join(words, valid, sizeof valid);
    if (!words[0]) return refuse(why, STATUS_INPUT, "unknown %s '%.60s'; there is none", what, word);
    if (nearest) snprintf(hint, sizeof hint, "; did you mean '%.60s'?", nearest);
    return refuse(why, STATUS_INPUT, "unknown %s '%.60s'%s (valid: %s)", what, word, hint, valid);
}
