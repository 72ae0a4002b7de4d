/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Differences between a terminal and a pipe: colours of verdicts, and progress of long work. */
#include "verification/text/progress.h"
#include "verification/text/table.h"
#include "verification/text/verdict.h"

#include "verification/unit/near.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

/* A pseudo-terminal: data written to `there` are read from `here`. */
struct terminal {
    int here, there;
};

static int open_terminal(void **state) {
    static struct terminal t;
    struct termios as_it_is;
    t.here = posix_openpt(O_RDWR | O_NOCTTY);
    if (t.here < 0 || grantpt(t.here) || unlockpt(t.here)) return -1;
    t.there = open(ptsname(t.here), O_RDWR | O_NOCTTY);
    if (t.there < 0 || tcgetattr(t.there, &as_it_is)) return -1;
    as_it_is.c_oflag &= (tcflag_t)~OPOST; /* no carriage return before a line feed */
    *state = &t;
    unsetenv("NO_COLOR");
    return tcsetattr(t.there, TCSANOW, &as_it_is);
}

static int close_terminal(void **state) {
    const struct terminal *t = *state;
    close(t->here);
    close(t->there);
    return 0;
}

/* Text written so far: a read may return part of it, so a mark is written and read up to. */
static const char *arrived(const struct terminal *t) {
    static char text[4000];
    const char mark = '\004';
    size_t length = 0;
    assert_int_equal(write(t->there, &mark, 1), 1);
    do {
        ssize_t n = read(t->here, text + length, sizeof text - 1 - length);
        assert_true(n > 0);
        length += (size_t)n;
    } while (text[length - 1] != mark);
    text[length - 1] = '\0';
    return text;
}

/* Colours have no width. */
static void a_table_of_verdicts_is_aligned(void **state) {
    const struct terminal *t = *state;
    FILE *out = fdopen(dup(t->there), "w");
    struct table rows = table_headed(1, "gate|verdict|x");
    table_add(&rows, "a|skipped|1");
    table_add(&rows, "long|fail|20");
    table_end(&rows, out);
    fclose(out);
    assert_string_equal(arrived(t), "gate  verdict   x\na     \033[36mskipped\033[0m   1\n"
                                    "long  \033[31m   fail\033[0m  20\n");
}

/* The line is written over, then taken away; lines that stay take it away first. */
static void progress_is_one_line(void **state) {
    const struct terminal *t = *state;
    char wanted[600], longer[100];
    int stderr_was = dup(STDERR_FILENO);
    dup2(t->there, STDERR_FILENO);
    struct progress p = progress_start("gates", 3);
    const int shown = p.shown;
    progress_tick(&p);
    progress_tick(&p);
    progress_print(&p, "gate %d", 7);
    memset(longer, 'w', sizeof longer - 1);
    longer[sizeof longer - 1] = '\0';
    progress_now(&p, "%s", longer);
    progress_now(&p, "run %d", 2);
    progress_end(&p);
    dup2(stderr_was, STDERR_FILENO);
    close(stderr_was);
    assert_int_equal(shown, 1);
    assert_int_equal(p.done, 2);
    snprintf(wanted, sizeof wanted, "\r%-79s\r\r%-79s\r\r%79s\rgate 7\n\r%.79s\r\r%-79s\r\r%79s\r", "1 of 3 gates",
             "2 of 3 gates", "", longer, "run 2", "");
    assert_string_equal(arrived(t), wanted);
}

/* Without a terminal only the permanent lines are printed. */
static void redirected_progress_prints_final_lines_only(void **state) {
    (void)state;
    char text[80] = "";
    FILE *file = tmpfile();
    int stderr_was = dup(STDERR_FILENO);
    dup2(fileno(file), STDERR_FILENO);
    struct progress p = progress_start("gates", 3);
    progress_tick(&p);
    progress_now(&p, "run %d", 2);
    progress_print(&p, "gate %d", 7);
    progress_end(&p);
    dup2(stderr_was, STDERR_FILENO);
    close(stderr_was);
    rewind(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    assert_int_equal(p.shown, 0);
    assert_string_equal(text, "gate 7\n");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_table_of_verdicts_is_aligned),
        cmocka_unit_test(progress_is_one_line),
        cmocka_unit_test(redirected_progress_prints_final_lines_only),
    };
    return cmocka_run_group_tests_name("terminal", tests, open_terminal, close_terminal);
}
