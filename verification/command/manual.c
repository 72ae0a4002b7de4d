/* The tables of verbs and options once more, for man and for bash. */
#include "verification/command/manual.h"

#include "references/scene.h"
#include "solver/method.h"
#include "verification/command/help.h"
#include "verification/command/option.h"
#include "verification/command/verb.h"
#include "verification/foreign/case_file.h"
#include "verification/foreign/program.h"
#include "verification/oracle/columns.h"
#include "verification/command/version.h"
#include "verification/text/words.h"

#include <string.h>

/* Text for roff: its escapes, and a dash that is no hyphen.  No line may start with a dot or a quote. */
static void put(const char *text, FILE *out) {
    for (int start = 1; *text; start = *text++ == '\n') {
        if (start && (*text == '.' || *text == '\'')) fputs("\\&", out);
        if (*text == '\\')
            fputs("\\e", out);
        else if (*text == '-')
            fputs("\\-", out);
        else
            fputc(*text, out);
    }
}

static void put_option(const struct option *o, FILE *out) {
    char words[200] = "";
    fprintf(out, ".TP\n\\fB\\-\\-");
    put(o->name, out);
    fprintf(out, "\\fR");
    if (o->value) fprintf(out, " \\fI"), put(o->value, out), fprintf(out, "\\fR");
    fputc('\n', out);
    put(o->about, out);
    if (o->words) words_join(o->words, words, sizeof words);
    if (*words) fprintf(out, ": "), put(words, out);
    fputc('\n', out);
}

static void put_verb(const struct verb *v, FILE *out) {
    const char *start = "";
    fprintf(out, ".SS \"heatladder %s", v->name);
    fprintf(out, "%s%s\"\n", *v->positionals ? " " : "", v->positionals);
    put(v->about, out);
    fprintf(out, ".\n");
    for (const struct option *o = options_table; o->key; o++) {
        if (!words_among(v->options, o->key)) continue;
        fprintf(out, *start ? ",\n" : "Options:\n");
        start = "more";
        fprintf(out, "\\fB\\-\\-");
        put(o->name, out);
        fprintf(out, "\\fR%s", words_among(v->required, o->key) ? " (required)" : "");
    }
    fprintf(out, *start ? ".\n" : "");
}

static void put_literally(const char *text, FILE *out) {
    fprintf(out, ".nf\n");
    put(text, out);
    fprintf(out, ".fi\n");
}

static void put_names(FILE *out) {
    fprintf(out, ".SH SCENES\n");
    for (int i = 0; scenes[i]; i++) {
        fprintf(out, ".TP\n\\fB"), put(scenes[i]->name, out), fprintf(out, "\\fR\n");
        put(scenes[i]->about, out), fprintf(out, ".\n"), put(scenes[i]->citation, out), fprintf(out, "\n");
    }
    fprintf(out, ".SH METHODS\n");
    for (int i = 0; methods[i]; i++) {
        fprintf(out, ".TP\n\\fB"), put(methods[i]->name, out), fprintf(out, "\\fR\n");
        put(methods[i]->about, out), fprintf(out, "\n");
    }
}

void manual_page(FILE *out) {
    fprintf(out, ".TH HEATLADDER 1 \"\" \"heatladder %s\" \"User Commands\"\n", version_text);
    fprintf(out, ".SH NAME\nheatladder \\- verification and benchmarks for solvers of transient heat conduction\n"
                 ".SH SYNOPSIS\n.B heatladder\n.I VERB\n[\\fIarguments\\fR] [\\fIoptions\\fR]\n"
                 ".SH DESCRIPTION\n");
    put_literally(help_about, out);
    fprintf(out, ".SH VERBS\n");
    for (const struct verb *v = verbs; v->name; v++) put_verb(v, out);
    fprintf(out, ".SH OPTIONS\nEach has a meaning for the verbs that name it above.  "
                 "Of words that are listed the first is the default.\n");
    for (const struct option *o = options_table; o->key; o++) put_option(o, out);
    put_names(out);
    fprintf(out, ".SH \"OTHER PROGRAMS\"\n");
    put_literally(program_help, out);
    fprintf(out, ".PP\n");
    put_literally(case_file_help, out);
    fprintf(out, ".SH \"THE ORACLE\"\n");
    put_literally(columns_help, out);
}

/* Blank-separated words for compgen, without what bash would expand. */
static void put_options(const struct verb *v, FILE *out) {
    for (const struct option *o = options_table; o->key; o++)
        if (words_among(v->options, o->key)) fprintf(out, " --%s", o->name);
}

static void put_values(FILE *out) {
    for (const struct option *o = options_table; o->key; o++) {
        if (!o->words) continue;
        fprintf(out, "    --%s) words=\"", o->name);
        for (int i = 0; o->words[i]; i++) fprintf(out, " %s", o->words[i]);
        fprintf(out, "\" ;;\n");
    }
}

void manual_completion(FILE *out) {
    fprintf(out,
            "# bash completion for heatladder, made by `heatladder completion`\n"
            "_heatladder() {\n    local words=\"\" current=\"${COMP_WORDS[COMP_CWORD]}\" verb=\"${COMP_WORDS[1]}\"\n"
            "    local scenes=\"");
    for (int i = 0; scenes[i]; i++) fprintf(out, " %s", scenes[i]->name);
    fprintf(out, "\" methods=\"");
    for (int i = 0; methods[i]; i++) fprintf(out, " %s", methods[i]->name);
    fprintf(out, "\"\n    if [ \"$COMP_CWORD\" = 1 ]; then\n        words=\"--help --version");
    for (const struct verb *v = verbs; v->name; v++) fprintf(out, " %s", v->name);
    fprintf(out, "\"\n    else\n    case \"${COMP_WORDS[COMP_CWORD-1]}\" in\n");
    put_values(out);
    fprintf(out, "    *) case \"$verb\" in\n");
    for (const struct verb *v = verbs; v->name; v++) {
        fprintf(out, "    %s) words=\"%s%s --help", v->name, strstr(v->positionals, "SCENE") ? "$scenes " : "",
                words_among(v->positionals, "METHOD") ? "$methods" : "");
        for (const char *at = v->positionals; strchr(v->positionals, '|') && *at != ']'; at++)
            fputc(strchr("[|", *at) ? ' ' : *at, out);
        put_options(v, out);
        fprintf(out, "\" ;;\n");
    }
    fprintf(out, "    esac ;;\n    esac\n    fi\n"
                 "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n}\n"
                 "complete -o default -F _heatladder heatladder\n");
}
