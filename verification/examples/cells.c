/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cells CASE OUT [corner]: finite volumes on a grid of cells, explicit Euler.
 *
 *     rho_c dT/dt = source + sum over the faces of a cell of conductance (T_beyond - T)
 *
 * The case file gives the grid and the end time.  `heatladder reference` gives all else (start,
 * source, coefficients, walls) at the points below.  $HEATLADDER is the path of that program.
 *
 * The points are the centres of the cells (o) and, in a frame around them, the centres of the faces
 * on the sides (x). A rectangle of 3 by 2 cells has four rows of five points; a rod of 3 cells has
 * one row; the first and the last layer of a box are part of the frame:
 *
 *     x x x x x
 *     x o o o x        x o o o x
 *     x o o o x
 *     x x x x x
 *
 * They are numbered row by row and layer by layer.  The neighbours of point c along axis d are
 * c - stride[d] and c + stride[d]: stride is 1, the points of a row, and those of a layer.  Where
 * periodic sides meet, the neighbour is the cell at the opposite side. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { PERIODIC, HELD, FLUX, COOLED }; /* the kinds of walls in the answers of `reference` */
enum { NOT_APPLICABLE = 77 };

struct point {
    double x[3];
    double T, source, rho_c;
    struct {
        double k;              /* conductivity */
        double kind, value, b; /* wall: b is the Robin coefficient */
    } axis[3];
    double conductance[6]; /* W m^-3 K^-1, to the neighbours at x low, x high, y low, ... */
    double k_xy;           /* W m^-1 K^-1, of a field */
    double flux;           /* W m^-3, what walls of given flux add */
    double rate;           /* W m^-3 */
    double heat;           /* J m^-3, from the melting point */
};

static int dim = 1, n[3] = {1, 1, 1};
static int source_changes, walls_change;
static double lo[3], hi[3], width[3], t_end, dt_asked;
static char oracle[2048];

/* k that depends on T, if the case has a k_law: k_0 (1 + k_beta u) or k_0 u^k_n, u = T - k_ref */
static char k_law[16];
static double k_0, k_beta, k_ref, k_n;
/* k_law = phases: a solid below k_ref, a liquid above, by their enthalpy */
static int phases;
static double latent, k_phase[2], rho_c_phase[2]; /* solid, liquid */
static char conductivity[16]; /* K is a tensor if this is not empty */

/* two materials on a rod: the place of their interface, and its resistance, if there is one */
static double interface, contact_resistance;

static struct point *point; /* cells and frame */
static int points, stride[3];

/* A tensor with `corner` as the third argument: K, and the flux K grad T, at the lower corner of each cell, along
 * x and y; else its fluxes are those through faces. */
static struct corner {
    double k_x, k_xy, k_y; /* W m^-1 K^-1 */
    double flux[2];        /* W m^-2 */
} *corner;

static void stop(const char *reason) {
    fprintf(stderr, "cells: %s\n", reason);
    exit(1);
}

static void *need(void *pointer, const char *reason) {
    if (!pointer) stop(reason);
    return pointer;
}

/* A line fits one of the formats at most, and changes nothing for the others. */
static void read_case(const char *path) {
    char line[4096], source[16] = "", walls[16] = "";
    int periodic = 0;
    FILE *f = need(fopen(path, "r"), "the case cannot be opened");
    while (fgets(line, sizeof line, f)) {
        sscanf(line, "dim = %d", &dim);
        sscanf(line, "cells = %d, %d, %d", &n[0], &n[1], &n[2]);
        sscanf(line, "lo = %lf, %lf, %lf", &lo[0], &lo[1], &lo[2]);
        sscanf(line, "hi = %lf, %lf, %lf", &hi[0], &hi[1], &hi[2]);
        sscanf(line, "t_end = %lf", &t_end);
        sscanf(line, "dt = %lf", &dt_asked);
        sscanf(line, "source = %15s", source);
        sscanf(line, "walls = %15s", walls);
        sscanf(line, "k_law = %15s", k_law);
        sscanf(line, "k_0 = %lf", &k_0);
        sscanf(line, "k_beta = %lf", &k_beta);
        sscanf(line, "k_ref = %lf", &k_ref);
        sscanf(line, "k_n = %lf", &k_n);
        sscanf(line, "latent = %lf", &latent);
        sscanf(line, "k_phases = %lf, %lf", &k_phase[0], &k_phase[1]);
        sscanf(line, "rho_c_phases = %lf, %lf", &rho_c_phase[0], &rho_c_phase[1]);
        sscanf(line, "interface = %lf", &interface);
        sscanf(line, "contact_resistance = %lf", &contact_resistance);
        sscanf(line, "conductivity = %15s", conductivity);
        sscanf(line, "k_xy = %15s", conductivity);
        sscanf(line, "oracle = %2047[^\n]", oracle);
        /* This code has rods, rectangles and boxes with walls: no round bodies, none with periodic sides alone. */
        if (strncmp(line, "shape", 5) == 0) exit(NOT_APPLICABLE);
        periodic += strstr(line, "= periodic") != NULL;
    }
    fclose(f);
    if (periodic == 2 * dim) exit(NOT_APPLICABLE);
    source_changes = strcmp(source, "changing") == 0;
    phases = strcmp(k_law, "phases") == 0;
    walls_change = strcmp(walls, "changing") == 0;
    for (int d = 0; d < dim; d++) width[d] = (hi[d] - lo[d]) / n[d];
}

