/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of the battery for corners: a volume counted twice or a face halved at either cooled corner is above the
 * ceiling in every draw, and the same code without the fault is below it. */
#include "verification/gates/battery.h"

#include "references/mapping.h"
#include "references/scene.h"
#include "references/snapshot.h"
#include "solver/status.h"
#include "verification/case/command.h"

#include "verification/unit/near.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NX = 24, NY = 40, NODES = (NX + 1) * (NY + 1) }; /* 0.025 m */
enum corner_fault { RIGHT, VOLUME, FACE };

/* Control volumes around the nodes of plate-cooling. */
struct plate {
    double heat[NODES], link[NODES][2], air[NODES], T[NODES]; /* J/(m K), W/(m K) to the next along x and y, to air */
};

static double half_at_ends(int i, int n) {
    return i == 0 || i == n ? 0.5 : 1;
}

/* corner: the node of the fault. */
static void lay_out(const struct problem *p, enum corner_fault fault, int corner, struct plate *v) {
    const double dx = p->hi[0] / NX, k = p->material[0].k[0], b = p->robin[X_HI];
    for (int c = 0; c < NODES; c++) {
        int i = c % (NX + 1), j = c / (NX + 1);
        double wide = half_at_ends(i, NX), high = half_at_ends(j, NY);
        v->heat[c] = p->material[0].rho_c * dx * dx * wide * high * (fault == VOLUME && c == corner ? 2 : 1);
        v->link[c][0] = i < NX ? k * high : 0;
        v->link[c][1] = j < NY ? k * wide : 0;
        v->air[c] = b * dx * ((i == NX) * high + (j == NY) * wide);
        if (fault == FACE && c == corner) v->air[c] -= b * dx / 4;
        v->T[c] = j ? p->start : p->held[Y_LO];
    }
}

/* Midpoint steps. */
static void advance(struct plate *v, double T_a, double t_end, double fastest) {
    static double start[NODES], rate[NODES];
    const int next[2] = {1, NX + 1}, steps = (int)ceil(t_end * fastest / 0.4);
    for (int s = 0; s < 2 * steps; s++) {
        for (int c = 0; c < NODES; c++) rate[c] = v->air[c] * (T_a - v->T[c]);
        for (int c = 0; c < NODES; c++)
            for (int a = 0; a < 2; a++) {
                if (v->link[c][a] == 0) continue;
                double flow = v->link[c][a] * (v->T[c + next[a]] - v->T[c]);
                rate[c] += flow, rate[c + next[a]] -= flow;
            }
        for (int c = 0; c < NODES; c++) {
            if (s % 2 == 0) start[c] = v->T[c];
            if (c > NX) v->T[c] = start[c] + (s % 2 ? 1 : 0.5) * t_end / steps * rate[c] / v->heat[c];
        }
    }
}

/* The largest error, K. */
static double largest(const struct problem *p, const double *exact, enum corner_fault fault, int corner) {
    static struct plate v;
    double dx = p->hi[0] / NX, most = 0;
    lay_out(p, fault, corner, &v);
    advance(&v, p->held[X_HI], p->t_end, 4 * p->material[0].k[0] / (p->material[0].rho_c * dx * dx));
    for (int c = 0; c < NODES; c++) most = fmax(most, fabs(v.T[c] - exact[c]));
    return most;
}

static void faults_at_cooled_corners_are_above_the_ceiling(void **state) {
    (void)state;
    static const int corners[2] = {NY * (NX + 1), NODES - 1};
    for (unsigned long seed = 0; seed <= 5; seed++) {
        struct gates g = {0};
        struct failure why;
        static double exact[NODES];
        if (battery_add(2, PROFILE_ALL, seed, &g, &why) ||
            gates_choose(&g, "plane/corners,plane/opposite", NULL, 0, &why) || battery_bounds(&g, &why))
            fail_msg("%s", why.text);
        assert_int_equal(g.declared, 2);
        for (int r = 0; r < 2; r++) {
            struct experiment e = gates_finest(g.result[r].read);
            const struct problem *p = &e.problem;
            const double ceiling = g.result[r].gate.ceiling;
            assert_near(e.options.dx, p->hi[0] / NX, 1e-12);
            struct snapshot s = snapshot_take(e.scene, p, p->t_end);
            for (int c = 0; c < NODES; c++) {
                double x[DIM_MAX] = {c % (NX + 1) * e.options.dx, c / (NX + 1) * e.options.dx};
                exact[c] = snapshot_at(&s, x).temperature;
            }
            snapshot_free(&s);
            double right = largest(p, exact, RIGHT, 0);
            print_message("%s, seed %lu, in ceilings: %.2f", g.result[r].gate.id, seed, right / ceiling);
            assert_order(right, <, ceiling / 2);
            for (int k = 0; k < 4; k++) {
                double wrong = largest(p, exact, k < 2 ? VOLUME : FACE, corners[k % 2]);
                print_message(" %.2f", wrong / ceiling);
                assert_order(wrong, >, ceiling);
            }
            print_message("\n");
        }
        gates_free(&g);
    }
}

/* The scene is held across y_lo and cooled across x_hi and y_hi. */
static int sees(const struct mapping *m, enum side across_x, enum side across_y) {
    enum side a = mapping_side(m, across_x), b = mapping_side(m, across_y);
    int held = a == Y_LO || b == Y_LO, cooled = a == X_HI || b == X_HI || a == Y_HI || b == Y_HI;
    return cooled && !held;
}

static void each_corner_of_the_case_is_cooled_in_one_of_two_rows(void **state) {
    (void)state;
    for (unsigned long seed = 1; seed <= 50; seed++) {
        struct gates g = {0};
        struct failure why;
        if (battery_add(2, PROFILE_ALL, seed, &g, &why) ||
            gates_choose(&g, "plane/corners,plane/opposite", NULL, 0, &why))
            fail_msg("%s", why.text);
        for (int corner = 0; corner < 4; corner++) {
            int seen = 0;
            for (int r = 0; r < 2; r++) {
                struct mapping m = {0};
                char text[MAPPING_WORDS] = "";
                assert_int_equal(sscanf(strstr(g.result[r].gate.command, "--map "), "--map %11s", text), 1);
                assert_int_equal(mapping_read(text, &m), 0);
                seen += sees(&m, corner % 2 ? X_HI : X_LO, corner / 2 ? Y_HI : Y_LO);
            }
            if (seen == 0) fail_msg("seed %lu, corner %d", seed, corner);
        }
        gates_free(&g);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_corner_of_the_case_is_cooled_in_one_of_two_rows),
        cmocka_unit_test(faults_at_cooled_corners_are_above_the_ceiling),
    };
    return cmocka_run_group_tests_name("corners", tests, NULL, NULL);
}
