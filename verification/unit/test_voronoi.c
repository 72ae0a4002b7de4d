/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Voronoi cells on clouds without symmetry, and the operator on their faces: identities that hold to round-off, and
 * refusals. */
#include "solver/particles/particles.h"
#include "solver/space/assembly.h"
#include "solver/space/voronoi.h"
#include "solver/shape.h"

#include "verification/unit/near.h"
#include "verification/unit/odd_problems.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

extern const struct method method_voronoi_flux;

static const struct kind {
    enum layout_name layout;
    double jitter;
} kinds[] = {{LAYOUT_JITTER, 0},   {LAYOUT_JITTER, 0.1},  {LAYOUT_JITTER, 0.3},
             {LAYOUT_JITTER, 0.5}, {LAYOUT_HEXAGONAL, 0}, {LAYOUT_RELAXED, 0.5}};
enum { KINDS = sizeof kinds / sizeof *kinds };

struct made {
    struct problem p;
    struct options o;
    struct cloud c;
    double dx;
};

/* k_x/k_y = 0.7/0.4, or 1; with two materials of one such ratio where `interface` is a number. */
static void make(struct made *m, const struct kind *kind, int isotropic, double interface) {
    struct lattice l;
    struct failure why;
    m->p = odd_rectangle();
    m->o = (struct options){
        .dx = 0.05, .h = 2, .seed = 7, .layout = kind->layout, .jitter = kind->jitter, .sweeps = 2000};
    if (isotropic) m->p.material[0].k[1] = m->p.material[0].k[0];
    if (!isnan(interface)) {
        m->p.materials = 2, m->p.interface = interface;
        m->p.material[1] = (struct material){{0.07 * m->p.material[0].k[0], 0.07 * m->p.material[0].k[1]}, 0.31};
    }
    assert_int_equal(layout_lattice(&m->p, &m->o, &l, &why), STATUS_OK);
    m->dx = l.dx[0];
    if (layout_cloud(&m->p, &m->o, &l, 4 * l.dx[0], &m->c, &why)) fail_msg("%s", why.text);
}

static double face_from(const struct voronoi *v, size_t i, size_t j) {
    for (size_t k = v->begin[i]; k < v->begin[i + 1]; k++)
        if (v->point[k] == j) return v->face[k];
    return 0;
}

static void voronoi_cells_fill_the_body(void **state) {
    (void)state;
    for (int k = 0; k < 2 * KINDS; k++) {
        struct made m;
        struct voronoi v;
        struct failure why;
        double sum = 0, beyond = 0, scale[2], wall = 0;
        make(&m, &kinds[k / 2], k % 2, 0.213);
        if (voronoi_create(&v, &m.p, &m.c, 2, &why)) fail_msg("%s", why.text);
        voronoi_metric(&m.p.material[0], 2, scale);
        for (size_t i = 0; i < v.n; i++) {
            double out[2] = {0, 0}, square = 0;
            sum += v.volume[i], beyond += v.volume[i] * v.beyond[i];
            assert_order(v.volume[i], >, 0);
            assert_order(v.beyond[i], >=, 0);
            assert_order(v.beyond[i], <=, 1);
            for (size_t q = v.begin[i]; q < v.begin[i + 1]; q++) {
                size_t j = v.point[q];
                double d[2] = {(m.c.x[j] - m.c.x[i]) * scale[0], (m.c.y[j] - m.c.y[i]) * scale[1]};
                double r = hypot(d[0], d[1]);
                for (int a = 0; a < 2; a++) out[a] += v.face[q] * d[a] / r;
                square += v.face[q] * r;
                assert_order(v.face[q], >=, 0);
                if (j < v.n) assert_memory_equal(&v.face[q], &(double){face_from(&v, j, i)}, sizeof(double));
                if (j >= v.n && v.face[q] > 0) assert_int_equal(m.c.source[j], i);
                if (j >= v.n && d[0] < 0 && fabs(d[0]) > r / 2) wall += v.face[q] / scale[1];
            }
            assert_near(out[0] / m.dx, 0, 2e-10);
            assert_near(out[1] / m.dx, 0, 2e-10);
            assert_near(square / (4 * v.volume[i]), 1, 1e-9);
        }
        assert_near(sum, 1.5 * 1.2, 1e-12);
        assert_near(beyond, (1.15 - 0.213) * 1.2, 1e-9);
        assert_near(wall, 1.2, 1e-9);
        voronoi_free(&v);
        layout_cloud_free(&m.c);
    }
}

