/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cvode CASE OUT: SUNDIALS' CVODE (BDF, a banded matrix) on finite volumes on a grid of cells.
 *
 *     rho_c dT/dt = source + sum over the faces of a cell of conductance (T_beyond - T)
 *
 * The case file gives the grid and the end time.  `heatladder reference` gives all else (start,
 * source, coefficients, walls) at the centres of the cells and of the faces on the sides.
 * $HEATLADDER is the path of that program. */
#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_band.h>
#include <time.h>

enum { HELD = 1, FLUX = 2, COOLED = 3 }; /* the kinds of walls in the answers of `reference` */
enum { NOT_APPLICABLE = 77 };

struct point {
    double x[2];
    double source, rho_c, flux; /* flux: W m^-3, from walls of given flux */
    struct {
        double k;              /* conductivity */
        double kind, value, b; /* wall: b is the Robin coefficient */
    } axis[2];
    double conductance[2]; /* W m^-3 K^-1, to the next point along x and along y */
};

static int dim = 1, n[2] = {1, 1};
static int data_change; /* source or walls, with time */
static double lo[2], hi[2] = {0, 1}, width[2], t_end;
static char oracle[2048];

/* k that depends on T, if the case has a k_law: k_0 (1 + k_beta u) or k_0 u^k_n, u = T - k_ref */
static char k_law[16];
static double k_0, k_beta, k_ref, k_n;

/* The points: cells 1 to n along each axis, in a frame of the centres of the faces on the sides
 * (see cells.c). */
static struct point *point;
static int points, stride[2] = {1, 0};
static double *held; /* the temperature at each point of the frame */

static void stop(const char *reason) {
    fprintf(stderr, "cvode: %s\n", reason);
    exit(1);
}

static void *need(void *pointer, const char *reason) {
    if (!pointer) stop(reason);
    return pointer;
}

static void read_case(const char *path) {
    char line[4096], source[16] = "", walls[16] = "";
    FILE *f = need(fopen(path, "r"), "the case cannot be opened");
    while (fgets(line, sizeof line, f)) {
        sscanf(line, "dim = %d", &dim);
        sscanf(line, "cells = %d, %d", &n[0], &n[1]);
        sscanf(line, "lo = %lf, %lf", &lo[0], &lo[1]);
        sscanf(line, "hi = %lf, %lf", &hi[0], &hi[1]);
        sscanf(line, "t_end = %lf", &t_end);
        sscanf(line, "source = %15s", source);
        sscanf(line, "walls = %15s", walls);
        sscanf(line, "k_law = %15s", k_law);
        sscanf(line, "k_0 = %lf", &k_0);
        sscanf(line, "k_beta = %lf", &k_beta);
        sscanf(line, "k_ref = %lf", &k_ref);
        sscanf(line, "k_n = %lf", &k_n);
        sscanf(line, "oracle = %2047[^\n]", oracle);
        /* This code has rods and rectangles with walls: neither round bodies nor periodic ones. */
        if (strncmp(line, "shape", 5) == 0) exit(NOT_APPLICABLE);
        if (strncmp(line, "contact_resistance", 18) == 0) exit(NOT_APPLICABLE);
        if (strncmp(line, "conductivity", 12) == 0) exit(NOT_APPLICABLE);
        if (strncmp(line, "latent", 6) == 0) exit(NOT_APPLICABLE);
        if (strstr(line, "= periodic")) exit(NOT_APPLICABLE);
        if (dim == 3) exit(NOT_APPLICABLE);
    }
    fclose(f);
    data_change = strcmp(source, "changing") == 0 || strcmp(walls, "changing") == 0;
    for (int d = 0; d < 2; d++) width[d] = (hi[d] - lo[d]) / n[d];
}

static int place(int c, int d) {
    if (d == 0) return c % stride[1];
    return dim == 2 ? c / stride[1] : 1;
}

static int on_wall(int c, int d) {
    return place(c, d) < 1 || place(c, d) > n[d];
}

static int is_cell(int c) {
    return !on_wall(c, 0) && !on_wall(c, 1);
}

static void write_points(const char *path) {
    FILE *f = need(fopen(path, "w"), "the points cannot be written");
    fprintf(f, "x,y,dx,dy\n");
    for (int c = 0; c < points; c++)
        fprintf(f, "%.17g,%.17g,%.17g,%.17g\n", point[c].x[0], point[c].x[1], width[0], width[1]);
    if (fclose(f)) stop("the points cannot be written");
}