/* The place of point c along axis d: 1 to n for cells, 0 and n + 1 for the frame. */
static int place(int c, int d) {
    return c / stride[d] % (n[d] + 2);
}

static int is_cell(int c) {
    for (int d = 0; d < dim; d++)
        if (place(c, d) < 1 || place(c, d) > n[d]) return 0;
    return 1;
}

/* Upwards along axis d for way = 1, downwards for -1. */
static int neighbour(int c, int d, int way) {
    int e = c + way * stride[d];
    int is_side = place(e, d) < 1 || place(e, d) > n[d];
    return is_side && point[e].axis[d].kind == PERIODIC ? e - way * n[d] * stride[d] : e;
}

static void make_points(void) {
    points = 1;
    for (int d = 0; d < dim; d++) {
        stride[d] = points;
        points *= n[d] + 2;
    }
    point = need(calloc((size_t)points, sizeof *point), "out of memory");
    for (int c = 0; c < points; c++)
        for (int d = 0; d < dim; d++) {
            double middle = lo[d] + (place(c, d) - 0.5) * width[d];
            point[c].x[d] = fmin(fmax(middle, lo[d]), hi[d]); /* the frame is on the sides */
        }
}

enum { ALL, FRAME, CORNERS };

/* Writes the points, those of the frame alone, or the lower corner of each, into a file that `reference` reads. */
static void write_points(const char *path, int which) {
    FILE *f = need(fopen(path, "w"), "the points cannot be written");
    fprintf(f, "x,y,z,dx,dy,dz\n"); /* `reference` skips the columns that the case does not have */
    for (int c = 0; c < points; c++) {
        if (which == FRAME && is_cell(c)) continue;
        for (int d = 0; d < 3; d++) {
            double x = point[c].x[d];
            if (which == CORNERS && d < dim) x = lo[d] + fmax(place(c, d) - 1, 0) * width[d];
            fprintf(f, "%.17g,", x);
        }
        fprintf(f, "%.17g,%.17g,%.17g\n", width[0], width[1], width[2]);
    }
    if (fclose(f)) stop("the points cannot be written");
}

/* Starts `heatladder reference` at the points of the file.  Returns its answers, behind the line of
 * headers. */
static FILE *ask(const char *path, const char *times, const char *what) {
    char command[8192], header[4096];
    const char *program = getenv("HEATLADDER");
    int length = snprintf(command, sizeof command, "%s reference %s --points '%s' --time %s --what %s",
                          program ? program : "heatladder", oracle, path, times, what);
    if (length >= (int)sizeof command) stop("the paths are too long");
    FILE *answers = need(popen(command, "r"), "heatladder cannot be started");
    need(fgets(header, sizeof header, answers), "no answer from heatladder reference");
    return answers;
}

/* Numbers are separated by commas, and by the end of a line. */
static double next_number(FILE *answers) {
    double value;
    if (fscanf(answers, "%lf%*[,\n]", &value) != 1) stop("an answer is not a number");
    return value;
}

/* One line a point: its coordinates, then the columns in the order in which they are asked for; a
 * wall is three. */