static double held(const struct problem *p, enum side s, const double x[2], double t) {
    (void)p, (void)s, (void)x, (void)t;
    return 0;
}

/* A disc and a ring on five clouds: volumes add up to the body's, walls to its circles.  The faces of an inner cell
 * close; the gap of a cell at a wall is the chord of its arc. */
static void voronoi_cells_fill_a_round_body(void **state) {
    (void)state;
    for (int k = 0; k < 10; k++) {
        double hole = k % 2 ? 0.37 : 0, sum = 0, wall[2] = {0, 0}, arcs = 0;
        struct problem p = {.materials = 1, .material = {{{0.7, 0.7}, 1.3}}, .wall = held};
        struct options o = {
            .dx = 0.06, .seed = 3, .layout = kinds[k / 2].layout, .jitter = kinds[k / 2].jitter, .sweeps = 2000};
        struct lattice l;
        struct cloud c;
        struct voronoi v;
        struct failure why;
        shape_round(&p, hole, 1.1);
        assert_int_equal(layout_lattice(&p, &o, &l, &why), STATUS_OK);
        if (layout_cloud(&p, &o, &l, 4 * l.dx[0], &c, &why)) fail_msg("%s", why.text);
        if (voronoi_create(&v, &p, &c, 2, &why)) fail_msg("%s", why.text);
        for (size_t i = 0; i < v.n; i++) {
            double out[2] = {0, 0}, chord = 0, size = 0;
            sum += v.volume[i];
            assert_order(v.volume[i], >, 0);
            assert_order(shape_depth(&p, (const double[2]){c.x[i], c.y[i]}), >=, 0.25 * l.dx[0]);
            for (size_t q = v.begin[i]; q < v.begin[i + 1]; q++) {
                size_t j = v.point[q];
                double d[2] = {c.x[j] - c.x[i], c.y[j] - c.y[i]}, r = hypot(d[0], d[1]);
                assert_order(v.face[q], >=, 0);
                if (j < v.n) {
                    assert_memory_equal(&v.face[q], &(double){face_from(&v, j, i)}, sizeof(double));
                    for (int a = 0; a < 2; a++) out[a] += v.face[q] * d[a] / r;
                    continue;
                }
                int outer = hypot(c.x[j], c.y[j]) > 1.1;
                double R = outer ? 1.1 : hole;
                wall[outer] += v.face[q], arcs += v.face[q] > 0;
                chord += 2 * R * sin(v.face[q] / (2 * R)), size += v.face[q];
            }
            assert_near(hypot(out[0], out[1]), chord, 1e-9 * (l.dx[0] + size));
        }
        assert_near(sum / (M_PI * (1.1 * 1.1 - hole * hole)), 1, 1e-13);
        assert_near(wall[1], 2.2 * M_PI, 1e-9);
        assert_near(wall[0], 2 * M_PI * hole, 1e-9);
        assert_order(arcs, >, 60);
        voronoi_free(&v);
        layout_cloud_free(&c);
    }
}

/* A square whose edges each cross a circle about its middle twice: the outer circle, or that of a hole.  The circle
 * extends beyond an edge by a segment of half the angle acos(0.8/R). */
