/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder man and heatladder completion: the tables of verbs and options for man(1) and bash. */
#include "verification/cli/help.h"

#include "references/scene.h"
#include "solver/method.h"
#include "verification/cli/verb.h"
#include "verification/case/case_file.h"
#include "verification/solve/program.h"
#include "verification/case/columns.h"
#include "verification/text/words.h"

#include <ctype.h>
#include <limits.h>
#include <string.h>

enum { FOLD = 70 }; /* characters per line of the source */

/* Text for roff: its escapes, and a dash that is no hyphen.  No line may start with a dot or a quote; lines of text
 * that is filled end at a blank before `most` letters. */
static void put_folded(const char *text, int most, FILE *out) {
    int column = 0;
    for (int start = 1; *text; start = *text++ == '\n') {
        int next = column + 1 + (int)strcspn(text + 1, " ");
        column = *text == '\n' ? 0 : column + 1;
        if (*text == ' ' && next > most && !strchr(".'", text[1])) {
            fputc('\n', out);
            column = 0;
            continue;
        }
        if (start && (*text == '.' || *text == '\'')) fputs("\\&", out);
        if (*text == '\\')
            fputs("\\e", out);
        else if (*text == '-')
            fputs("\\-", out);
        else
            fputc(*text, out);
    }
}

static void put(const char *text, FILE *out) {
    put_folded(text, FOLD, out);
}

static void put_option(const struct option *o, int required, FILE *out) {
    char words[200] = "", text[600];
    fprintf(out, ".TP\n\\fB\\-\\-");
    put(o->name, out);
    fprintf(out, "\\fR");
    if (o->value) fprintf(out, " \\fI"), put(o->value, out), fprintf(out, "\\fR");
    fputc('\n', out);
    if (o->words) words_join(o->words, words, sizeof words);
    snprintf(text, sizeof text, "%s%s%s%s", o->about, *words ? ": " : "", words, required ? " (required)" : "");
    put(text, out);
    fputc('\n', out);
}

static void put_verb(const struct verb *v, FILE *out) {
    const struct option *list[VERB_ROWS];
    int n = verb_options(v, list);
    fprintf(out, ".SH ");
    for (const char *at = v->syntax->name; *at; at++) fputc(toupper((unsigned char)*at), out);
    fprintf(out, "\n.B heatladder %s\n", v->syntax->name);
    if (*v->syntax->positionals) fprintf(out, ".I %s\n", v->syntax->positionals);
    fprintf(out, "[\\fIoptions\\fR]\n.PP\n");
    put(v->about, out);
    fputc('\n', out);
    for (int i = 0; i < n; i++) {
        if (*list[i]->name)
            put_option(list[i], words_among(v->syntax->required, list[i]->name), out);
        else
            fprintf(out, ".PP\n"), put(list[i]->about, out), fputc('\n', out);
    }
}

static void put_literally(const char *text, FILE *out) {
    fprintf(out, ".nf\n");
    put_folded(text, INT_MAX, out);
    fprintf(out, ".fi\n");
}

/* A hanging title: an option or a variable. */
static void put_title(const char *text, FILE *out) {
    fprintf(out, ".TP\n\\fB"), put(text, out), fprintf(out, "\\fR\n");
}

static void put_names(FILE *out) {
    fprintf(out, ".SH SCENES\n");
    for (int i = 0; scenes[i]; i++) {
        put_title(scenes[i]->name, out);
        put(scenes[i]->about, out), fprintf(out, ".\n"), put(scenes[i]->citation, out), fprintf(out, "\n");
    }
    fprintf(out, ".SH METHODS\n");
    for (int i = 0; methods[i]; i++) {
        put_title(methods[i]->name, out);
        put(methods[i]->about, out), fprintf(out, "\n");
    }
}

/* Titles, up to a NULL, each with its description. */
static void put_section(const char *name, const char *const row[][2], FILE *out) {
    fprintf(out, ".SH %s\n", name);
    for (int i = 0; row[i][0]; i++) {
        put_title(row[i][0], out);
        put(row[i][1], out), fputc('\n', out);
    }
}

static const char *const examples[][2] = {
    {"heatladder verify", "Run every built-in gate."},
    {"heatladder ladder rod-gauss ftcs --dx 0.2,0.1,0.05,0.025 --expect 1.9,2.1",
     "Fit the order of finite differences on smooth data; it must be within 1.9 and 2.1."},
    {"heatladder reference rod-gauss --at 0.3 --time 10", "Evaluate the exact solution at a point."},
    {"heatladder verify --solver './mine {case} {out}'", "Run the battery on your program."},
    {"heatladder case --battery --into cases", "Write the cases of the battery, to run them elsewhere."},
    {"heatladder verify --results cases", "Judge the answers there."},
    {0}};