static void ask_scene(const char *path) {
    static const char *const axes[] = {"", "k_x,wall_x", "k_x,wall_x,k_y,wall_y",
                                       "k_x,wall_x,k_y,wall_y,k_z,wall_z"};
    char what[80];
    snprintf(what, sizeof what, "initial_mean,source,rho_c,%s%s", axes[dim], *conductivity ? ",k_xy" : "");
    FILE *answers = ask(path, "0", what);
    for (struct point *p = point; p < point + points; p++) {
        for (int d = 0; d < dim; d++) next_number(answers); /* the point */
        p->T = next_number(answers);
        p->source = next_number(answers);
        p->rho_c = next_number(answers);
        for (int d = 0; d < dim; d++) {
            p->axis[d].k = next_number(answers);
            p->axis[d].kind = next_number(answers);
            p->axis[d].value = next_number(answers);
            p->axis[d].b = next_number(answers);
        }
        if (*conductivity) p->k_xy = next_number(answers);
    }
    if (pclose(answers)) stop("heatladder reference failed");
}

/* K at the corners; their frame is never used. */
static void ask_corners(const char *path) {
    corner = need(calloc((size_t)points, sizeof *corner), "out of memory");
    write_points(path, CORNERS);
    FILE *answers = ask(path, "0", "k_x,k_xy,k_y");
    for (struct corner *p = corner; p < corner + points; p++) {
        for (int d = 0; d < dim; d++) next_number(answers); /* the point */
        p->k_x = next_number(answers);
        p->k_xy = next_number(answers);
        p->k_y = next_number(answers);
    }
    if (pclose(answers)) stop("heatladder reference failed");
}

static double heat_at(double T) {
    double u = T - k_ref;
    if (u > 0) return rho_c_phase[1] * u + latent;
    return rho_c_phase[0] * u;
}

/* A cell is at the melting point while it takes its latent heat. */
static double temperature_at(double heat) {
    if (heat > latent) return k_ref + (heat - latent) / rho_c_phase[1];
    return k_ref + fmin(heat, 0) / rho_c_phase[0];
}

/* T, or the integral of k from the melting point, W m^-1: the flux through a face is its difference. */
static double potential(double T) {
    return phases ? k_phase[T > k_ref] * (T - k_ref) : T;
}

static double k_at(double T) {
    double u = T - k_ref;
    if (strcmp(k_law, "linear") == 0) return k_0 * (1 + k_beta * u);
    return u > 0 ? k_0 * pow(u, k_n) : 0;
}

/* m^2 K W^-1, with the mean of k at a cell and at the point beyond a face; at a wall that is not held the T of the
 * cell.  The mean of resistances would let no heat into a cell with k = 0. */
static double resistance_of_law(const struct point *p, const struct point *beyond, int d, int is_wall) {
    double distance = is_wall ? width[d] / 2 : width[d];
    double T = beyond->T;
    if (phases) return distance; /* the potential has k */
    if (is_wall && beyond->axis[d].kind != HELD) T = p->T;
    return distance / ((k_at(p->T) + k_at(T)) / 2);
}

/* The face of cell c towards point e.  Resistances add up: those of two half cells, or of a half
 * cell and the wall (none if it is held, 1/b if it is cooled).  Through a wall of given flux no
 * conductance is needed. */
static void make_face(int c, int face, int e) {
    int d = face / 2;
    int is_wall = !is_cell(e);
    struct point *p = &point[c];
    struct point *beyond = &point[e];
    double resistance = width[d] / (2 * p->axis[d].k);
    if (is_wall) beyond->T = beyond->axis[d].value;
    if (is_wall && beyond->axis[d].kind == FLUX) {
        p->flux += beyond->axis[d].value / width[d];
        return;
    }
    if (!is_wall) resistance += width[d] / (2 * beyond->axis[d].k);
    if (contact_resistance > 0 && (p->x[0] < interface) != (beyond->x[0] < interface))
        resistance += contact_resistance;
    if (*k_law) resistance = resistance_of_law(p, beyond, d, is_wall);
    if (*conductivity && is_wall) resistance = width[d] / (2 * beyond->axis[d].k);
    if (*conductivity && !is_wall) /* K at the face, the mean of both cells */
        resistance = 2 * width[d] / (p->axis[d].k + beyond->axis[d].k);
    if (is_wall && beyond->axis[d].kind == COOLED) resistance += 1 / beyond->axis[d].b;
    p->conductance[face] = 1 / (resistance * width[d]);
}

