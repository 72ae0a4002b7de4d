/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files that are there whole or not at all. */
#include "verification/text/atomic_file.h"

#include "solver/method.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

struct place {
    char directory[UNIT_PATH], path[UNIT_PATH + 32];
    char nowhere[UNIT_PATH + 32],
        refusal[UNIT_PATH + 96]; /* a file in a directory that is not there, and what is said of it */
};

static int atomic_file_write(const char *path, const char *bytes, size_t size, struct failure *why) {
    return atomic_file_write_all(&(struct atomic_file){path, bytes, size}, 1, why);
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

static void writes_and_replaces(void **state) {
    const struct place *p = *state;
    struct failure why;
    char text[32];
    assert_int_equal(atomic_file_write(p->path, "first, longer", 13, &why), STATUS_OK);
    assert_int_equal(atomic_file_write(p->path, "second", 6, &why), STATUS_OK);
    read_back(p->path, text, sizeof text);
    assert_string_equal(text, "second");
    assert_int_equal(entries(p->directory), 1);
}

static void who_may_read_it_stays(void **state) {
    const struct place *p = *state;
    struct failure why;
    struct stat s;
    assert_int_equal(atomic_file_write(p->path, "first", 5, &why), STATUS_OK);
    assert_int_equal(chmod(p->path, 0640), 0);
    assert_int_equal(atomic_file_write(p->path, "second", 6, &why), STATUS_OK);
    assert_int_equal(stat(p->path, &s), 0);
    assert_int_equal(s.st_mode & 0777, 0640);
}

static void a_check_leaves_what_is_there(void **state) {
    const struct place *p = *state;
    struct failure why;
    char text[32];
    assert_int_equal(atomic_file_check(p->path, &why), STATUS_OK);
    assert_int_equal(entries(p->directory), 0);
    assert_int_equal(atomic_file_write(p->path, "kept", 4, &why), STATUS_OK);
    assert_int_equal(atomic_file_check(p->path, &why), STATUS_OK);
    read_back(p->path, text, sizeof text);
    assert_string_equal(text, "kept");
    assert_int_equal(atomic_file_check(NULL, &why), STATUS_OK);
}

static void what_cannot_be_written_is_refused(void **state) {
    const struct place *p = *state;
    struct failure why = {0};
    assert_int_equal(atomic_file_check(p->nowhere, &why), STATUS_INPUT);
    assert_string_equal(why.text, p->refusal);
    assert_int_equal(atomic_file_write(p->nowhere, "x", 1, &why), STATUS_INPUT);
    assert_int_equal(atomic_file_check(p->directory, &why), STATUS_INPUT);
    assert_int_equal(atomic_file_write(p->directory, "x", 1, &why), STATUS_INPUT);
    assert_int_equal(entries(p->directory), 0);
}

static void of_several_all_or_none(void **state) {
    const struct place *p = *state;
    struct failure why;
    char other[UNIT_PATH + 32], text[32];
    snprintf(other, sizeof other, "%s/other.csv", p->directory);
    const struct atomic_file both[] = {{p->path, "one", 3}, {other, "two", 3}, {"/dev/null", "x", 1}};
    assert_int_equal(atomic_file_write_all(both, 3, &why), STATUS_OK);
    read_back(other, text, sizeof text);
    unlink(other);
    assert_string_equal(text, "two");
    const struct atomic_file bad[] = {{p->path, "new", 3}, {p->nowhere, "x", 1}, {other, "y", 1}};
    assert_int_equal(atomic_file_write_all(bad, 3, &why), STATUS_INPUT);
    assert_string_equal(why.text, p->refusal);
    read_back(p->path, text, sizeof text);
    assert_string_equal(text, "one");
    assert_int_equal(entries(p->directory), 1); /* no part is left behind */
}

static void a_link_stays_a_link(void **state) {
    const struct place *p = *state;
    struct failure why;
    struct stat s;
    char link[UNIT_PATH + 32], text[32];
    snprintf(link, sizeof link, "%s/link", p->directory);
    assert_int_equal(atomic_file_write(p->path, "old", 3, &why), STATUS_OK);
    assert_int_equal(symlink("out.json", link), 0);
    assert_int_equal(atomic_file_write(link, "new", 3, &why), STATUS_OK);
    assert_int_equal(lstat(link, &s), 0);
    unlink(link);
    assert_true(S_ISLNK(s.st_mode));
    read_back(p->path, text, sizeof text);
    assert_string_equal(text, "new");
}

static void a_device_stays_a_device(void **state) {
    (void)state;
    struct failure why;
    struct stat s;
    assert_int_equal(atomic_file_check("/dev/null", &why), STATUS_OK);
    assert_int_equal(atomic_file_write("/dev/null", "x", 1, &why), STATUS_OK);
    assert_int_equal(stat("/dev/null", &s), 0);
    assert_true(S_ISCHR(s.st_mode));
}

/* In a process whose threads are alive: a file, then more than a pipe takes in before it is read. */
static void write_with_threads(const struct atomic_file *files) {
    struct failure why;
    int threads = 0;
#pragma omp parallel num_threads(2) reduction(+ : threads)
    threads++;
    _exit(threads == 2 ? atomic_file_write_all(files, 2, &why) : STATUS_NUMERICAL);
}

/* Once the pipe is open the file's part is there, and the writer waits for a reader: the signal comes amid the
 * writing. */
static void interrupts_wait_for_the_writing(void **state) {
    const struct place *p = *state;
    enum { MUCH = 1 << 20 };
    const int interrupts[] = {SIGINT, SIGTERM, SIGHUP};
    char pipe[UNIT_PATH + 32], text[32], *much = calloc(MUCH, 1);
    snprintf(pipe, sizeof pipe, "%s/pipe", p->directory);
    assert_int_equal(mkfifo(pipe, 0600), 0);
    const struct atomic_file files[] = {{p->path, "whole", 5}, {pipe, much, MUCH}};
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(writes_and_replaces, set_up, tear_down),
        cmocka_unit_test_setup_teardown(who_may_read_it_stays, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_check_leaves_what_is_there, set_up, tear_down),
        cmocka_unit_test_setup_teardown(what_cannot_be_written_is_refused, set_up, tear_down),
        cmocka_unit_test_setup_teardown(of_several_all_or_none, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_link_stays_a_link, set_up, tear_down),
        cmocka_unit_test(a_device_stays_a_device),
        cmocka_unit_test_setup_teardown(interrupts_wait_for_the_writing, set_up, tear_down),
    };
    return cmocka_run_group_tests_name("atomic_file", tests, NULL, NULL);
}
