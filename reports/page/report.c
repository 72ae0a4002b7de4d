/* Runs and pages of the report. */
#include "reports/page/report.h"

#include "references/scene.h"
#include "verification/command/arguments.h"
#include "verification/text/atomic_file.h"
#include "verification/run/run.h"
#include "verification/command/verb.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

void report_start(struct report_run *run, const char *format, ...) {
    va_list arguments;
    *run = (struct report_run){0};
    struct failure *failure = &run->result.failure;
    va_start(arguments, format);
    int length = vsnprintf(run->command, sizeof run->command, format, arguments);
    va_end(arguments);
    if (length < 0 || (size_t)length >= sizeof run->command)
        refuse(failure, STATUS_INPUT, "a command of the report is too long");
    else
        arguments_parse_line(run->command, &run->request, failure);
}

void report_solve(struct report_run *run) {
    const struct request *r = &run->request;
    if (run->result.failure.status || strcmp(r->verb->name, "run") != 0) return;
    run_experiment(&r->experiment, &run->result, &run->field);
}

int report_check(const struct report_run *run, struct failure *why) {
    const struct failure *failure = &run->result.failure;
    if (!failure->status) return STATUS_OK;
    return refuse(why, failure->status, "heatladder %.100s: %.300s", run->command, failure->text);
}

void report_free(struct report_run *run) {
    field_free(&run->field);
    arguments_free(&run->request);
}

double report_exact(const struct report_run *run, const double x[2]) {
    const struct experiment *e = &run->request.experiment;
    return e->scene->exact(&e->problem, x, run->field.time).temperature;
}

double report_error_as_printed(const struct report_run *run, int decimals) {
    const struct experiment *e = &run->request.experiment;
    const struct field *f = &run->field;
    double apart = 0, whole = 0, unit = pow(10, -decimals);
    for (size_t i = 0; i < f->n; i++) {
        double x[2] = {f->x[i], f->y ? f->y[i] : 0}, w = f->weight ? f->weight[i] : 1;
        double T = e->scene->published ? e->scene->published(&e->problem, x, f->time) : report_exact(run, x);
        if (decimals) T = unit * round(T / unit);
        apart += w * fabs(f->T[i] - T);
        whole += w * fabs(T);
    }
    return apart / whole;
}

int report_open(struct report_page *page, struct failure *why) {
    *page = (struct report_page){0};
    page->out = open_memstream(&page->text, &page->size);
    return page->out ? STATUS_OK : refuse(why, STATUS_NUMERICAL, "out of memory for a page of the report");
}

int report_close(struct report_page *page, const char *dir, const char *name, const char *ending,
                 struct failure *why) {
    char path[1024];
    fclose(page->out);
    int length = snprintf(path, sizeof path, "%s/%s%s", dir, name, ending);
    int status = (size_t)length < sizeof path ? atomic_file_write(path, page->text, page->size, why)
                                              : refuse(why, STATUS_INPUT, "the path '%.100s...' is too long", dir);
    free(page->text);
    *page = (struct report_page){0};
    return status;
}

void report_head(FILE *out, const char *title) {
    fprintf(out, "# title: %s\n# made by: heatladder report DIR\n", title);
}
