/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help, printed from the tables that also parse the arguments, so that the two cannot differ. */
#include "verification/cli/help.h"

#include "solver/words.h"
#include "verification/case/case_file.h"
#include "verification/solve/program.h"
#include "verification/case/columns.h"
#include "verification/cli/verb.h"

#include "version.inc"

#include <string.h>

enum { WIDE = 100 }; /* characters per line */

const char help_version[] = VERSION_TEXT;

const char help_about[] =
    "heatladder VERB --help lists the options of a verb.\n"
    "Environment:\n"
    "  HEATLADDER_LANES  vector width of the hot loops in doubles, 2, 4 or 8 (default: the widest of the machine);\n"
    "                    results are the same to the bit for every width\n"
    "  HEATLADDER        path of this program, set for the program of --solver unless you set it\n"
    "  TMPDIR            directory of temporary files, default /tmp; the program of --solver gets its own\n"
    "  NO_COLOR          if set: no colours on a terminal\n"
    "  GITHUB_ACTIONS    if set: verify also prints failing gates as annotations\n"
    "Exit status: 0 all passed, 1 a gate failed, 2 bad usage or input, 3 numerical failure, 4 inconclusive,\n"
    "  77 skipped: the program cannot run the case.\n";

/* A word or two, then a text in lines of at most `WIDE` letters that begin below each other. */
static void put_entry(FILE *out, const char *lead, int indent, const char *text) {
    int column = fprintf(out, "%-*s", indent, lead);
    while (*text) {
        int length = (int)strcspn(text, " ");
        if (column > indent && column + 1 + length > WIDE) column = fprintf(out, "\n%*s", indent, "") - 1;
        column += fprintf(out, "%s%.*s", column > indent ? " " : "", length, text);
        text += length + (text[length] == ' ');
    }
    fputc('\n', out);
}

void help_program(FILE *out) {
    fprintf(out, "heatladder: verification and benchmarks for solvers of transient heat conduction\n\n");
    for (int i = 0; verbs[i]; i++) {
        char lead[40];
        snprintf(lead, sizeof lead, "  heatladder %s ", verbs[i]->syntax->name);
        put_entry(out, lead, 24, verbs[i]->about);
    }
    fprintf(out, "\n%s", help_about);
}

void help_verb(const struct verb *v, FILE *out) {
    const struct option *list[VERB_ROWS];
    const struct command_syntax *s = v->syntax;
    int lists = 0, indent = 0, n = verb_options(v, list);
    fprintf(out, "heatladder %s%s%s [options]\n\n", s->name, *s->positionals ? " " : "", s->positionals);
    put_entry(out, "  ", 2, v->about);
    fputc('\n', out);
    for (int i = 0; i < n; i++) {
        int width = 7 + (int)strlen(list[i]->name) + (list[i]->value ? (int)strlen(list[i]->value) : 0);
        if (width > indent) indent = width;
    }
    for (int i = 0; i < n; i++) {
        const struct option *o = list[i];
        char words[200] = "", lead[80], text[600];
        if (o->words) words_join(o->words, words, sizeof words), lists = 1;
        snprintf(lead, sizeof lead, "  --%s %s", o->name, o->value ? o->value : "");
        snprintf(text, sizeof text, "%s%s%s%s", o->about, *words ? ": " : "", words,
                 words_among(s->required, o->name) ? " (required)" : "");
        put_entry(out, *o->name ? lead : "", *o->name ? indent : 0, text);
    }
    if (lists) fprintf(out, "\nThe first of listed words is the default.\n");
    if (command_option(s, v->own, "solver")) fprintf(out, "\n%s\n%s", program_help, case_file_help);
    if (command_option(s, v->own, "what")) fprintf(out, "\n%s", columns_help);
}
