/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files are written whole or not at all, and read whole. */
#include "verification/text/output.h"
#include "verification/text/whole_file.h"

#include "solver/status.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define __SANITIZE_ADDRESS__ 1
#endif
#endif

struct place {
    char directory[UNIT_PATH], path[UNIT_PATH + 32];
    char nowhere[UNIT_PATH + 32],
        refusal[UNIT_PATH + 96]; /* a file in a directory that does not exist, and its refusal */
};

struct part {
    const char *path, *bytes;
    size_t size;
};

static int write_all(const struct part *part, int count, struct failure *why) {
    struct output page[3];
    for (int i = 0; i < count; i++) fwrite(part[i].bytes, 1, part[i].size, output_open(&page[i], "%s", part[i].path));
    return output_close(page, count, why);
}

static int write_one(const char *path, const char *text, struct failure *why) {
    return write_all(&(struct part){path, text, strlen(text)}, 1, why);
}

static int set_up(void **state) {
    struct place *p = calloc(1, sizeof *p);
    if (!scratch_directory(p->directory, "heatladder_test")) return -1;
    snprintf(p->path, sizeof p->path, "%s/out.json", p->directory);
    snprintf(p->nowhere, sizeof p->nowhere, "%s/none/out.csv", p->directory);
    snprintf(p->refusal, sizeof p->refusal, "cannot write '%s': No such file or directory", p->nowhere);
    *state = p;
    return 0;
}

static int tear_down(void **state) {
    struct place *p = *state;
    unlink(p->path);
    rmdir(p->directory);
    free(p);
    return 0;
}

static void read_back(const char *path, char *text, size_t size) {
    FILE *in = fopen(path, "r");
    assert_non_null(in);
    text[fread(text, 1, size - 1, in)] = '\0';
    fclose(in);
}

static int entries(const char *directory) {
    int n = 0;
    DIR *d = opendir(directory);
    for (struct dirent *e; (e = readdir(d));) n += e->d_name[0] != '.';
    closedir(d);
    return n;
}

static void files_are_written_and_replaced(void **state) {
    const struct place *p = *state;
    struct failure why;
    char text[32];
    assert_int_equal(write_one(p->path, "first, longer", &why), STATUS_OK);
    assert_int_equal(write_one(p->path, "second", &why), STATUS_OK);
    read_back(p->path, text, sizeof text);
    assert_string_equal(text, "second");
    assert_int_equal(entries(p->directory), 1);
}

static void replacing_keeps_permissions(void **state) {
    const struct place *p = *state;
    struct failure why;
    struct stat s;
    assert_int_equal(write_one(p->path, "first", &why), STATUS_OK);
    assert_int_equal(chmod(p->path, 0640), 0);
    assert_int_equal(write_one(p->path, "second", &why), STATUS_OK);
    assert_int_equal(stat(p->path, &s), 0);
    assert_int_equal(s.st_mode & 0777, 0640);
}

static void checking_a_path_changes_no_file(void **state) {
    const struct place *p = *state;
    struct failure why;
    char text[32];
    assert_int_equal(output_check(p->path, &why), STATUS_OK);
    assert_int_equal(entries(p->directory), 0);
    assert_int_equal(write_one(p->path, "kept", &why), STATUS_OK);
    assert_int_equal(output_check(p->path, &why), STATUS_OK);
    read_back(p->path, text, sizeof text);
    assert_string_equal(text, "kept");
    assert_int_equal(output_check(NULL, &why), STATUS_OK);
}

static void unwritable_places_are_refused(void **state) {
    const struct place *p = *state;
    struct failure why = {0};
    assert_int_equal(write_one(p->nowhere, "x", &why), STATUS_INPUT);
    assert_string_equal(why.text, p->refusal);
    assert_int_equal(output_check(p->directory, &why), STATUS_INPUT);
    assert_int_equal(write_one(p->directory, "x", &why), STATUS_INPUT);
    assert_int_equal(entries(p->directory), 0);
}