static void make_points(const char *path) {
    stride[1] = n[0] + 2;
    points = stride[1] * (dim == 2 ? n[1] + 2 : 1);
    point = need(calloc((size_t)points, sizeof *point), "out of memory");
    held = need(calloc((size_t)points, sizeof *held), "out of memory");
    for (int c = 0; c < points; c++)
        for (int d = 0; d < dim; d++) {
            double middle = lo[d] + (place(c, d) - 0.5) * width[d];
            point[c].x[d] = fmin(fmax(middle, lo[d]), hi[d]); /* the frame is on the sides */
        }
    write_points(path);
}

static double next_number(FILE *answers) {
    double value;
    if (fscanf(answers, "%lf%*[,\n]", &value) != 1) stop("an answer is not a number");
    return value;
}

static FILE *ask(const char *path, const char *times, const char *what) {
    char command[8192], header[4096];
    const char *program = getenv("HEATLADDER");
    snprintf(command, sizeof command, "%s reference %s --points '%s' --time %s --what %s",
             program ? program : "heatladder", oracle, path, times, what);
    FILE *answers = need(popen(command, "r"), "heatladder cannot be started");
    need(fgets(header, sizeof header, answers), "no answer from heatladder reference");
    return answers;
}

static void ask_scene(const char *path, double *T) {
    FILE *answers = ask(path, "0", dim == 2 ? "initial_mean,source,rho_c,k_x,wall_x,k_y,wall_y"
                                            : "initial_mean,source,rho_c,k_x,wall_x");
    for (int c = 0; c < points; c++) {
        struct point *p = &point[c];
        for (int d = 0; d < dim; d++) next_number(answers); /* the point */
        T[c] = next_number(answers);
        p->source = next_number(answers);
        p->rho_c = next_number(answers);
        for (int d = 0; d < dim; d++) {
            p->axis[d].k = next_number(answers);
            p->axis[d].kind = next_number(answers);
            p->axis[d].value = next_number(answers);
            p->axis[d].b = next_number(answers);
        }
    }
    if (pclose(answers)) stop("heatladder reference failed");
}

/* Data that change in time, at equal steps from 0 to the end: [time][point][source and the walls]. */
enum { TIMES = 129, COLUMNS = 3 };
static double *table;

static void ask_table(const char *path) {
    char times[64];
    table = need(calloc((size_t)TIMES * (size_t)points * COLUMNS, sizeof *table), "out of memory");
    snprintf(times, sizeof times, "0:%.17g:%d", t_end, TIMES);
    FILE *answers = ask(path, times, dim == 2 ? "source,wall_x,wall_y" : "source,wall_x");
    for (double *row = table; row < table + TIMES * points * COLUMNS; row += COLUMNS) {
        for (int d = 0; d < 1 + dim; d++) next_number(answers); /* the time and the point */
        row[0] = next_number(answers);
        for (int d = 0; d < dim; d++) {
            next_number(answers);
            row[1 + d] = next_number(answers);
            next_number(answers);
        }
    }
    if (pclose(answers)) stop("heatladder reference failed");
}

/* The cubic through four of the times around `now`; the integrator chooses its times itself. */
static double changing(int c, int column, double now) {
    double place = now / t_end * (TIMES - 1), sum = 0;
    int first = (int)fmin(fmax(floor(place) - 1, 0), TIMES - 4);
    for (int i = first; i < first + 4; i++) {
        double weight = 1;
        for (int j = first; j < first + 4; j++)
            if (j != i) weight *= (place - j) / (i - j);
        sum += weight * table[COLUMNS * (i * points + c) + column];
    }
    return sum;
}

/* Resistance between point c and the face beside it, m^2 K W^-1: half a cell, or the wall. */
static double resistance(int c, int d) {
    const struct point *p = &point[c];
    if (!on_wall(c, d)) return width[d] / (2 * p->axis[d].k);
    if (p->axis[d].kind == HELD) return 0;
    if (p->axis[d].kind == COOLED) return 1 / p->axis[d].b;
    return INFINITY; /* a given flux, whatever the temperatures */
}

static void make_faces(void) {
    for (int c = 0; c < points; c++)
        for (int d = 0; d < dim; d++) {
            int next = c + stride[d];
            if (on_wall(c, !d) || place(c, d) > n[d]) continue; /* no face between these two */
            point[c].conductance[d] = 1 / ((resistance(c, d) + resistance(next, d)) * width[d]);
        }
}

static double k_at(double T) {
    double u = T - k_ref;
    if (strcmp(k_law, "linear") == 0) return k_0 * (1 + k_beta * u);
    return u > 0 ? k_0 * pow(u, k_n) : 0;
}

