/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any file of gates is rows that could be run, or is refused with a text. */
#include "verification/gates/gate_file.h"

#include "solver/status.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(const struct gate_file *f) {
    if (f->count < 1) abort();
    for (int i = 0; i < f->count; i++) {
        const struct gate *g = &f->gate[i];
        if (!*g->id || !g->command || !g->why || !g->measure || !(g->lo <= g->hi)) abort();
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct gate_file f;
    struct failure why = {0};
    char *text = xcalloc(size + 1, 1);
    if (size) memcpy(text, data, size);
    int status = gate_file_read(text, size, "rows", &f, &why);
    if (status != STATUS_OK && (status != STATUS_INPUT || !why.text[0])) abort();
    if (!status) check(&f);
    gate_file_free(&f);
    free(text);
    return 0;
}