/* Makes the faces of all cells.  Returns the largest sum of kappa/dx^2 over the axes, s^-1. */
static double make_faces(void) {
    double fastest = 0;
    for (int c = 0; c < points; c++) {
        double speed = 0;
        if (!is_cell(c)) continue;
        point[c].flux = 0;
        for (int d = 0; d < dim; d++) {
            make_face(c, 2 * d, neighbour(c, d, -1));
            make_face(c, 2 * d + 1, neighbour(c, d, 1));
            speed += point[c].axis[d].k / (width[d] * width[d] * point[c].rho_c);
        }
        fastest = fmax(fastest, speed);
    }
    return fastest;
}

/* The derivative along d in cell c, K m^-1, the mean of those at its two faces.  Beyond a held wall T is
 * 2 T_wall - T.  No flux, K grad T, crosses an insulated one: `other` is the derivative along the other axis. */
static double slope(int c, int d, double other) {
    double sum = 0;
    for (int way = -1; way <= 1; way += 2) {
        int e = neighbour(c, d, way);
        double step = is_cell(e) ? point[e].T - point[c].T : 2 * (point[e].T - point[c].T);
        if (!is_cell(e) && point[e].axis[d].kind == FLUX)
            sum -= point[c].k_xy / point[c].axis[d].k * other;
        else
            sum += way * step / width[d];
    }
    return sum / 2;
}

/* W m^-3: the fluxes of k_xy through the faces of cell c, with the mean derivative of their two cells; none through
 * a held wall, along which T is uniform, or an insulated one. */
static double cross_fluxes(int c) {
    double sum = 0;
    for (int d = 0; d < 2; d++)
        for (int side = -1; side <= 1; side += 2) {
            int e = neighbour(c, d, side);
            if (!is_cell(e)) continue;
            double k_xy = (point[c].k_xy + point[e].k_xy) / 2, across = side * (point[e].T - point[c].T) / width[d];
            double along = (slope(c, 1 - d, across) + slope(e, 1 - d, across)) / 2;
            sum += side * k_xy * along / width[d];
        }
    return sum;
}

/* T, and beyond walls that of the image: even about an insulated one. */
static double image(int c) {
    for (int d = 0; d < 2; d++) {
        int way = place(c, d) == 0 ? 1 : place(c, d) > n[d] ? -1 : 0;
        if (way == 0) continue;
        if (point[c].axis[d].kind == PERIODIC) return image(c + way * n[d] * stride[d]);
        double T = image(c + way * stride[d]);
        return point[c].axis[d].kind == FLUX ? T : 2 * point[c].axis[d].value - T;
    }
    return point[c].T;
}

/* 1 if the lower corner of c is on an insulated wall across d. */
static int is_insulated(int c, int d) {
    int side = place(c, d) == 1 ? c - stride[d] : c;
    return (place(c, d) == 1 || place(c, d) > n[d]) && point[side].axis[d].kind == FLUX;
}

static void corner_fluxes(void) {
    for (int c = 0; c < points; c++) {
        struct corner *p = &corner[c];
        if (place(c, 0) == 0 || place(c, 1) == 0) continue;
        double T_00 = image(c - stride[0] - stride[1]); /* the four cells around the corner */
        double T_10 = image(c - stride[1]);
        double T_01 = image(c - stride[0]);
        double T_11 = image(c);
        double T_x = (T_10 - T_00 + T_11 - T_01) / (2 * width[0]);
        double T_y = (T_01 - T_00 + T_11 - T_10) / (2 * width[1]);
        if (is_insulated(c, 0)) T_x = -p->k_xy / p->k_x * T_y; /* no flux along x */
        if (is_insulated(c, 1)) T_y = -p->k_xy / p->k_y * T_x;
        p->flux[0] = p->k_x * T_x + p->k_xy * T_y;
        p->flux[1] = p->k_xy * T_x + p->k_y * T_y;
    }
}

/* W m^-3: through each face the mean of the fluxes at both of its ends. */
static double corner_divergence(int c) {
    double sum = 0;
    for (int d = 0; d < 2; d++)
        for (int end = 0; end < 2; end++) {
            const struct corner *low = &corner[c + end * stride[1 - d]];
            sum += (low[stride[d]].flux[d] - low->flux[d]) / (2 * width[d]);
        }
    return sum;
}