static void several_files_are_all_written_or_none(void **state) {
    const struct place *p = *state;
    struct failure why;
    char other[UNIT_PATH + 32], text[32];
    snprintf(other, sizeof other, "%s/other.csv", p->directory);
    const struct part both[] = {{p->path, "one", 3}, {other, "two", 3}, {"/dev/null", "x", 1}};
    assert_int_equal(write_all(both, 3, &why), STATUS_OK);
    read_back(other, text, sizeof text);
    unlink(other);
    assert_string_equal(text, "two");
    const struct part bad[] = {{p->path, "new", 3}, {p->nowhere, "x", 1}, {other, "y", 1}};
    assert_int_equal(write_all(bad, 3, &why), STATUS_INPUT);
    assert_string_equal(why.text, p->refusal);
    read_back(p->path, text, sizeof text);
    assert_string_equal(text, "one");
    assert_int_equal(entries(p->directory), 1); /* no part is left behind */
}

static void writing_through_a_link_keeps_the_link(void **state) {
    const struct place *p = *state;
    struct failure why;
    struct stat s;
    char link[UNIT_PATH + 32], text[32];
    snprintf(link, sizeof link, "%s/link", p->directory);
    assert_int_equal(write_one(p->path, "old", &why), STATUS_OK);
    assert_int_equal(symlink("out.json", link), 0);
    assert_int_equal(write_one(link, "new", &why), STATUS_OK);
    assert_int_equal(lstat(link, &s), 0);
    unlink(link);
    assert_true(S_ISLNK(s.st_mode));
    read_back(p->path, text, sizeof text);
    assert_string_equal(text, "new");
}

static void writing_to_a_device_keeps_the_device(void **state) {
    (void)state;
    struct failure why;
    struct stat s;
    assert_int_equal(output_check("/dev/null", &why), STATUS_OK);
    assert_int_equal(write_one("/dev/null", "x", &why), STATUS_OK);
    assert_int_equal(stat("/dev/null", &s), 0);
    assert_true(S_ISCHR(s.st_mode));
}

/* In a process with running threads: writes a file, then more than a pipe holds before it is read. */
static void write_with_threads(const struct part *files) {
    struct failure why;
    int threads = 0;
#pragma omp parallel num_threads(2) reduction(+ : threads)
    threads++;
    _exit(threads == 2 ? write_all(files, 2, &why) : STATUS_NUMERICAL);
}

/* Once the pipe is open the file's part is there, and the writer waits for a reader: the signal comes amid the
 * writing. */
static void signals_wait_for_a_complete_file(void **state) {
    const struct place *p = *state;
    enum { MUCH = 1 << 20 };
    const int interrupts[] = {SIGINT, SIGTERM, SIGHUP};
    char pipe[UNIT_PATH + 32], text[32], *much = calloc(MUCH, 1);
    snprintf(pipe, sizeof pipe, "%s/pipe", p->directory);
    assert_int_equal(mkfifo(pipe, 0600), 0);
    const struct part files[] = {{p->path, "whole", 5}, {pipe, much, MUCH}};
    for (int i = 0; i < 3; i++) {
        int status;
        ssize_t n, all = 0;
        pid_t child = fork();
        if (child == 0) {
            signal(interrupts[i], SIG_DFL); /* a shell's background has it ignored */
            write_with_threads(files);
        }
        int in = open(pipe, O_RDONLY);
        kill(child, interrupts[i]);
        while ((n = read(in, much, MUCH)) > 0) all += n;
        close(in);
        waitpid(child, &status, 0);
        read_back(p->path, text, sizeof text);
        assert_int_equal(all, MUCH);
        assert_string_equal(text, "whole");
        assert_int_equal(entries(p->directory), 2); /* no part is left behind */
        assert_true(WIFSIGNALED(status) && WTERMSIG(status) == interrupts[i]);
        unlink(p->path);
    }
    unlink(pipe);
    free(much);
}

/* Directories of a path that are not there are made; a file in the place of one is refused. */
static void missing_directories_are_made(void **state) {
    const struct place *p = *state;
    char path[UNIT_PATH + 48], wanted[UNIT_PATH + 96];
    struct failure why = {0};
    snprintf(path, sizeof path, "%s/a/b/c", p->directory);
    for (int again = 0; again < 2; again++) assert_int_equal(output_check(path, &why), STATUS_OK);
    assert_int_equal(write_one(path, "x", &why), STATUS_OK);
    snprintf(wanted, sizeof wanted, "%s/d", path);
    assert_int_equal(output_check(wanted, &why), STATUS_INPUT);
    snprintf(wanted, sizeof wanted, "cannot write '%s/d': Not a directory", path);
    assert_string_equal(why.text, wanted);
    snprintf(wanted, sizeof wanted, "%s/d/e", path);
    assert_int_equal(output_folders(wanted, &why), STATUS_INPUT);
    snprintf(wanted, sizeof wanted, "cannot make the directory '%s/d': Not a directory", path);
    assert_string_equal(why.text, wanted);
    for (int k = 0; k < 3; k++) {
        remove(path);
        *strrchr(path, '/') = '\0';
    }
    assert_int_equal(entries(p->directory), 0);
}

