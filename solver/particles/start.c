/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The initial temperatures of a run.
 *
 * Heat content of initial data with a jump at the contact of two materials, as conserved by the operator:
 *
 * Rows that are exact for piecewise quadratics across the interface are not symmetric.  They conserve sum_i l_i T_i
 * with l A = 0, where l_i differs from a particle's heat capacity next to the contact (on clouds everywhere).  Let
 * H_i be 1 on one side and 0 on the other. sum_i l_i H_i is the heat capacity of that side up to s times that of a
 * particle, s = O(1), with the opposite error on the other side.  Initial data T1 and T2 then have s (T1 - T2) of a
 * particle's heat too much.  This is a first-order error, and cell averages do not change it, since a contact
 * between cells leaves nothing to average.  Initial data with the right sum_i l_i T_i are second order, because the
 * remaining error is a dipole of O(dx^2).
 *
 * l is the stationary distribution of a Markov chain with the rates A_ij.  For rates >= 0 elimination from the far
 * end computes it without cancellation (Grassmann, Taksar, Heyman 1985, Oper. Res. 33:1107). */
#include "solver/particles/start.h"

#include "solver/particles/particles.h"
#include "solver/shape.h"
#include "solver/space/assembly.h"
#include "solver/space/kernel.h"
#include "solver/space/sample.h"
#include "solver/time/matched.h"

#include <math.h>
#include <stdlib.h>

/* ---- The heat of a jump at a contact ---- */

static size_t bandwidth(const struct heat_operator *a) {
    size_t band = 0;
    for (size_t i = 0; i < a->n; i++)
        for (size_t k = a->row[i]; k < a->row[i + 1]; k++) {
            size_t j = a->column[k], distance = j > i ? j - i : i - j;
            if (distance > band) band = distance;
        }
    return band;
}

int start_kept(const struct heat_operator *a, double all, double *l, struct failure *why) {
    size_t n = a->n, band = bandwidth(a), width = 2 * band + 1;
    double *rate = xcalloc(n * width, sizeof *rate), sum = 0;
    for (size_t i = 0; i < n; i++)
        for (size_t k = a->row[i]; k < a->row[i + 1]; k++) rate[i * width + a->column[k] + band - i] = a->value[k];
    int status = STATUS_OK;
    for (size_t k = n - 1; k > 0 && !status; k--) { /* eliminate k: transitions to k go on to its targets */
        size_t first = k > band ? k - band : 0;
        const double *from = &rate[k * width + band - k];
        double away = 0;
        for (size_t j = first; j < k; j++) away += from[j];
        if (!(fabs(away) > 0))
            status = refuse(why, STATUS_NUMERICAL,
                            "particle %zu has no weights towards earlier ones, so the conserved "
                            "heat of the rod is undetermined; use a larger --h or less "
                            "--jitter",
                            k);
        for (size_t i = first; i < k; i++) {
            double *row = &rate[i * width + band - i];
            row[k] /= away;
            for (size_t j = first; j < k; j++) row[j] += row[k] * from[j];
        }
    }
    l[0] = sum = 1;
    for (size_t k = 1; k < n; k++) {
        l[k] = 0;
        for (size_t i = k > band ? k - band : 0; i < k; i++) l[k] += l[i] * rate[i * width + k + band - i];
        sum += l[k];
    }
    for (size_t k = 0; k < n; k++) l[k] *= all / sum;
    free(rate);
    return status;
}

/* The same particles between insulated ends. */
static int insulate(const struct problem *p, const struct options *o, const struct scheme *s, const struct field *f,
                    struct heat_operator *a, struct failure *why) {
    struct problem q = *p;
    struct options there = *o;
    struct lattice l;
    struct cloud c;
    q.source = NULL, q.wall = problem_held, q.held[X_LO] = q.held[X_HI] = 0;
    q.side[X_LO] = q.side[X_HI] = NEUMANN;
    there.placed = f;
    if (layout_lattice(&q, &there, &l, why)) return why->status;
    if (layout_cloud(&q, &there, &l, particles_reach(&there, s, &l), &c, why)) return why->status;
    int status = assembly_operator(a, &q, &there, s, &c, l.dx[0], why);
    layout_cloud_free(&c);
    return status;
}

int start_is_kept(const struct problem *p, const struct options *o, const struct scheme *s) {
    return s->keeps_start && p->materials == 2 && p->dim == 1 && o->sampling == SAMPLING_CELL;
}

