/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any line is parsed or refused with a text and a status of bad input; nothing else happens. */
#include "verification/command/arguments.h"

#include "solver/status.h"
#include "verification/command/request.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct request r;
    struct failure why = {0};
    char *line = xcalloc(size + 1, 1);
    if (size) memcpy(line, data, size);
    int status = arguments_parse_line(line, &r, &why);
    if (status != STATUS_OK && (status != why.status || why.text[0] == '\0')) abort();
    arguments_free(&r);
    free(line);
    return 0;
}
