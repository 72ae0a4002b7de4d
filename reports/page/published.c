/* Reads a published table. */
#include "reports/page/published.h"

#include "solver/method.h"
#include "verification/text/number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char FOLDER[] = "reports/published";

/* Cuts *line at its commas into at most max cells; how many. */
static int cells_of(char *line, char **cell, int max) {
    int n = 0;
    line[strcspn(line, "\r\n")] = '\0';
    for (char *at = line; at && n < max; n++) {
        cell[n] = at;
        at = strchr(at, ',');
        if (at) *at++ = '\0';
    }
    return n;
}

static int fits(char **cell, int n) {
    for (int i = 0; i < n; i++)
        if (strlen(cell[i]) >= REPORT_PUBLISHED_CELL || !*cell[i]) return 0;
    return n > 1;
}

static void take_header(struct published *t, char **cell, int n) {
    t->columns = n - 1;
    for (int c = 0; c < t->columns; c++) strcpy(t->where[c], cell[c + 1]);
}

/* 0, or -1 where a cell is no number or there is no room. */
static int take_row(struct published *t, char **cell, int n) {
    int r = t->rows;
    if (r == REPORT_PUBLISHED_ROWS || n != t->columns + 1) return -1;
    strcpy(t->method[r], cell[0]);
    for (int c = 0; c < t->columns; c++) {
        strcpy(t->cell[r][c], cell[c + 1]);
        if (number_read(cell[c + 1], &t->value[r][c])) return -1;
    }
    t->rows++;
    return 0;
}

int published_read(struct published *t, const char *name, struct failure *why) {
    char path[160], line[400], *cell[REPORT_PUBLISHED_COLUMNS + 1];
    snprintf(path, sizeof path, "%s/%s.csv", FOLDER, name);
    *t = (struct published){0};
    FILE *in = fopen(path, "r");
    if (!in)
        return refuse(why, STATUS_INPUT, "cannot read '%s': run `heatladder report` where the folder %s is", path,
                      FOLDER);
    int bad = 0;
    while (!bad && fgets(line, sizeof line, in)) {
        if (*line == '#' || *line == '\n') continue;
        int n = cells_of(line, cell, REPORT_PUBLISHED_COLUMNS + 1);
        bad = !fits(cell, n);
        if (bad) continue;
        if (t->columns == 0)
            take_header(t, cell, n);
        else
            bad = take_row(t, cell, n);
    }
    fclose(in);
    if (bad || t->rows == 0) return refuse(why, STATUS_INPUT, "'%s' is no table of numbers with a header", path);
    return STATUS_OK;
}

double published_units(const char *printed, double measured) {
    char *end;
    double value = strtod(printed, &end);
    const char *point = strchr(printed, '.'), *power = strpbrk(printed, "eE");
    long digits = point ? (power ? power : end) - point - 1 : 0;
    double unit = pow(10, (power ? (double)atol(power + 1) : 0) - (double)digits);
    return round(measured / unit) - round(value / unit);
}