/* Once a file has taken standard output, printed text goes to standard error. */
static void a_dash_is_standard_output(void **state) {
    const struct place *p = *state;
    struct failure why = {0};
    char other[UNIT_PATH + 32], text[32];
    int status;
    snprintf(other, sizeof other, "%s/other", p->directory);
    pid_t child = fork();
    if (child == 0) {
        if (!freopen(p->path, "w", stdout) || !freopen(other, "w", stderr)) _exit(99);
        printf("before\n");
        status = output_check("-", &why);
        printf("after\n");
        status |= write_one("-", "the file\n", &why) | (output_check("-", &why) != STATUS_INPUT);
        fflush(stdout);
        _exit(status);
    }
    waitpid(child, &status, 0);
    assert_int_equal(status, 0);
    read_back(p->path, text, sizeof text);
    assert_string_equal(text, "before\nthe file\n");
    read_back(other, text, sizeof text);
    assert_string_equal(text, "after\n");
    unlink(other);
    assert_int_equal(access("-", F_OK), -1);
}

/* In a process limited to 64 MB: 256 MB of lines.  glibc's open_memstream drops data without an error if memory is
 * exhausted. */
static void write_much(void) {
    enum { ROOM = 64 << 20 };
    struct output page;
    struct failure why;
    struct rlimit limit = {ROOM, ROOM};
    if (!freopen("/dev/null", "w", stderr) || setrlimit(RLIMIT_DATA, &limit)) _exit(99);
    FILE *out = output_open(&page, "/dev/null");
    for (int i = 0; i < ROOM / 16; i++) fprintf(out, "%063d\n", i);
    _exit(output_close(&page, 1, &why));
}

static void out_of_memory_writes_nothing(void **state) {
    (void)state;
#ifdef __SANITIZE_ADDRESS__
    skip(); /* it has an allocator of its own */
#endif
    int status;
    pid_t child = fork();
    if (child == 0) write_much();
    waitpid(child, &status, 0);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), STATUS_NUMERICAL);
}

/* ---- Reading ---- */

/* Its first room is 64 KiB, which doubles. */
static void files_of_every_length_are_read(void **state) {
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

static void reading_stops_at_a_nul_byte(void **state) {
    (void)state;
    size_t size;
    char *text = whole_file_at("/dev/zero", &size);
    assert_non_null(text);
    assert_string_equal(text, "");
    assert_order(size, <=, 1 << 16);
    free(text);
}

static void unreadable_files_give_the_reason(void **state) {
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
        cmocka_unit_test_setup_teardown(files_are_written_and_replaced, set_up, tear_down),
        cmocka_unit_test_setup_teardown(replacing_keeps_permissions, set_up, tear_down),
        cmocka_unit_test_setup_teardown(checking_a_path_changes_no_file, set_up, tear_down),
        cmocka_unit_test_setup_teardown(unwritable_places_are_refused, set_up, tear_down),
        cmocka_unit_test_setup_teardown(several_files_are_all_written_or_none, set_up, tear_down),
        cmocka_unit_test_setup_teardown(writing_through_a_link_keeps_the_link, set_up, tear_down),
        cmocka_unit_test(writing_to_a_device_keeps_the_device),
        cmocka_unit_test_setup_teardown(signals_wait_for_a_complete_file, set_up, tear_down),
        cmocka_unit_test_setup_teardown(missing_directories_are_made, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_dash_is_standard_output, set_up, tear_down),
        cmocka_unit_test(out_of_memory_writes_nothing),
        cmocka_unit_test(files_of_every_length_are_read),
        cmocka_unit_test(reading_stops_at_a_nul_byte),
        cmocka_unit_test(unreadable_files_give_the_reason),
    };
    return cmocka_run_group_tests_name("files", tests, NULL, NULL);
}
