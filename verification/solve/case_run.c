/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs one case: removes old answers, fills in the command, runs it and keeps its exit status. */
#include "verification/solve/case_run.h"

#include "verification/case/results.h"
#include "solver/status.h"
#include "verification/solve/process.h"
#include "verification/text/output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PATH_SIZE = 1100 };

/* Temporary names for {out}; NumPy's save() appends its extension. */
static const char *const parts[][2] = {{"out.part", "out.csv"}, {"out.part.npy", "out.npy"}};

static char *path_in(const char *dir, const char *name, char path[PATH_SIZE]) {
    snprintf(path, PATH_SIZE, "%.1030s/%s", dir, name);
    return path;
}

int case_run_status(const char *dir) {
    char path[PATH_SIZE];
    int status = -1;
    FILE *in = fopen(path_in(dir, "status", path), "r");
    if (in && (fscanf(in, "%d", &status) != 1 || status < 0 || status > 255)) status = -1;
    if (in) fclose(in);
    return status;
}

/* Replaces the known words between braces in the command; other braces stay.  The caller frees the result. */
static char *fill_in(const struct case_run *c, const char *input, const char *output) {
    char *text;
    size_t size;
    const char *name[] = {"case", "out", "dx", c->name}, *value[] = {input, output, c->dx, c->value};
    FILE *out = output_stream(&text, &size);
    for (const char *at = c->solver; *at; at++) {
        int found = -1;
        for (int i = 0; *at == '{' && i < 4 && name[i]; i++) {
            size_t n = strlen(name[i]);
            if (strncmp(at + 1, name[i], n) == 0 && at[n + 1] == '}') found = i;
        }
        if (found < 0) {
            fputc(*at, out);
        } else {
            fputs(value[found], out);
            at += strlen(name[found]) + 1;
        }
    }
    fclose(out);
    return text;
}

/* Removes earlier answers, which could be taken for the answer of this run. */
static int remove_old(const char *dir, struct failure *why) {
    char path[PATH_SIZE];
    for (int i = 0; results_answers[i]; i++)
        if (unlink(path_in(dir, results_answers[i], path)) && errno != ENOENT)
            return refuse(why, STATUS_INPUT, "cannot replace '%.300s': %s", path, strerror(errno));
    for (int i = 0; i < 2; i++) unlink(path_in(dir, parts[i][0], path));
    if (unlink(path_in(dir, "status", path)) && errno != ENOENT)
        return refuse(why, STATUS_INPUT, "cannot replace '%.300s': %s", path, strerror(errno));
    return STATUS_OK;
}

static void put_in_place(const char *dir) {
    char from[PATH_SIZE], to[PATH_SIZE];
    for (int i = 0; i < 2; i++)
        if (rename(path_in(dir, parts[i][0], from), path_in(dir, parts[i][1], to)) == 0) return;
}

static int keep_status(const char *dir, int code, struct failure *why) {
    struct output page;
    fprintf(output_open(&page, "%s/status", dir), "%d\n", code);
    return output_close(&page, 1, why);
}

int case_run(const struct case_run *c, const char *scratch, int *code, struct failure *why) {
    char input[PATH_SIZE], output[PATH_SIZE], log[PATH_SIZE];
    *code = -1;
    *why = (struct failure){0};
    if (remove_old(c->dir, why)) return why->status;
    char *command = fill_in(c, path_in(c->dir, "case", input), path_in(c->dir, parts[0][0], output));
    struct process process = {
        .command = command, .label = c->label, .dir = scratch, .timeout = c->timeout, .code = code};
    if (!(process.log = fopen(path_in(c->dir, "log", log), "w")))
        refuse(why, STATUS_INPUT, "cannot write '%.300s': %s", log, strerror(errno));
    else
        process_run(&process, why);
    if (process.log) fclose(process.log);
    free(command);
    struct failure unwritten;
    if (*code == 0) put_in_place(c->dir);
    if (*code >= 0 && keep_status(c->dir, *code, &unwritten)) *why = unwritten;
    return why->status;
}
