/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The error half-way between particles: exact where the temperature is a polynomial, and not blind where the
 * particles are. */
#include "verification/choose/halfway.h"

#include "references/scene.h"
#include "verification/choose/choose.h"
#include "verification/command/arguments.h"

#include "verification/unit/near.h"

#include <stdlib.h>
#include <string.h>

static struct request request(const char *line) {
    struct request r;
    struct failure why;
    if (arguments_parse_line(line, &r, &why)) fail_msg("%s", why.text);
    return r;
}

/* The exact solution at the cells' centres, times 1 + off. */
static void sample(const struct experiment *e, int nx, int ny, double off, struct field *f) {
    const struct problem *p = &e->problem;
    field_alloc(f, p->dim, (size_t)nx * (size_t)ny);
    f->time = p->t_end;
    f->shape[0] = nx, f->shape[1] = ny;
    for (int a = 0; a < p->dim; a++) f->spacing[a] = (p->hi[a] - p->lo[a]) / f->shape[a];
    for (int j = 0; j < ny; j++)
        for (int i = 0; i < nx; i++) {
            double x[2] = {p->lo[0] + (i + 0.5) * f->spacing[0], p->lo[1] + (j + 0.5) * f->spacing[1]};
            f->x[j * nx + i] = x[0];
            if (f->y) f->y[j * nx + i] = x[1];
            f->T[j * nx + i] = (1 + off) * scene_exact(e->scene, p, x, p->t_end).temperature;
        }
}

static double error_of(const char *line, int nx, int ny, double off) {
    struct request r = request(line);
    struct field f;
    sample(&r.experiment, nx, ny, off, &f);
    double error = halfway_error(r.experiment.scene, &r.experiment.problem, &f);
    field_free(&f);
    arguments_free(&r);
    return error;
}

/* Interpolation adds 0.013 dx^8 T^(8) at most. */
static void smooth_fields_have_the_error_of_their_points(void **state) {
    (void)state;
    assert_near(error_of("reference rod-gauss --at 0 --time 1", 240, 1, 0), 0, 1e-10);
    assert_near(error_of("reference rod-gauss --at 0 --time 1", 240, 1, 0.0237), 0.0237, 1e-9);
    assert_near(error_of("reference rect-manufactured --at 0,0 --time 1", 40, 28, 0), 0, 1e-8);
    assert_near(error_of("reference rect-manufactured --at 0,0 --time 1", 40, 28, -0.0237), 0.0237, 1e-7);
    /* a kink where the materials meet, midway and on a point; 61 points, so that no side has an even share */
    assert_near(error_of("reference rod-contact --at 0 --time 4", 160, 1, 0), 0, 1e-6);
    assert_near(error_of("reference rod-contact --at 0 --time 4", 161, 1, 0), 0, 1e-6);
    assert_near(error_of("reference rod-contact --at 0 --time 4 --set x_c=0.217", 160, 1, 0), 0, 1e-6);
}

/* Sixteen points on the zeros of a cosine: what lies between them is +-w of a mean of 1. */
static void a_wave_that_the_points_miss_is_seen(void **state) {
    (void)state;
    const char *line = "reference rod-cosine --set mode=16 --set kappa=0.0005 --at 0 --time 1";
    double w = 0.7 * exp(-0.0005 * pow(16 * 3.14159265358979323846, 2)); /* at x = k/16, k = 1 .. 15: 8 times -w */
    assert_near(error_of(line, 16, 1, 0), 15 * w / (15 - w), 1e-12);
}

static void off_a_lattice_nothing_is_known(void **state) {
    (void)state;
    struct request r = request("reference rod-gauss --at 0 --time 1");
    struct field f;
    sample(&r.experiment, 20, 1, 0, &f);
    f.shape[0] = f.shape[1] = 0;
    assert_nan(halfway_error(r.experiment.scene, &r.experiment.problem, &f));
    field_free(&f);
    arguments_free(&r);
}

/* What `choose` proves holds between the particles too, and a coarse run that is exact by luck proves nothing. */
static void a_proof_holds_between_the_particles(void **state) {
    (void)state;
    static const char *const lines[] = {"reference rod-cosine --set mode=16 --set kappa=0.0005 --at 0 --time 1",
                                        "reference rod-cosine --set mode=32 --set kappa=0.0002 --at 0 --time 1",
                                        "reference rod-contact --set x_c=0.2 --at 0 --time 1"};
    for (int k = 0; k < 3; k++) {
        struct request r = request(lines[k]);
        struct failure why;
        struct choose *c = xcalloc(1, sizeof *c);
        double between;
        struct result proof;
        if (choose_run(&r.experiment, 1e-5, choose_work_max, c, &why)) fail_msg("%s: %s", lines[k], why.text);
        assert_int_equal(candidate_prove(c->best.candidate, &r.experiment, c->best.wanted, &proof, &between),
                         STATUS_OK);
        assert_order(between, <=, 1e-5);
        assert_order(proof.error.l1, <=, 1e-5);
        assert_near(between, c->between, 0);
        assert_true(k == 2 || proof.particles > 40);
        arguments_free(&r);
        free(c);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(smooth_fields_have_the_error_of_their_points),
        cmocka_unit_test(a_wave_that_the_points_miss_is_seen),
        cmocka_unit_test(off_a_lattice_nothing_is_known),
        cmocka_unit_test(a_proof_holds_between_the_particles),
    };
    return cmocka_run_group_tests_name("halfway", tests, NULL, NULL);
}