static void edges_crossing_a_circle_twice_are_clipped(void **state) {
    (void)state;
    for (int hole = 0; hole < 2; hole++) {
        double R = hole ? 0.9 : 1, half = acos(0.8 / R), segment = R * R * half - 0.8 * R * sin(half);
        double radius[2] = {hole ? R : 0, hole ? 2.5 : R}, at[2] = {0.3, -0.2}, inside = M_PI * R * R - 4 * segment;
        struct voronoi_polygon square = {.n = 4};
        for (int k = 0; k < 4; k++) {
            square.x[k] = (k == 0 || k == 3 ? -0.8 : 0.8) - at[0];
            square.y[k] = (k < 2 ? -0.8 : 0.8) - at[1];
        }
        struct voronoi_round r = voronoi_round(&square, at, radius);
        assert_near(r.area, hole ? 2.56 - inside : inside, 1e-14);
        assert_near(r.wall[!hole], (2 * M_PI - 8 * half) * R, 1e-14);
        assert_near(r.farthest, hole ? 2.21 : 1.85, 1e-14); /* to (-0.8, 0.8), or to (-0.8, 0.6) */
        for (int k = 0; k < 4; k++) assert_near(r.face[k], hole ? 1.6 - 2 * R * sin(half) : 2 * R * sin(half), 1e-14);
    }
}

static double gap(const double *a, const double *b, size_t n) {
    return memcmp(a, b, n * sizeof *a) ? 1 : 0;
}

static void threads_change_no_voronoi_cell(void **state) {
    (void)state;
    struct made m;
    struct voronoi v[2];
    struct failure why;
    make(&m, &kinds[3], 0, NAN);
    for (int k = 0; k < 2; k++) assert_int_equal(voronoi_create(&v[k], &m.p, &m.c, 1 + 2 * k, &why), STATUS_OK);
    assert_int_equal(v[0].begin[v[0].n], v[1].begin[v[1].n]);
    assert_near(gap(v[0].face, v[1].face, v[0].begin[v[0].n]), 0, 0);
    assert_near(gap(v[0].volume, v[1].volume, v[0].n), 0, 0);
    for (int k = 0; k < 2; k++) voronoi_free(&v[k]);
    layout_cloud_free(&m.c);
}

/* C_i A_ij = C_j A_ji up to the round-off of a quotient; no weight is negative away from walls; the weights of each
 * row add up to its diagonal. */
static void voronoi_operator_is_symmetric(void **state) {
    (void)state;
    for (int k = 0; k < 2 * KINDS; k++) {
        struct made m;
        struct heat_operator a;
        struct failure why;
        make(&m, &kinds[k / 2], k % 2, k % 3 ? 0.213 : NAN);
        for (size_t g = m.c.n; g < m.c.total; g++) m.c.factor[g] = 1; /* insulated */
        if (assembly_operator(&a, &m.p, &m.o, method_voronoi_flux.scheme, &m.c, m.dx, &why)) fail_msg("%s", why.text);
        double *held = xcalloc(a.n * a.n, sizeof *held);
        operator_dense(&a, held);
        for (size_t i = 0; i < a.n; i++) {
            double capacity = a.volume[i] * (a.rho_c ? a.rho_c[i] : m.p.material[0].rho_c), sum = 0;
            for (size_t j = 0; j < a.n; j++) {
                sum += held[i * a.n + j];
                if (j != i) assert_order(held[i * a.n + j], >=, 0);
            }
            assert_near(sum / a.diagonal[i], 0, 1e-9);
            for (size_t j = 0; j < a.n; j++) held[i * a.n + j] *= capacity;
        }
        for (size_t i = 0; i < a.n; i++)
            for (size_t j = 0; j < i; j++) {
                double here = held[i * a.n + j], there = held[j * a.n + i];
                if (here != 0 || there != 0) assert_near(here / there, 1, 4.5e-16);
            }
        free(held);
        operator_free(&a);
        layout_cloud_free(&m.c);
    }
}