/* Adds what flows into cell c through its faces. */
static void add_fluxes(int c) {
    struct point *p = &point[c];
    if (*conductivity) p->rate += cross_fluxes(c);
    for (int face = 0; face < 2 * dim; face++) {
        int e = neighbour(c, face / 2, face % 2 ? 1 : -1);
        p->rate += p->conductance[face] * (potential(point[e].T) - potential(p->T));
    }
}

/* One step of Euler's method: all rates first, then all temperatures. */
static void step_by(double dt) {
    if (corner) corner_fluxes();
    for (int c = 0; c < points; c++) {
        struct point *p = &point[c];
        if (!is_cell(c)) continue;
        p->rate = p->source + p->flux;
        if (corner)
            p->rate += corner_divergence(c);
        else
            add_fluxes(c);
    }
    for (int c = 0; c < points; c++) {
        struct point *p = &point[c];
        if (!is_cell(c)) continue;
        if (phases) {
            p->heat += dt * p->rate;
            p->T = temperature_at(p->heat);
        } else {
            p->T += dt * p->rate / p->rho_c;
        }
    }
}

/* One block: a line a point, with the time and the point before its source. */
static void read_sources(FILE *sources) {
    for (int c = 0; c < points; c++) {
        for (int d = 0; d < 1 + dim; d++) next_number(sources);
        point[c].source = next_number(sources);
    }
}

/* The same for the walls at the points of the frame. */
static void read_walls(FILE *walls) {
    for (int c = 0; c < points; c++) {
        if (is_cell(c)) continue;
        for (int d = 0; d < 1 + dim; d++) next_number(walls);
        for (int d = 0; d < dim; d++) {
            next_number(walls);
            point[c].axis[d].value = next_number(walls);
            next_number(walls);
        }
    }
    if (!*k_law) make_faces(); /* else with the temperatures of the step */
}

/* Data that change in time are asked for at the start of every step, all times at once: a block of
 * lines a time.  The block of the end time is left unread. */
static void run(const char *path, const char *frame, int steps) {
    static const char *const walls_of[] = {"", "wall_x", "wall_x,wall_y", "wall_x,wall_y,wall_z"};
    char times[64];
    FILE *sources = NULL, *walls = NULL;
    snprintf(times, sizeof times, "0:%.17g:%d", t_end, steps + 1);
    if (source_changes) sources = ask(path, times, "source");
    if (walls_change) {
        write_points(frame, FRAME);
        walls = ask(frame, times, walls_of[dim]);
    }
    for (int step = 0; step < steps; step++) {
        if (sources) read_sources(sources);
        if (walls) read_walls(walls);
        if (*k_law) make_faces();
        step_by(t_end / steps);
    }
    if (sources) pclose(sources);
    if (walls) pclose(walls);
}

static void write_answer(const char *path, int steps, double seconds) {
    FILE *f = need(fopen(path, "w"), "the answer cannot be written");
    static const char *const header[] = {"", "x,T", "x,y,T", "x,y,z,T"};
    fprintf(f, "# steps = %d\n# seconds = %g\n%s\n", steps, seconds, header[dim]);
    for (struct point *p = point; p < point + points; p++) {
        if (!is_cell((int)(p - point))) continue;
        for (int d = 0; d < dim; d++) fprintf(f, "%.17g,", p->x[d]);
        fprintf(f, "%.17g\n", p->T);
    }
    if (fclose(f)) stop("the answer cannot be written");
}

int main(int argc, char **argv) {
    char path[4096], frame[4096];
    if (argc < 3 || (argc > 3 && strcmp(argv[3], "corner"))) stop("arguments: CASE OUT [corner]");
    snprintf(path, sizeof path, "%s.points", argv[2]);
    snprintf(frame, sizeof frame, "%s.frame", argv[2]);
    read_case(argv[1]);
    make_points();
    write_points(path, ALL);
    ask_scene(path);
    if (argc > 3 && *conductivity) ask_corners(frame);
    if (phases)
        for (struct point *p = point; p < point + points; p++) p->heat = heat_at(p->T);
    int steps = (int)ceil(t_end * make_faces() / 0.25); /* half of what is stable */
    if (dt_asked > 0) steps = (int)ceil(t_end / dt_asked - 1e-9);
    clock_t begun = clock();
    run(path, frame, steps);
    write_answer(argv[2], steps, (double)(clock() - begun) / CLOCKS_PER_SEC);
    return 0;
}
