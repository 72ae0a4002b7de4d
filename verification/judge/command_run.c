/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A command line, run and kept. */
#include "verification/judge/command_run.h"

#include "references/scene.h"
#include "verification/judge/run.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int read_list(struct command_run *run, const char *format, va_list arguments) {
    *run = (struct command_run){0};
    struct failure *why = &run->result.failure;
    int length = vsnprintf(run->command, sizeof run->command, format, arguments);
    if (length < 0 || (size_t)length >= sizeof run->command)
        return refuse(why, STATUS_INPUT, "the command '%.60s...' is too long", run->command);
    return command_read(run->command, &run->typed, why);
}

int command_run_list(struct command_run *run, const char *format, va_list arguments) {
    int status = read_list(run, format, arguments);
    return status || strcmp(run->typed.syntax->name, "run") != 0 ? status : command_run_solve(run);
}

int command_run_read(struct command_run *run, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    int status = read_list(run, format, arguments);
    va_end(arguments);
    return status;
}

int command_run_solve(struct command_run *run) {
    return run_experiment(&run->typed.experiment, &run->result, &run->field);
}

int command_run_line(struct command_run *run, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    int status = command_run_list(run, format, arguments);
    va_end(arguments);
    return status;
}

int command_run_check(const struct command_run *run, struct failure *why) {
    const struct failure *failure = &run->result.failure;
    if (!failure->status) return STATUS_OK;
    return refuse(why, failure->status, "heatladder %.100s: %.300s", run->command, failure->text);
}

int command_run_note(const struct command_run *run, struct failure *any) {
    struct failure why;
    int status = command_run_check(run, &why);
#pragma omp critical(command_run_note)
    if (status) *any = why;
    return status;
}

double command_run_error(const struct command_run *run, int decimals, double late) {
    const struct experiment *e = &run->typed.experiment;
    const struct field *f = &run->field;
    double apart = 0, whole = 0, unit = pow(10, -decimals), t = f->time + late;
    for (size_t i = 0; i < f->n; i++) {
        double x[DIM_MAX], w = f->weight ? f->weight[i] : 1;
        field_place(f, i, x);
        double T = e->scene->published ? e->scene->published(&e->problem, x, t) : command_run_exact(run, x, t);
        if (decimals) T = unit * round(T / unit);
        apart += w * fabs(f->T[i] - T);
        whole += w * fabs(T);
    }
    return apart / whole;
}

double command_run_exact(const struct command_run *run, const double x[2], double t) {
    return scene_exact(run->typed.experiment.scene, &run->typed.experiment.problem, x, t).temperature;
}

void command_run_free(struct command_run *run) {
    field_free(&run->field);
    command_free(&run->typed);
}