static const char *const files[][2] = {
    {"DIR/cases.txt", "Directories of the cases that the verb case wrote, one a line."},
    {"DIR/SCENE/DX/case", "A case: key = value, one a line."},
    {"DIR/SCENE/DX/out.csv", "The answer to the case beside it, written by your program."},
    {"DIR/SCENE/DX/log", "Output of your program, with --keep."},
    {"share/heatladder/examples", "Example programs, in the directory of the installation."},
    {0}};

static void put_interfaces(FILE *out) {
    fprintf(out, ".SH \"OTHER PROGRAMS\"\n");
    put_literally(program_help, out);
    fprintf(out, ".SH \"CASE FILE\"\n");
    put_literally(case_file_help, out);
    fprintf(out, ".SH \"COLUMNS OF REFERENCE\"\n");
    put_literally(columns_help, out);
}

void manual_page(FILE *out) {
    fprintf(out, ".TH HEATLADDER 1 2026-11-22 \"heatladder %s\" \"User Commands\"\n", help_version);
    fprintf(out, ".SH NAME\nheatladder \\- verify and benchmark solvers of transient heat conduction\n"
                 ".SH SYNOPSIS\n.B heatladder\n.I VERB\n[\\fIarguments\\fR] [\\fIoptions\\fR]\n"
                 ".SH DESCRIPTION\n"
                 "A scene is a problem of heat conduction with an exact solution.\n"
                 "A ladder solves a scene at several spacings, its rungs, and fits the order\n"
                 "at which the error falls.\n"
                 "A gate is a ladder with an expected band of that order and a ceiling of\n"
                 "the error; the battery is a set of gates for any program.\n"
                 ".PP\nA section for each verb lists its options.\n"
                 "The first of listed words is the default.\n");
    for (int i = 0; verbs[i]; i++) put_verb(verbs[i], out);
    put_names(out);
    put_interfaces(out);
    put_section("EXAMPLES", examples, out);
    put_section("FILES", files, out);
    fprintf(out, ".SH \"ENVIRONMENT AND EXIT STATUS\"\n");
    put_literally(help_about, out);
    fprintf(out, ".SH \"SEE ALSO\"\n.BR gnuplot (1)\n");
}

/* Blank-separated words for compgen, without words that bash would expand. */
static void put_words(const struct verb *v, FILE *out) {
    const struct option *list[VERB_ROWS];
    const char *positionals = v->syntax->positionals;
    int n = verb_options(v, list);
    fprintf(out, "    %s) words=\"%s%s --help", v->syntax->name, strstr(positionals, "SCENE") ? "$scenes " : "",
            words_among(positionals, "METHOD") ? "$methods" : "");
    for (const char *at = positionals; strchr(positionals, '|') && *at != ']'; at++)
        fputc(strchr("[|", *at) ? ' ' : *at, out);
    for (int i = 0; i < n; i++)
        if (*list[i]->name) fprintf(out, " --%s", list[i]->name);
    fprintf(out, "\" ;;\n");
}

static void put_values(FILE *out) {
    for (const struct option *o = command_options; o->name; o++) {
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
    for (int i = 0; verbs[i]; i++) fprintf(out, " %s", verbs[i]->syntax->name);
    fprintf(out, "\"\n    else\n    case \"${COMP_WORDS[COMP_CWORD-1]}\" in\n");
    put_values(out);
    fprintf(out, "    *) case \"$verb\" in\n");
    for (int i = 0; verbs[i]; i++) put_words(verbs[i], out);
    fprintf(out, "    esac ;;\n    esac\n    fi\n"
                 "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n}\n"
                 "complete -o default -F _heatladder heatladder\n");
}

/* ---- Verbs ---- */

static int print_page(const void *options, struct failure *why) {
    (void)options, (void)why;
    manual_page(stdout);
    return STATUS_OK;
}

static int print_completion(const void *options, struct failure *why) {
    (void)options, (void)why;
    manual_completion(stdout);
    return STATUS_OK;
}

static const struct command_syntax man = {"man", "", "", "", NULL}, completion = {"completion", "", "", "", NULL};

const struct verb verb_man = {&man, NULL, sizeof(struct command),
                              "print this help as a manual page: heatladder man | man -l -", print_page};
const struct verb verb_completion = {&completion, NULL, sizeof(struct command),
                                     "print the completion of bash: source <(heatladder completion)",
                                     print_completion};