/* Away from walls: the temperature of a steady flux along x stays, across the interface too, and so does y with one
 * material; x^2/k_x + y^2/k_y rises by 4/rho_c. */
static void voronoi_rows_are_exact_for_linear_fields(void **state) {
    (void)state;
    for (int k = 0; k < 2 * KINDS; k++) {
        struct made m;
        struct heat_operator a;
        struct failure why;
        int two = k % 2;
        make(&m, &kinds[k / 2], 0, two ? 0.213 : NAN);
        if (assembly_operator(&a, &m.p, &m.o, method_voronoi_flux.scheme, &m.c, m.dx, &why)) fail_msg("%s", why.text);
        const double *K = m.p.material[0].k, rho_c = m.p.material[0].rho_c;
        for (size_t i = 0; i < a.n; i++) {
            double x = m.c.x[i], y = m.c.y[i], sum[3] = {0, 0, 0}, size = fabs(a.diagonal[i]) * 0.05;
            if (fabs(x - 0.4) > 0.45 || fabs(y - 0.8) > 0.3) continue;
            for (size_t q = a.row[i]; q < a.row[i + 1]; q++) {
                size_t j = a.column[q];
                double w = a.value[q], there = m.c.x[j], dx = there - x, dy = m.c.y[j] - y;
                double near = x - 0.213, far = there - 0.213; /* distances from the interface */
                if (two) dx = (far > 0 ? far / 0.07 : far) - (near > 0 ? near / 0.07 : near);
                sum[0] += w * dx, sum[1] += w * dy, sum[2] += w * (dx * dx / K[0] + dy * dy / K[1]);
            }
            assert_near(sum[0] / size, 0, 1e-8);
            if (two) continue;
            assert_near(sum[1] / size, 0, 1e-8);
            assert_near(sum[2], 4 / rho_c, 1e-7);
        }
        operator_free(&a);
        layout_cloud_free(&m.c);
    }
}

static double linear(const struct problem *p, const double x[2]) {
    (void)p;
    return 0.7 + 1.3 * x[0] - 0.4 * x[1] + (x[0] > 0.213 ? 2.5 : 0);
}

/* The mean of linear data over all cells is that of the body, jump and capacities among them. */
static void voronoi_averages_conserve_heat(void **state) {
    (void)state;
    for (int k = 0; k < KINDS; k++) {
        struct made m;
        struct voronoi v;
        struct failure why;
        make(&m, &kinds[k], 0, 0.213);
        m.p.initial = linear, m.p.jumps[0] = 1, m.p.jump[0][0] = 0.213;
        assert_int_equal(voronoi_create(&v, &m.p, &m.c, 1, &why), STATUS_OK);
        double *T = xcalloc(m.c.n, sizeof *T), sum = 0, c0 = 1.3, c1 = 0.31, low = 0.213 + 0.35, high = 1.15 - 0.213;
        assert_int_equal(voronoi_average(&m.p, &m.c, 2, T, &why), STATUS_OK);
        for (size_t i = 0; i < m.c.n; i++) sum += T[i] * v.volume[i] * ((1 - v.beyond[i]) * c0 + v.beyond[i] * c1);
        double left = c0 * 1.2 * low * (0.7 + 1.3 * (0.213 - 0.35) / 2 - 0.4 * 0.8);
        double right = c1 * 1.2 * high * (0.7 + 2.5 + 1.3 * (0.213 + 1.15) / 2 - 0.4 * 0.8);
        assert_near(sum / (left + right), 1, 1e-8);
        free(T);
        voronoi_free(&v);
        layout_cloud_free(&m.c);
    }
}

/* ---- Rods, single cells, refusals ---- */

