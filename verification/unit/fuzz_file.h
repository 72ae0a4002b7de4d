/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_UNIT_FUZZ_FILE_H
#define HEATLADDER_VERIFICATION_UNIT_FUZZ_FILE_H

/* A private file of a fuzzer, for readers that open their input; it is removed when the program ends. */

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static char fuzz_directory[] = "/tmp/heatladder-fuzz-XXXXXX";
static char fuzz_path[sizeof fuzz_directory + 8];

static void fuzz_remove(void) {
    unlink(fuzz_path);
    rmdir(fuzz_directory);
}

/* Ends the fuzzer with the current input if the condition does not hold. */
static void fuzz_require(int holds) {
    if (!holds) abort();
}

static const char *fuzz_put(const uint8_t *data, size_t size) {
    if (!fuzz_path[0]) {
        fuzz_require(mkdtemp(fuzz_directory) != NULL);
        snprintf(fuzz_path, sizeof fuzz_path, "%s/file", fuzz_directory);
        atexit(fuzz_remove);
    }
    unlink(fuzz_path); /* a file that is truncated goes to the disk when it is closed (ext4); a new one does not */
    FILE *out = fopen(fuzz_path, "w");
    fuzz_require(out && fwrite(data, 1, size, out) == size && fclose(out) == 0);
    return fuzz_path;
}

#endif
