/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder: the command line.  It finds the verb, and prints its failure. */
#include "solver/method.h"
#include "verification/cli/help.h"
#include "verification/cli/surroundings.h"
#include "verification/cli/verb.h"
#include "verification/text/utf8.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int wants_help(int argc, char *const *argv) {
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) return 1;
    return argc > 1 && strcmp(argv[1], "help") == 0;
}

static int help(int argc, char *const *argv) {
    const struct verb *verb = NULL;
    for (int i = 1; i < argc && !verb; i++) verb = verb_find(argv[i]);
    if (verb)
        help_verb(verb, stdout);
    else
        help_program(stdout);
    return STATUS_OK;
}

/* Prints the text on one line, without control characters of words or files that it quotes. */
static void print_failure(const char *text) {
    fputs("heatladder: ", stderr);
    for (size_t length; *text; text += length ? length : 1) {
        length = utf8_length(text);
        fwrite(length ? text : "?", 1, length ? length : 1, stderr);
    }
    fputc('\n', stderr);
}

static int act(int argc, char *const *argv) {
    struct failure why = {0};
    const struct verb *verb = verb_find(argv[1]);
    void *options = verb ? xcalloc(1, verb->size) : NULL;
    int status = verb ? STATUS_OK : verb_unknown(argv[1], &why);
    if (!status) status = command_parse(verb->syntax, verb->own, argc - 1, argv + 1, options, &why);
    if (!status) surroundings_wait_passively(options, argv);
    if (!status) status = verb->act(options, &why);
    if (status && *why.text) print_failure(why.text);
    if (verb) command_free(options);
    free(options);
    return status_exit(status);
}

/* A failure to write standard output, such as a full disk or a closed pipe, is a failure. */
static int flush(int status) {
    if (fflush(stdout) == 0 && !ferror(stdout)) return status;
    perror("heatladder: standard output");
    return status ? status : STATUS_INPUT;
}

static int answer(int argc, char **argv) {
    if (argc < 2) {
        help_program(stderr);
        return STATUS_INPUT;
    }
    if (strcmp(argv[1], "--version") == 0)
        return flush(printf("heatladder %s\n", help_version) < 0 ? STATUS_INPUT : STATUS_OK);
    return flush(wants_help(argc, argv) ? help(argc, argv) : act(argc, argv));
}

int main(int argc, char **argv) {
    surroundings_prepare(argv[0]);
    int status = answer(argc, argv);
    surroundings_leave();
    return status;
}
