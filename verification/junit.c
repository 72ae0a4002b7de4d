/* JUnit XML by cmocka's own writer: each gate, already judged, becomes a test that passes or fails with its reason.
 * cmocka takes the place of its output from the environment and does not write over a file, so it writes into a
 * directory of its own, from where the text is read back. */
#include "verification/junit.h"

#include "verification/atomic_file.h"
#include "verification/gates.h"

#include "solver/method.h"

#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

/* The function, not cmocka's macro of that name. */
static int refuse(const char *path, struct failure *why) {
    return (fail)(why, STATUS_INPUT, "cannot write '%.300s': %s", path, strerror(errno));
}

/* cmocka took the time of the judging alone; the gates' own seconds take its place, in their order. */
static void copy_lines(const struct gates *g, FILE *in, FILE *out) {
    char *line = NULL;
    size_t room = 0;
    double whole = 0;
    int gate = 0;
    for (int i = 0; i < g->declared; i++) whole += g->result[i].seconds;
    while (getline(&line, &room, in) >= 0) {
        int test = strstr(line, "<testcase ") != NULL, suite = strstr(line, "<testsuite ") != NULL;
        char *at = test || suite ? strstr(line, " time=\"") : NULL, *rest = at ? strchr(at + 7, '"') : NULL;
        if (rest && (suite || gate < g->declared))
            fprintf(out, "%.*s time=\"%.3f%s", (int)(at - line), line, suite ? whole : g->result[gate++].seconds,
                    rest);
        else
            fputs(line, out);
    }
    free(line);
}

static int copy(const struct gates *g, const char *from, const char *to, struct failure *why) {
    char *text = NULL;
    size_t size = 0;
    FILE *in = fopen(from, "rb"), *out = open_memstream(&text, &size);
    if (in && out) copy_lines(g, in, out);
    int status = in && out ? STATUS_OK : refuse(to, why);
    if (in) fclose(in);
    if (out) fclose(out);
    if (!status) status = atomic_file_write(to, text, size, why);
    free(text);
    return status;
}

/* cmocka writes the two strings of a comparison that fails into the XML, but not the text of fail_msg. */
static void one_test(void **state) {
    const struct gate_result *result = *state;
    char judged[640] = "pass";
    if (!result->executed || result->measured.verdict != VERDICT_PASS)
        snprintf(judged, sizeof judged, "%s: %s (heatladder %s)", verdict_words[result->measured.verdict],
                 result->measured.reason, result->gate.command);
    assert_string_equal(judged, "pass");
}

static void judge_again(const struct gates *g) {
    struct CMUnitTest *tests = xcalloc((size_t)g->declared, sizeof *tests);
    for (int i = 0; i < g->declared; i++)
        tests[i] =
            (struct CMUnitTest){.name = g->result[i].gate.id, .test_func = one_test, .initial_state = &g->result[i]};
    _cmocka_run_group_tests("gates", tests, (size_t)g->declared, NULL, NULL);
    free(tests);
}

int junit_write(const struct gates *g, const char *path, struct failure *why) {
    char directory[] = "/tmp/heatladder.XXXXXX", file[64];
    if (!mkdtemp(directory)) return refuse(path, why);
    snprintf(file, sizeof file, "%s/junit.xml", directory);
    setenv("CMOCKA_MESSAGE_OUTPUT", "XML", 1);
    setenv("CMOCKA_XML_FILE", file, 1);
    judge_again(g);
    int status = copy(g, file, path, why);
    unlink(file);
    rmdir(directory);
    return status;
}
