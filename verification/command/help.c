/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help, made from the tables that the arguments are read by, so that it cannot differ from them. */
#include "verification/command/help.h"

#include "verification/foreign/case_file.h"
#include "verification/foreign/program.h"
#include "verification/command/option.h"
#include "verification/oracle/columns.h"
#include "verification/text/table.h"
#include "verification/command/verb.h"
#include "verification/text/words.h"

const char help_about[] =
    "heatladder VERB --help lists the options of a verb; heatladder man has everything.\n"
    "Environment: HEATLADDER_LANES=2, 4 or 8 sets the vector width of the hot loops, in doubles (default: the\n"
    "  widest of the machine); results are the same to the bit for every width.  HEATLADDER is the path of this\n"
    "  program, set for the program of --solver unless you set it.\n"
    "Exit status: 0 all passed, 1 a gate failed, 2 bad usage or input, 3 numerical failure, 4 inconclusive,\n"
    "  77 skipped: the program cannot run the case.\n";

void help_program(FILE *out) {
    fprintf(out, "heatladder: verification and benchmarks for solvers of transient heat conduction\n\n");
    for (const struct verb *v = verbs; v->name; v++) fprintf(out, "  heatladder %-10s %s\n", v->name, v->about);
    fprintf(out, "\n%s", help_about);
}

void help_verb(const struct verb *v, FILE *out) {
    struct table t = table_create(2, 2);
    int lists = 0;
    fprintf(out, "heatladder %s%s%s [options]: %s\n\n", v->name, *v->positionals ? " " : "", v->positionals,
            v->about);
    for (const struct option *o = options_table; o->key; o++) {
        char words[80] = "";
        if (!words_among(v->options, o->key)) continue;
        if (o->words) words_join(o->words, words, sizeof words), lists = 1;
        table_add(&t, "  --%s %s", o->name, o->value ? o->value : ""); /* may have a bar in it */
        table_add(&t, "%s%s%s%s", o->about, *words ? ": " : "", words,
                  words_among(v->required, o->key) ? " (required)" : "");
    }
    table_end(&t, out);
    if (lists) fprintf(out, "\nThe first of listed words is the default.\n");
    if (words_among(v->options, "solver")) fprintf(out, "\n%s\n%s", program_help, case_file_help);
    if (words_among(v->options, "what")) fprintf(out, "\n%s", columns_help);
}
