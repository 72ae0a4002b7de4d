/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any line is parsed or refused with a text and a status of bad input; nothing else happens. */
#include "verification/cli/verb.h"

#include "solver/status.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct failure why = {0};
    char *line = xcalloc(size + 1, 1), *word[200];
    if (size) memcpy(line, data, size);
    int n = command_words(line, word, 200);
    const struct verb *v = n > 0 ? verb_find(word[0]) : NULL;
    if (v) {
        void *options = xcalloc(1, v->size);
        int status = command_parse(v->syntax, v->own, n, word, options, &why);
        if (status != STATUS_OK && (status != why.status || why.text[0] == '\0')) abort();
        command_free(options);
        free(options);
    } else if (n > 0 && verb_unknown(word[0], &why) != STATUS_INPUT) {
        abort();
    }
    free(line);
    return 0;
}
