/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files read in one piece, of any length. */
#include "verification/text/whole_file.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Its first room is 64 KiB, which doubles. */
static void every_length_is_read_whole(void **state) {
    (void)state;
    static const size_t lengths[] = {0, 1, 65534, 65535, 65536, 131071, 131072, 1000000};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        char path[UNIT_PATH], *bytes = malloc(lengths[i] + 1);
        for (size_t k = 0; k < lengths[i]; k++) bytes[k] = (char)('a' + k % 23);
        FILE *out = fdopen(scratch_file(path, "whole"), "w");
        assert_int_equal(fwrite(bytes, 1, lengths[i], out), lengths[i]);
        fclose(out);
        size_t size = 7;
        char *text = whole_file_at(path, &size);
        unlink(path);
        assert_non_null(text);
        assert_int_equal(size, lengths[i]);
        assert_memory_equal(text, bytes, size);
        assert_int_equal(text[size], 0);
        free(text);
        free(bytes);
    }
}

static void a_nul_ends_the_reading(void **state) {
    (void)state;
    size_t size;
    char *text = whole_file_at("/dev/zero", &size);
    assert_non_null(text);
    assert_string_equal(text, "");
    assert_order(size, <=, 1 << 16);
    free(text);
}

static void what_cannot_be_read_has_a_reason(void **state) {
    (void)state;
    char dir[UNIT_PATH], path[UNIT_PATH + 8];
    assert_non_null(scratch_directory(dir, "whole"));
    snprintf(path, sizeof path, "%s/pipe", dir);
    errno = 0;
    assert_null(whole_file_at(path, NULL));
    assert_string_equal(whole_file_error(), "No such file or directory");
    assert_null(whole_file_at(dir, NULL)); /* opens, but cannot be read */
    assert_int_equal(mkfifo(path, 0600), 0);
    assert_null(whole_file_open(path));
    assert_string_equal(whole_file_error(), "a named pipe, where a file is wanted");
    unlink(path);
    rmdir(dir);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_length_is_read_whole),
        cmocka_unit_test(a_nul_ends_the_reading),
        cmocka_unit_test(what_cannot_be_read_has_a_reason),
    };
    return cmocka_run_group_tests_name("whole_file", tests, NULL, NULL);
}