/* Conductances for the temperatures T, with the mean of k at both points of a face. */
static void set_conductances(const double *T) {
    for (int c = 0; c < points; c++)
        for (int d = 0; d < dim; d++) {
            int next = c + stride[d], wall = on_wall(c, d) ? c : on_wall(next, d) ? next : -1;
            if (on_wall(c, !d) || place(c, d) > n[d]) continue;
            int cell = wall == c ? next : c, held_wall = wall >= 0 && point[wall].axis[d].kind == HELD;
            double other = wall < 0 ? T[next] : held_wall ? held[wall] : T[cell];
            double k = (k_at(T[cell]) + k_at(other)) / 2, distance = wall < 0 ? width[d] : width[d] / 2;
            double beyond = wall < 0 ? 0 : resistance(wall, d);
            point[c].conductance[d] = 1 / ((distance / k + beyond) * width[d]);
        }
}

/* Sets the data at the time `now`: sources, held temperatures, and the heat of given fluxes. */
static void set_data(double now) {
    for (int c = 0; c < points; c++) {
        point[c].flux = 0;
        if (data_change) point[c].source = changing(c, 0, now);
    }
    for (int c = 0; c < points; c++)
        for (int d = 0; d < dim; d++) {
            int inside = place(c, d) < 1 ? c + stride[d] : c - stride[d];
            if (!on_wall(c, d) || on_wall(c, !d)) continue;
            held[c] = data_change ? changing(c, 1 + d, now) : point[c].axis[d].value;
            if (point[c].axis[d].kind == FLUX) point[inside].flux += held[c] / width[d];
        }
}

static int rhs(double now, N_Vector state, N_Vector derivative, void *user) {
    const double *T = N_VGetArrayPointer(state);
    double *dT_dt = N_VGetArrayPointer(derivative);
    (void)user;
    if (data_change) set_data(now);
    if (*k_law) set_conductances(T);
    for (int c = 0; c < points; c++) {
        dT_dt[c] = 0;
        if (!is_cell(c)) continue;
        double rate = point[c].source + point[c].flux;
        for (int d = 0; d < dim; d++) {
            int previous = c - stride[d], next = c + stride[d];
            double before = on_wall(previous, d) ? held[previous] : T[previous];
            double after = on_wall(next, d) ? held[next] : T[next];
            rate += point[c].conductance[d] * (after - T[c]);
            rate += point[previous].conductance[d] * (before - T[c]);
        }
        dT_dt[c] = rate / point[c].rho_c;
    }
    return 0;
}

static void integrate(N_Vector state, SUNContext sun) {
    double t;
    int band = dim == 1 ? 1 : stride[1];
    void *ode = need(CVodeCreate(CV_BDF, sun), "CVodeCreate failed");
    SUNMatrix jacobian = need(SUNBandMatrix(points, band, band, sun), "SUNBandMatrix failed");
    SUNLinearSolver solver = need(SUNLinSol_Band(state, jacobian, sun), "SUNLinSol_Band failed");
    if (CVodeInit(ode, rhs, 0, state)) stop("CVodeInit failed");
    if (CVodeSStolerances(ode, 1e-8, 1e-10)) stop("CVodeSStolerances failed");
    if (CVodeSetMaxNumSteps(ode, 1000000)) stop("CVodeSetMaxNumSteps failed");
    if (CVodeSetLinearSolver(ode, solver, jacobian)) stop("CVodeSetLinearSolver failed");
    if (CVode(ode, t_end, state, &t, CV_NORMAL)) stop("CVode failed");
}

static void write_answer(const char *path, const double *T, double seconds) {
    FILE *f = need(fopen(path, "w"), "the answer cannot be written");
    fprintf(f, "# seconds = %g\n%s\n", seconds, dim == 2 ? "x,y,T" : "x,T");
    for (int c = 0; c < points; c++) {
        if (!is_cell(c)) continue;
        for (int d = 0; d < dim; d++) fprintf(f, "%.17g,", point[c].x[d]);
        fprintf(f, "%.17g\n", T[c]);
    }
    if (fclose(f)) stop("the answer cannot be written");
}

int main(int argc, char **argv) {
    char path[4096];
    SUNContext sun;
    if (argc != 3) stop("two arguments are needed: CASE OUT");
    snprintf(path, sizeof path, "%s.points", argv[2]);
    read_case(argv[1]);
    make_points(path);
    if (SUNContext_Create(NULL, &sun)) stop("SUNContext_Create failed");
    N_Vector state = need(N_VNew_Serial(points, sun), "N_VNew_Serial failed");
    double *T = N_VGetArrayPointer(state);
    ask_scene(path, T);
    if (data_change) ask_table(path);
    make_faces();
    set_data(0);
    clock_t begun = clock();
    integrate(state, sun);
    write_answer(argv[2], T, (double)(clock() - begun) / CLOCKS_PER_SEC);
    return 0;
}
