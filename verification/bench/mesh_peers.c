/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Three programs that make cells of the same particles, each as its users would: ours with ghosts beyond the walls,
 * Voro++ in a box of one layer, SciPy with images beyond the walls. */
#include "verification/bench/mesh_peers.h"

#include "solver/method.h"
#include "solver/particles/particles.h"
#include "solver/space/voronoi.h"
#include "verification/bench/bench.h"
#include "verification/command/arguments.h"
#include "verification/foreign/scratch.h"
#include "verification/text/table.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <sys/wait.h>

const struct mesh_peer mesh_peers_table[] = {
    {"Voro++", "p=${PEERS:-build/peers}/voro; [ -x $p ] || exit 77; $p \"$@\""},
    {"SciPy Voronoi", "p=${PYTHON:-python3}; command -v $p >/dev/null || exit 77; $p "
                      "verification/bench/peers/voronoi_peer.py \"$@\""},
    {.who = NULL},
};

struct mesh { /* what a program says of its cells */
    double seconds, area, length;
};

static double length_of(const struct voronoi *v) {
    double length = 0;
    for (size_t k = 0; k < v->begin[v->n]; k++) /* of two particles: from either side */
        if (v->point[k] < v->n) length += v->face[k] / 2;
    return length;
}

/* Ours, from the command to the cells; the particles are written to a file where one is given. */
static int take_ours(const struct request *r, FILE *points, struct mesh *m, struct failure *why) {
    const struct experiment *e = &r->experiment;
    struct options o;
    struct lattice l;
    struct cloud c;
    struct voronoi v;
    int rows;
    double start = omp_get_wtime();
    *m = (struct mesh){0};
    if (particles_prepare(&e->problem, &e->options, e->method->scheme, &o, &l, &rows, why) ||
        particles_cloud(&e->problem, &o, e->method->scheme, &l, &c, why))
        return why->status;
    int status = voronoi_create(&v, &e->problem, &c, 1, why);
    m->seconds = omp_get_wtime() - start;
    for (size_t i = 0; i < c.n && points; i++) fprintf(points, "%.17g %.17g\n", c.x[i], c.y[i]);
    if (!status) {
        for (size_t i = 0; i < v.n; i++) m->area += v.volume[i];
        m->length = length_of(&v);
        voronoi_free(&v);
    }
    layout_cloud_free(&c);
    return status;
}

/* STATUS_SKIPPED where it is not installed. */
static int take_theirs(const struct mesh_peer *p, const struct problem *on, const char *points, struct mesh *m,
                       struct failure *why) {
    char command[SCRATCH_PATH + 600], said[200] = "";
    snprintf(command, sizeof command, "f() { %s; }; f '%s' %.17g %.17g %.17g %.17g", p->command, points, on->lo[0],
             on->hi[0], on->lo[1], on->hi[1]);
    FILE *in = popen(command, "r");
    if (in && !fgets(said, sizeof said, in)) said[0] = '\0';
    int status = in ? pclose(in) : -1;
    if (WIFEXITED(status) && WEXITSTATUS(status) == STATUS_SKIPPED) return STATUS_SKIPPED;
    if (status == 0 && sscanf(said, "%lf %lf %lf", &m->seconds, &m->area, &m->length) == 3) return STATUS_OK;
    return refuse(why, STATUS_NUMERICAL, "%s made no cells: '%.100s'", p->who, said);
}

static int compare(const struct mesh_peer *p, const struct mesh *theirs, const struct mesh *ours,
                   struct failure *why) {
    if (fabs(theirs->area - ours->area) <= 1e-9 * ours->area &&
        fabs(theirs->length - ours->length) <= 1e-9 * ours->length)
        return STATUS_OK;
    return refuse(why, STATUS_NUMERICAL,
                  "the cells of %s are not ours: areas %.12g and %.12g m^2, faces %.12g and %.12g m", p->who,
                  theirs->area, ours->area, theirs->length, ours->length);
}

enum { PEERS_MOST = 8 };

static void print_row(struct table *t, const char *who, struct bench_time theirs, const struct bench_time *ours) {
    struct bench_time ratio = ours ? bench_ratio(theirs, *ours) : theirs;
    table_add(t, "%s|%.3g|%.3g to %.3g", who, theirs.median, theirs.lowest, theirs.highest);
    if (ours)
        table_add(t, "%.3g (%.3g to %.3g)", ratio.median, ratio.lowest, ratio.highest);
    else
        table_add(t, " ");
}

static void print(const struct mesh_peer *table, int n, double seconds[][BENCH_RUNS], const int *missing, FILE *out) {
    char header[120];
    snprintf(header, sizeof header,
             "Voronoi cells of %d jittered particles, one thread|seconds|lowest to highest|ours are faster by",
             n * n);
    struct table t = table_headed(1, header);
    struct bench_time ours = bench_summary(seconds[0], BENCH_RUNS);
    print_row(&t, "voronoi_flux", ours, NULL);
    for (int k = 0; table[k].who; k++)
        if (!missing[k]) print_row(&t, table[k].who, bench_summary(seconds[k + 1], BENCH_RUNS), &ours);
    table_end(&t, out);
    for (int k = 0; table[k].who; k++)
        if (missing[k]) fprintf(out, "not installed (make setup-peers): %s\n", table[k].who);
    fputc('\n', out);
}

static int take_rounds(const struct mesh_peer *table, const struct request *r, const char *points,
                       double seconds[][BENCH_RUNS], int *missing, struct failure *why) {
    struct mesh ours, theirs;
    FILE *file = fopen(points, "w");
    if (!file) return refuse(why, STATUS_INPUT, "%s: cannot be written", points);
    int status = take_ours(r, file, &ours, why);
    if (fclose(file) && !status) status = refuse(why, STATUS_INPUT, "%s: cannot be written", points);
    for (int run = 0; run < BENCH_RUNS && !status; run++) {
        status = take_ours(r, NULL, &ours, why);
        seconds[0][run] = ours.seconds;
        for (int k = 0; table[k].who && k < PEERS_MOST && !status; k++) {
            if (missing[k]) continue;
            status = take_theirs(&table[k], &r->experiment.problem, points, &theirs, why);
            missing[k] = status == STATUS_SKIPPED;
            if (missing[k])
                status = STATUS_OK;
            else if (!status)
                status = compare(&table[k], &theirs, &ours, why);
            seconds[k + 1][run] = theirs.seconds;
        }
    }
    return status;
}

int mesh_peers_run(const struct mesh_peer *table, int n, FILE *out, struct failure *why) {
    double seconds[PEERS_MOST + 1][BENCH_RUNS];
    int missing[PEERS_MOST] = {0};
    char line[120], points[SCRATCH_PATH + 20];
    struct request r;
    struct scratch scratch;
    snprintf(line, sizeof line, "run square-step voronoi_flux --layout jitter --jitter 0.3 --seed 1 --dx 4/%d", n);
    int status = arguments_parse_line(line, &r, why);
    if (!status && !(status = scratch_open(&scratch, why))) {
        snprintf(points, sizeof points, "%s/points", scratch.dir);
        status = take_rounds(table, &r, points, seconds, missing, why);
        scratch_close(&scratch);
    }
    arguments_free(&r);
    if (!status) print(table, n, seconds, missing, out);
    return status;
}