static void rod_cells_end_at_midpoints(void **state) {
    (void)state;
    double d[4][2] = {{0.31, 0}, {-0.17, 0}, {0.11, 0}, {-0.4, 0}}, face[4], volume;
    assert_int_equal(voronoi_cell(1, 4, d, face, &volume), 0);
    assert_near(volume, 0.14, 1e-15);
    for (int j = 0; j < 4; j++) assert_near(face[j], j == 1 || j == 2, 0);
    assert_int_equal(voronoi_cell(1, 1, d, face, &volume), -1);
    d[2][0] = 0; /* at the particle's own place */
    assert_int_equal(voronoi_cell(1, 4, d, face, &volume), -1);
}

static void voronoi_cell_equals_hand_calculation(void **state) {
    (void)state;
    /* a rectangle of 0.3 x 0.5 with one corner cut by the bisector of (0.4, 0.6) */
    double d[5][2] = {{0.3, 0}, {-0.3, 0}, {0, 0.5}, {0, -0.5}, {0.4, 0.6}}, face[5], volume;
    assert_int_equal(voronoi_cell(2, 5, d, face, &volume), 0);
    assert_near(volume, 0.15, 1e-15);
    assert_near(face[4], 0, 0);
    d[4][0] = 0.2, d[4][1] = 0.3; /* 0.2 x + 0.3 y = 0.065 cuts x = 0.15 at y = 7/60 and y = 0.25 at x = -0.05 */
    assert_int_equal(voronoi_cell(2, 5, d, face, &volume), 0);
    assert_near(volume, 0.15 - 0.2 * (0.25 - 7 / 60.0) / 2, 1e-15);
    assert_near(face[4], hypot(0.2, 0.25 - 7 / 60.0), 1e-15);
    assert_near(face[0], 0.25 + 7 / 60.0, 1e-15);
    assert_int_equal(voronoi_cell(2, 3, d, face, &volume), -1);
    assert_int_equal(voronoi_cell(2, 0, d, face, &volume), -1);
}

static void bad_clouds_are_refused(void **state) {
    (void)state;
    struct made m;
    struct voronoi v;
    struct failure why;
    make(&m, &kinds[2], 1, NAN);
    m.c.x[11] = m.c.x[3], m.c.y[11] = m.c.y[3];
    assert_int_equal(voronoi_create(&v, &m.p, &m.c, 1, &why), STATUS_NUMERICAL);
    assert_has(why.text, "particle 3 at");
    assert_has(why.text, "at the same place");
    layout_cloud_free(&m.c);
    make(&m, &kinds[2], 1, NAN);
    m.c.total = m.c.n; /* no ghosts: cells at the walls have no end */
    assert_int_equal(voronoi_create(&v, &m.p, &m.c, 1, &why), STATUS_NUMERICAL);
    assert_has(why.text, "does not end within");
    layout_cloud_free(&m.c);
    m.p.materials = 2, m.p.material[0].k[0] = 0.8, m.p.material[0].k[1] = 0.4;
    m.p.material[1] = (struct material){{0.3, 0.9}, 1};
    assert_int_equal(particles_check(&m.p, &m.o, method_voronoi_flux.scheme, &why), STATUS_NOT_APPLICABLE);
    assert_has(why.text, "k_y/k_x is 0.5 in one material and 3 in the other, but cells have one metric");
}

int main(void) {
    gsl_set_error_handler_off();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(voronoi_cells_fill_the_body),
        cmocka_unit_test(voronoi_cells_fill_a_round_body),
        cmocka_unit_test(edges_crossing_a_circle_twice_are_clipped),
        cmocka_unit_test(threads_change_no_voronoi_cell),
        cmocka_unit_test(voronoi_operator_is_symmetric),
        cmocka_unit_test(voronoi_rows_are_exact_for_linear_fields),
        cmocka_unit_test(voronoi_averages_conserve_heat),
        cmocka_unit_test(rod_cells_end_at_midpoints),
        cmocka_unit_test(voronoi_cell_equals_hand_calculation),
        cmocka_unit_test(bad_clouds_are_refused),
    };
    return cmocka_run_group_tests_name("voronoi", tests, NULL, NULL);
}
