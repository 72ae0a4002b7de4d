/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The verdicts and their colours: on a terminal only, and never if NO_COLOR is set (no-color.org). */
#include "verification/text/verdict.h"

#include "solver/words.h"

#include <math.h>
#include <stdlib.h>
#include <unistd.h>

const char *const verdict_words[] = {"inconclusive", "fail", "pass", "measured", "skipped", NULL};

enum verdict verdict_within(double x, double lo, double hi) {
    return isfinite(x) && lo <= x && x <= hi ? VERDICT_PASS : VERDICT_FAIL;
}

static const char *const colours[] = {
    [VERDICT_INCONCLUSIVE] = "\033[33m", [VERDICT_FAIL] = "\033[31m",    [VERDICT_PASS] = "\033[32m",
    [VERDICT_MEASURED] = "\033[36m",     [VERDICT_SKIPPED] = "\033[36m",
};

static int place(FILE *out, const char *word) {
    const char *never = getenv("NO_COLOR");
    if ((never && *never) || !isatty(fileno(out))) return -1;
    return words_index(verdict_words, word);
}

const char *verdict_colour(FILE *out, const char *word) {
    int i = place(out, word);
    return i < 0 ? "" : colours[i];
}

const char *verdict_colour_end(FILE *out, const char *word) {
    return place(out, word) < 0 ? "" : "\033[0m";
}
