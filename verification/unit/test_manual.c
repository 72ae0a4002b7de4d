/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help of each verb, and completion in bash.  scripts/tests/words.bats compares both with the manual page. */
#include "solver/status.h"
#include "verification/cli/help.h"
#include "verification/cli/verb.h"
#include "verification/text/words.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Not inlined: gcc 12 treats the result of strstr as a pointer into this frame. */
__attribute__((noinline)) static char *written(void (*write)(FILE *)) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    assert_non_null(out);
    write(out);
    fclose(out);
    return text;
}

/* Line ends and indents become one blank. */
static void unfold(char *text) {
    char *to = text;
    for (const char *from = text; *from; from++) {
        int blank = *from == '\n' || *from == ' ';
        if (blank && to > text && to[-1] == ' ') continue;
        *to++ = blank ? ' ' : *from;
    }
    *to = '\0';
}

/* The help of a verb has each option with its words, in lines of at most 100 letters. */
static void help_lists_every_option(void **state) {
    (void)state;
    for (int i = 0; verbs[i]; i++) {
        const struct option *list[VERB_ROWS];
        char *text = NULL, words[200], wanted[600];
        size_t size;
        FILE *out = open_memstream(&text, &size);
        assert_non_null(out);
        help_verb(verbs[i], out);
        fclose(out);
        char *end = strstr(text, "\n\nLIST is"); /* written by hand */
        if (!end) end = strstr(text, "\nThe first of");
        for (const char *line = text, *next; (next = strchr(line, '\n')) && (!end || next < end); line = next + 1)
            if (next - line > 100) fail_msg("%s: %.*s", verbs[i]->syntax->name, (int)(next - line), line);
        unfold(text);
        for (int n = verb_options(verbs[i], list); n-- > 0;) {
            if (list[n]->words) words_join(list[n]->words, words, sizeof words);
            snprintf(wanted, sizeof wanted, "%s%s%s ", list[n]->about, list[n]->words ? ": " : "",
                     list[n]->words ? words : "");
            if (!strstr(text, wanted)) fail_msg("%s --%s", verbs[i]->syntax->name, list[n]->name);
        }
        free(text);
    }
}

/* bash evaluates the completion. */
static void bash_completes(void **state) {
    (void)state;
    if (system("command -v bash >/dev/null 2>&1")) return;
    char *text = written(manual_completion), path[UNIT_PATH], command[UNIT_PATH + 400];
    int file = scratch_file(path, "completion-test");
    assert_order(file, >=, 0);
    FILE *out = fdopen(file, "w");
    fputs(text, out);
    fclose(out);
    free(text);
    static const char *const row[][2] = {{"heatladder comp", "completion"},
                                         {"heatladder ladder rod-g", "rod-gauss"},
                                         {"heatladder run rod-gauss so_ssph --kernel wend", "wendland"},
                                         {"heatladder verify --qui", "--quick"}};
    for (int i = 0; i < 4; i++) {
        snprintf(command, sizeof command,
                 "bash -c 'source %s; COMP_WORDS=(%s); COMP_CWORD=$((${#COMP_WORDS[@]}-1)); _heatladder; "
                 "[ \"${COMPREPLY[*]}\" = \"%s\" ]'",
                 path, row[i][0], row[i][1]);
        if (system(command)) fail_msg("%s", row[i][0]);
    }
    remove(path);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(help_lists_every_option),
        cmocka_unit_test(bash_completes),
    };
    return cmocka_run_group_tests_name("manual", tests, NULL, NULL);
}
