/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help, manual page and completion leave out no verb, option, scene or method, and are well formed. */
#include "verification/command/manual.h"

#include "references/scene.h"
#include "solver/method.h"
#include "verification/command/help.h"
#include "verification/command/option.h"
#include "verification/command/verb.h"
#include "verification/text/words.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Not inlined: gcc 12 takes what strstr finds in the text for a pointer into this frame. */
__attribute__((noinline)) static char *written(void (*write)(FILE *)) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    assert_non_null(out);
    write(out);
    fclose(out);
    return text;
}

/* `name` with its dashes as roff has them. */
static void has(const char *text, const char *before, const char *name, const char *after) {
    char wanted[1400];
    size_t n = (size_t)snprintf(wanted, sizeof wanted, "%s", before);
    for (; *name; name++)
        if (*name == '-')
            n += (size_t)snprintf(wanted + n, sizeof wanted - n, "\\-");
        else
            wanted[n++] = *name;
    snprintf(wanted + n, sizeof wanted - n, "%s", after);
    assert_has(text, wanted);
}

static void the_page_is_complete(void **state) {
    (void)state;
    char *page = written(manual_page);
    for (const struct verb *v = verbs; v->name; v++) has(page, "\n.B heatladder ", v->name, "\n");
    for (const struct option *o = options_table; o->key; o++) has(page, ".TP\n\\fB\\-\\-", o->name, "\\fR");
    for (int i = 0; scenes[i]; i++) has(page, ".TP\n\\fB", scenes[i]->name, "\\fR");
    for (int i = 0; methods[i]; i++) has(page, ".TP\n\\fB", methods[i]->name, "\\fR");
    static const char *const sections[] = {"NAME",        "SYNOPSIS", "DESCRIPTION",     "LADDER",      "EXAMPLES",
                                           "ENVIRONMENT", "FILES",    "\"EXIT STATUS\"", "\"SEE ALSO\""};
    for (int i = 0; i < 9; i++) has(page, "\n.SH ", sections[i], "\n");
    for (const char *line = page; line; line = strchr(line, '\n')) {
        line += *line == '\n';
        assert_int_not_equal(*line, '\'');
        if (*line == '.') assert_non_null(strchr("TSPnfBI", line[1]));
    }
    free(page);
}

/* Where lines break is no part of what they say: line ends and indents become one blank. */
static void unfold(char *text) {
    char *to = text;
    for (const char *from = text; *from; from++) {
        int blank = *from == '\n' || *from == ' ';
        if (blank && to > text && to[-1] == ' ') continue;
        *to++ = blank ? ' ' : *from;
    }
    *to = '\0';
}

/* The part of the page on a verb, up to the next heading. */
static const char *part_of(const char *page, const struct verb *v) {
    static char part[40000];
    char heading[80];
    snprintf(heading, sizeof heading, "\n.B heatladder %s\n", v->name);
    const char *from = strstr(page, heading);
    assert_non_null(from);
    snprintf(part, sizeof part, "%.*s", (int)(strstr(from + 1, "\n.S") + 1 - from), from);
    unfold(part);
    return part;
}

/* An option fills at most the width of a window. */
static void lines_are_short(void **state) {
    (void)state;
    for (const struct verb *v = verbs; v->name; v++) {
        char *text = NULL;
        size_t size;
        FILE *out = open_memstream(&text, &size);
        assert_non_null(out);
        help_verb(v, out);
        fclose(out);
        for (const char *line = text, *end; (end = strchr(line, '\n')); line = end + 1) {
            if (strncmp(line, "The first of", 12) == 0 || strncmp(line, "LIST is", 7) == 0) break; /* by hand */
            if (end - line > 100) fail_msg("%s: %.*s", v->name, (int)(end - line), line);
        }
        free(text);
    }
}

/* Each option of each verb with all that help and manual page say of it: the words that it takes, and whether it must
 * be given. */
static void the_help_is_whole(void **state) {
    (void)state;
    for (const struct verb *v = verbs; v->name; v++) {
        char *text = NULL, words[200] = "", wanted[600];
        size_t size;
        FILE *out = open_memstream(&text, &size);
        assert_non_null(out);
        help_verb(v, out);
        fclose(out);
        unfold(text);
        char *page = written(manual_page);
        const char *part = part_of(page, v);
        for (const struct option *o = options_table; o->key; o++) {
            if (!words_among(v->options, o->key)) continue;
            if (o->words) words_join(o->words, words, sizeof words);
            snprintf(wanted, sizeof wanted, "%s%s%s%s ", o->about, o->words ? ": " : "", o->words ? words : "",
                     words_among(v->required, o->key) ? " (required)" : "");
            if (!strstr(text, wanted)) fail_msg("%s --%s: '%s' is cut", v->name, o->name, wanted);
            has(part, " ", wanted, "");
        }
        free(page);
        free(text);
    }
}

/* bash itself tells what is completed. */
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
        cmocka_unit_test(the_page_is_complete),
        cmocka_unit_test(the_help_is_whole),
        cmocka_unit_test(lines_are_short),
        cmocka_unit_test(bash_completes),
    };
    return cmocka_run_group_tests_name("manual", tests, NULL, NULL);
}