static int keep_heat(const struct problem *p, const struct options *o, const struct scheme *s, struct field *f,
                     struct failure *why) {
    double beside = 1e-10 * (p->hi[0] - p->lo[0]), low[2] = {p->interface - beside, 0},
           high[2] = {p->interface + beside, 0};
    double jump = p->initial(p, high) - p->initial(p, low);
    struct heat_operator a;
    if (jump == 0) return STATUS_OK;
    if (insulate(p, o, s, f, &a, why)) return why->status;
    double *l = xcalloc(f->n, sizeof *l), support = KERNEL_SUPPORT * o->h * (p->hi[0] - p->lo[0]) / (double)f->n;
    double side[2] = {p->material[0].rho_c * (p->interface - p->lo[0]),
                      p->material[1].rho_c * (p->hi[0] - p->interface)};
    int status = start_kept(&a, side[0] + side[1], l, why);
    double excess = -side[1], near = 0; /* excess heat capacity of the second side; sum of l near the contact */
    for (size_t i = 0; i < f->n; i++) {
        if (layout_material(p, f->x[0][i]) == 1) excess += l[i];
        if (fabs(f->x[0][i] - p->interface) < support) near += l[i];
    }
    for (size_t i = 0; i < f->n && !status; i++) {
        double x[2] = {f->x[0][i], 0};
        if (fabs(x[0] - p->interface) < support) f->T[i] = p->initial(p, x) - jump * excess / near;
    }
    free(l);
    operator_free(&a);
    return status;
}

/* ---- All data ---- */

/* Min and max of T.  Eight independent accumulators hide the latency. */
static void set_range(const struct field *f, double range[2]) {
    enum { APART = 8 };
    double lo[APART], hi[APART];
    for (size_t k = 0; k < APART; k++) lo[k] = HUGE_VAL, hi[k] = -HUGE_VAL;
    size_t i = 0;
    for (; i + APART <= f->n; i += APART)
        for (size_t k = 0; k < APART; k++) {
            double T = f->T[i + k];
            lo[k] = T < lo[k] ? T : lo[k];
            hi[k] = T > hi[k] ? T : hi[k];
        }
    range[0] = HUGE_VAL, range[1] = -HUGE_VAL;
    for (; i < f->n; i++) range[0] = fmin(range[0], f->T[i]), range[1] = fmax(range[1], f->T[i]);
    for (size_t k = 0; k < APART; k++) range[0] = fmin(range[0], lo[k]), range[1] = fmax(range[1], hi[k]);
}

/* Averaged initial data stay in range; heat-conserving data may overshoot by a fraction of the jump.  The limit is
 * half of the range, as for a run. */
static int check_start(const struct field *f, struct failure *why) {
    double slack = (f->range[1] - f->range[0]) / 2 + 1e-9 * fmax(fabs(f->range[0]), fabs(f->range[1]));
    for (size_t i = 0; i < f->n; i++) {
        if (f->T[i] >= f->range[0] - slack && f->T[i] <= f->range[1] + slack) continue;
        double x[DIM_MAX];
        char place[PLACE_TEXT];
        return refuse(why, STATUS_NUMERICAL,
                      "the initial temperature of particle %zu at %s is %.4g K, the data are in [%.4g, %.4g] K; use "
                      "another --sampling, --h or layout",
                      i, problem_place(f->dim, field_place(f, i, x), place), f->T[i], f->range[0], f->range[1]);
    }
    return STATUS_OK;
}

/* Initial temperature of a particle off the lattice; on a Dirichlet wall the wall's temperature, which it keeps. */
static double start_at(const struct problem *p, const struct options *o, const struct lattice *l, const double x[2]) {
    double cell = layout_cell(o, l->dx[0]);
    if (layout_is_cut(p, o)) {
        int wall;
        struct foot f = shape_nearest(p, x, &wall);
        if (p->side[wall] == DIRICHLET && f.depth <= LAYOUT_ON_WALL * l->dx[0])
            return p->wall(p, (enum side)wall, f.x, 0);
    }
    return (cell > 0 ? sample_cell : sample_initial)(p, o->sampling, l->dx, x);
}

int start_averages_cells(const struct options *o, const struct scheme *s) {
    return s->cells && o->sampling == SAMPLING_CELL;
}

int start_set(const struct problem *p, const struct options *o, const struct scheme *s, const struct lattice *l,
              int rows, struct heat_operator *a, struct field *f, struct failure *why) {
    if (!rows) sample_lattice(p, o->sampling, l, f->T);
    if (options_is_matched(o) && !rows) matched_source(p, o, a, f->T);
    for (size_t i = 0; i < f->n && rows && !start_averages_cells(o, s); i++) {
        double x[DIM_MAX];
        f->T[i] = start_at(p, o, l, field_place(f, i, x));
    }
    set_range(f, f->range);
    if (start_is_kept(p, o, s) && keep_heat(p, o, s, f, why)) return why->status;
    return check_start(f, why);
}
