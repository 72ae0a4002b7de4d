/* What --solver reads back: the header `x,T` or `x,y,T`, then a line a point, in any order.  A line that starts with
 * # is a comment; `# seconds = 1.5`, `# steps = 100` and `# updates = 1e6` tell what the solve took. */
#include "verification/run/external_csv.h"

#include "solver/method.h"
#include "solver/problem.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct reader {
    FILE *in;
    char *text; /* the line, without its end */
    size_t room;
    long line;
    int dim;
    size_t n, points; /* read; room for */
    double *value;    /* dim + 1 of each point */
    double seconds, steps, updates;
};

static void comment(struct reader *c) {
    sscanf(c->text, "# seconds = %lf", &c->seconds);
    sscanf(c->text, "# steps = %lf", &c->steps);
    sscanf(c->text, "# updates = %lf", &c->updates);
}

/* The next line that says something: 1, or 0 at the end. */
static int next_line(struct reader *c) {
    while (getline(&c->text, &c->room, c->in) >= 0) {
        c->line++;
        c->text[strcspn(c->text, "\r\n")] = '\0';
        if (c->text[0] == '#')
            comment(c);
        else if (c->text[0])
            return 1;
    }
    return 0;
}

static void grow(struct reader *c) {
    size_t width = (size_t)c->dim + 1, points = c->points ? 2 * c->points : 1024;
    double *value = xcalloc(points * width, sizeof *value);
    if (c->n) memcpy(value, c->value, c->n * width * sizeof *value);
    free(c->value);
    c->value = value;
    c->points = points;
}

/* dim + 1 numbers with commas between and nothing else: 0, or -1. */
static int read_numbers(const char *text, int count, double *value) {
    for (int i = 0; i < count; i++) {
        char *end;
        value[i] = strtod(text, &end);
        if (end == text) return -1;
        end += strspn(end, " \t");
        if (*end != (i + 1 < count ? ',' : '\0')) return -1;
        text = end + 1;
    }
    return 0;
}

static int read_point(struct reader *c, const struct problem *p, struct failure *why) {
    static const double slack = 1e-9; /* a point on the wall may be off by a rounded decimal */
    if (c->n == c->points) grow(c);
    double *v = c->value + c->n * ((size_t)c->dim + 1);
    if (read_numbers(c->text, c->dim + 1, v))
        return refuse(why, STATUS_INPUT, "the solver's CSV, line %ld: '%.60s' is not %d numbers with commas between",
                      c->line, c->text, c->dim + 1);
    for (int a = 0; a < c->dim; a++) {
        double away = slack * (p->hi[a] - p->lo[a]);
        if (!(v[a] >= p->lo[a] - away && v[a] <= p->hi[a] + away))
            return refuse(why, STATUS_INPUT, "the solver's CSV, line %ld: %c = %g m lies outside of %g to %g m",
                          c->line, "xy"[a], v[a], p -> lo[a], p -> hi[a]);
    }
    if (!isfinite(v[c->dim]))
        return refuse(why, STATUS_NUMERICAL, "the solver's CSV, line %ld: T = %g K is not finite", c->line,
                      v[c->dim]);
    c->n++;
    return STATUS_OK;
}

static int read_all(struct reader *c, const struct problem *p, struct failure *why) {
    const char *header = c->dim == 2 ? "x,y,T" : "x,T";
    if (!next_line(c))
        return refuse(why, STATUS_INPUT, "the solver's CSV is empty; it starts with the line %s", header);
    if (strcmp(c->text, header) != 0)
        return refuse(why, STATUS_INPUT, "the solver's CSV, line %ld: '%.60s' should be the header %s", c->line,
                      c->text, header);
    while (next_line(c))
        if (read_point(c, p, why)) return why->status;
    if (c->n == 0) return refuse(why, STATUS_INPUT, "the solver's CSV has its header and no point");
    return STATUS_OK;
}

static void hand_over(const struct reader *c, const struct problem *p, struct field *f) {
    size_t width = (size_t)c->dim + 1;
    field_alloc(f, c->dim, c->n);
    f->range[0] = HUGE_VAL, f->range[1] = -HUGE_VAL;
    for (size_t i = 0; i < c->n; i++) {
        const double *v = c->value + i * width;
        double x[2] = {v[0], c->dim == 2 ? v[1] : 0}, start = p->initial(p, x);
        f->x[i] = x[0];
        if (f->y) f->y[i] = x[1];
        f->T[i] = v[c->dim];
        f->range[0] = fmin(f->range[0], start), f->range[1] = fmax(f->range[1], start);
    }
    f->heat[0] = f->heat[1] = NAN; /* what volume a point stands for is the program's own affair */
    f->time = p->t_end;
    f->step_seconds = c->seconds;
    f->steps = c->steps > 0 && c->steps < 1e18 ? (long long)c->steps : 0;
    f->updates = c->updates > 0 && c->updates < 1e18 ? (long long)c->updates : 0;
    f->dt = f->steps > 0 ? p->t_end / (double)f->steps : 0;
    f->stages = f->steps > 0;
}

int external_csv_read(const char *path, const struct problem *p, struct field *f, struct failure *why) {
    struct reader c = {.in = fopen(path, "r"), .dim = p->dim, .seconds = NAN};
    if (!c.in) return refuse(why, STATUS_INPUT, "the solver left no CSV at {out}: %s", strerror(errno));
    int status = read_all(&c, p, why);
    if (!status) hand_over(&c, p, f);
    fclose(c.in);
    free(c.text);
    free(c.value);
    return status;
}
