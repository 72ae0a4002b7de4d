/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help of each verb. */
#include "solver/status.h"
#include "solver/words.h"
#include "verification/cli/help.h"
#include "verification/cli/verb.h"

#include "verification/unit/near.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(help_lists_every_option),
    };
    return cmocka_run_group_tests_name("help", tests, NULL, NULL);
}
