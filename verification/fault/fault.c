/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of faults: which problems can have each, and the change that it makes. */
#include "verification/fault/fault.h"

#include "references/kirchhoff.h"

#include <math.h>
#include <string.h>

/* ---- Places ---- */

static const struct fault_places
    axes = {DIM_MAX, (const char *const[]){"x", "y", "z"}, "an axis"},
    pairs = {3, (const char *const[]){"k_x and k_y", "k_y and k_z", "k_x and k_z"}, "two conductivities"},
    transposed_pairs = {3, (const char *const[]){"x and y", "y and z", "x and z"}, "two axes"},
    others = {6,
              (const char *const[]){"k_x were k_y", "k_y were k_x", "k_z were k_x", "k_x were k_z", "k_y were k_z",
                                    "k_z were k_y"},
              "one conductivity were another"},
    means = {1,
             (const char *const[]){"the arithmetic mean", "the geometric mean", "the arithmetic or geometric mean",
                                   "another mean"},
             "another mean"},
    across = {FAULT_ALL_AXES + 1,
              (const char *const[]){" across x", " across y", " across z", " across x and y", " across x, y and z"},
              ""},
    cooled_across = {FAULT_ALL_AXES + 1, (const char *const[]){" across x", " across y", " across z", "", ""}, ""},
    across_one = {DIM_MAX, (const char *const[]){" across x", " across y", " across z"}, ""},
    along = {FAULT_ALL_AXES + 1,
             (const char *const[]){" along x", " along y", " along z", " along x and y", " along x, y and z"}, ""},
    along_walls = {FAULT_ALL_AXES + 1, (const char *const[]){" along x", " along y", " along z", "", ""}, ""},
    sides = {FAULT_ALL_SIDES + 1,
             (const char *const[]){"side x_lo holds", "side x_hi holds", "side y_lo holds", "side y_hi holds",
                                   "side z_lo holds", "side z_hi holds", "sides of given flux hold"},
             "a side holds"},
    named_sides = {SIDES,
                   (const char *const[]){"side x_lo", "side x_hi", "side y_lo", "side y_hi", "side z_lo",
                                         "side z_hi"},
                   "a side"},
    leaks = {FAULT_ALL_SIDES + 1,
             (const char *const[]){"side x_lo", "side x_hi", "side y_lo", "side y_hi", "side z_lo", "side z_hi",
                                   "insulated sides, or those of given flux,"},
             "a side"},
    walls = {1 + SIDES,
             (const char *const[]){"the walls were those", "side x_lo were that", "side x_hi were that",
                                   "side y_lo were that", "side y_hi were that", "side z_lo were that",
                                   "side z_hi were that"},
             "the walls were those"},
    cooled = {FAULT_ALL_SIDES + 1,
              (const char *const[]){" of side x_lo", " of side x_hi", " of side y_lo", " of side y_hi",
                                    " of side z_lo", " of side z_hi", "s"},
              "s"},
    corners = {29,
               (const char *const[]){"the corner x_lo, y_lo",
                                     "the corner x_hi, y_lo",
                                     "the corner x_lo, y_hi",
                                     "the corner x_hi, y_hi",
                                     "the corner x_lo, y_lo, z_lo",
                                     "the corner x_hi, y_lo, z_lo",
                                     "the corner x_lo, y_hi, z_lo",
                                     "the corner x_hi, y_hi, z_lo",
                                     "the corner x_lo, y_lo, z_hi",
                                     "the corner x_hi, y_lo, z_hi",
                                     "the corner x_lo, y_hi, z_hi",
                                     "the corner x_hi, y_hi, z_hi",
                                     "the edge y_lo, z_lo",
                                     "the edge y_hi, z_lo",
                                     "the edge y_lo, z_hi",
                                     "the edge y_hi, z_hi",
                                     "the edge x_lo, z_lo",
                                     "the edge x_hi, z_lo",
                                     "the edge x_lo, z_hi",
                                     "the edge x_hi, z_hi",
                                     "the edge x_lo, y_lo",
                                     "the edge x_hi, y_lo",
                                     "the edge x_lo, y_hi",
                                     "the edge x_hi, y_hi",
                                     "the edges along x",
                                     "the edges along y",
                                     "the edges along z",
                                     "all corners",
                                     "all edges"},
               "corners or edges"},
    beside_corners = {BESIDE_ALL + 2,
                      (const char *const[]){"the corner x_lo, y_lo", "the corner x_hi, y_lo", "the corner x_lo, y_hi",
                                            "the corner x_hi, y_hi", "corners, on the sides across x,",
                                            "corners, on the sides across y,"},
                      "corners"},
    laws = {LAWS,
            (const char *const[]){"were that of the initial temperature", "were that of the reference temperature",
                                  "were that of side x_lo", "were that of side x_hi", "were that of side y_lo",
                                  "were that of side y_hi",
                                  "had harmonic or geometric means, which let no heat into a cell with k = 0"},
            "were that of another temperature"},
    crosses = {2 + DIM_MAX,
               (const char *const[]){"k_xy were taken for 0", "k_xy had the wrong sign",
                                     "k_xy, of three, were taken for 0", "k_xz, of three, were taken for 0",
                                     "k_yz, of three, were taken for 0"},
               "k_xy were another"},
    ends = {2,
            (const char *const[]){"late, after the first whole step past t_end",
                                  "early, after the last whole step before t_end"},
            "after whole steps"},
    fields = {FIELDS,
              (const char *const[]){"b were turned by 90 degrees, or k_par and k_perp in each other's place",
                                    "k_perp were lost", "heat were conducted by k_par in all directions",
                                    "K were that of another place, with x and y exchanged"},
              "the field were another"},
    fronts = {AT_FRONT_LOOSE + 1,
              (const char *const[]){"the latent heat were lost", "the front stayed in its first cell",
                                    "no heat passed a cell at the melting point, as with a harmonic mean of k",
                                    "a cell were not held at the melting point while it melts"},
              "the front were another"},
    ranges = {3,
              (const char *const[]){" above the melting point", " about the melting point",
                                    " below the melting point"},
              ""},
    phase_parts = {4,
                   (const char *const[]){"k of the solid", "k of the liquid", "rho c of the solid",
                                         "rho c of the liquid"},
                   "k or rho c of a phase"},
    phases_of = {PHASES_BOTH + 1,
                 (const char *const[]){
                     "k of solid and liquid were in each other's place", "k of the liquid were that of the solid",
                     "k of the solid were that of the liquid", "rho c of solid and liquid were in each other's place",
                     "rho c of the liquid were that of the solid", "rho c of the solid were that of the liquid",
                     "solid and liquid were in each other's place"},
                 "k or rho c were of the other phase"},
    lost = {2, (const char *const[]){"lost: taken for 1", "in units of that of the first material"},
            "lost: taken for 1, or in units of the first material"},
    cuts = {2, (const char *const[]){"below a lowest value", "above a highest value"}, "outside a range"},
    materials = {MATERIAL_MAX, (const char *const[]){"first", "second"}, "a"};

/* An axis: one, both of a plane or all of a box. */
static int is_axis(const struct problem *p, int at) {
    return at < p->dim || (p->dim > 1 && at == (p->dim == 2 ? FAULT_BOTH_AXES : FAULT_ALL_AXES));
}

static int includes(int at, int a) {
    return at == a || at >= FAULT_BOTH_AXES;
}

/* The two axes of a pair, 0 of a plane, 0 to 2 of a box: x and y, y and z, x and z. */
static int first_of(int pair) {
    return pair == 1 ? 1 : 0;
}

static int second_of(int pair) {
    return pair == 0 ? 1 : 2;
}

/* FAULT_ISOTROPIC: the axis, 0 or 1 in a plane, 0 to 5 in a box, and the one with the k that it takes. */
static int taker(int at) {
    return at % 3;
}

static int giver(int at) {
    static const int of[] = {1, 0, 0, 2, 2, 1};
    return of[at];
}

/* ---- Which problems can have it ---- */

static int has_pair(const struct problem *p, int pair) {
    return p->dim > 1 && pair < p->dim * (p->dim - 1) / 2;
}

static int differ_in_pair(const struct problem *p, int at) {
    const double *k = p->material[0].k;
    return has_pair(p, at) && k[first_of(at)] != k[second_of(at)];
}

static int differ_in_other(const struct problem *p, int at) {
    const double *k = p->material[0].k;
    return at < p->dim * (p->dim - 1) && k[taker(at)] != k[giver(at)];
}

static int equal_in_pair(const struct problem *p, int at) {
    int a = first_of(at), b = second_of(at);
    return has_pair(p, at) && !p->direction && p->lo[a] == p->lo[b] && p->hi[a] == p->hi[b];
}

static int has_cross(const struct problem *p, int at) {
    return at < 2 ? problem_has_cross(p) && !(p->direction && p->k_par == p->k_perp)
                  : p->dim == 3 && p->cross[at - 2] != 0;
}

static int has_source(const struct problem *p, int at) {
    (void)at;
    return p->source || p->source_at;
}

static int has_changing_source(const struct problem *p, int at) {
    (void)at;
    return p->source_rate || p->source_at;
}

static int has_interface(const struct problem *p, int at) {
    (void)at;
    return p->materials == 2;
}

static int has_other_axis(const struct problem *p, int at) {
    return has_interface(p, at) && at > 0 && at < p->dim;
}

static int is_perfect(const struct problem *p, int at) {
    return has_interface(p, at) && p->resistance == 0;
}

static int has_resistance(const struct problem *p, int at) {
    (void)at;
    return p->resistance > 0;
}

static int has_capacities(const struct problem *p, int at) {
    (void)at;
    return p->materials == 2 && p->material[0].rho_c != p->material[1].rho_c;
}

static int has_material(const struct problem *p, int at) {
    (void)at;
    return p->materials == 2;
}

static int has_axis(const struct problem *p, int at) {
    return at < p->dim;
}

static int has_axis_of_its_own(const struct problem *p, int at) {
    return p->dim > 1 && at < p->dim && !p->k_law && !p->direction; /* k would differ by axis */
}

static int has_extent(const struct problem *p, int at) {
    return is_axis(p, at) && !(p->k_law && p->dim > 1) && !p->direction;
}

/* Whether a held side is opposite to a cooled one: of two held sides FAULT_EXTENT is the displacement. */
static int is_held_alone(const struct problem *p, int a) {
    int hi = p->side[2 * a] == ROBIN;
    return a < p->dim && p->side[2 * a + hi] == DIRICHLET && p->side[2 * a + !hi] == ROBIN;
}

static int has_held_alone(const struct problem *p, int at) {
    (void)at;
    for (int a = 0; a < p->dim; a++)
        if (is_held_alone(p, a)) return has_extent(p, a);
    return 0;
}

static int has_jumps(const struct problem *p, int at) {
    return at < p->dim && p->jumps[at] >= 2;
}

static int has_side(const struct problem *p, int s) {
    return s < 2 * p->dim && p->side[s] != PERIODIC;
}

static int is_open(const struct problem *p, int s) {
    return s < 2 * p->dim && (p->side[s] == DIRICHLET || p->side[s] == ROBIN);
}

static int has_cross_insulated(const struct problem *p, int at) {
    int insulated = 0;
    for (int s = 0; s < 2 * p->dim; s++) insulated += p->side[s] == NEUMANN;
    return at == 0 && insulated > 0 && problem_has_cross(p);
}

static int can_leak(const struct problem *p, int at) {
    int given = 0;
    for (int s = 0; s < 2 * p->dim; s++) given += p->side[s] == NEUMANN && (at == s || at == FAULT_ALL_SIDES);
    return !p->k_law && given > (at == FAULT_ALL_SIDES);
}

/* A point of side s, at the same part of the extent of the other axes. */
static void put_on_side(const struct problem *p, int s, double part, double x[DIM_MAX]) {
    for (int a = 0; a < DIM_MAX; a++) x[a] = p->lo[a] + part * (p->hi[a] - p->lo[a]);
    x[s / 2] = s % 2 ? p->hi[s / 2] : p->lo[s / 2];
}

static int has_value(const struct problem *p, int s) {
    for (int i = 0; i <= 8; i++) {
        double x[DIM_MAX];
        put_on_side(p, s, 0.03 + 0.117 * i, x);
        if (p->side[s] != PERIODIC && p->wall(p, (enum side)s, x, 0) != 0) return 1;
    }
    return 0;
}

static int has_wall_data(const struct problem *p, int at) {
    int fluxes = 0;
    if (at != FAULT_ALL_SIDES) return at < 2 * p->dim && has_value(p, at);
    for (int s = 0; s < 2 * p->dim; s++) fluxes += p->side[s] == NEUMANN && has_value(p, s);
    return fluxes >= 2;
}

/* Whether what some side holds varies along that axis, or along any. */
static int has_axis_of_walls(const struct problem *p, int at) {
    if (p->dim == 1 || !is_axis(p, at)) return 0;
    for (int s = 0; s < 2 * p->dim; s++) {
        double x[DIM_MAX];
        put_on_side(p, s, 0.31, x);
        if (at == s / 2 || p->side[s] == PERIODIC) continue;
        double here = p->wall(p, (enum side)s, x, 0);
        for (int a = 0; a < p->dim; a++)
            if (includes(at, a) && a != s / 2) x[a] += 0.1 * (p->hi[a] - p->lo[a]);
        if (p->wall(p, (enum side)s, x, 0) != here) return 1;
    }
    return 0;
}

static int has_loads(const struct problem *p, int at) {
    int fluxes = 0;
    for (int s = 0; s < 2 * p->dim; s++) fluxes += p->side[s] == NEUMANN && has_value(p, s);
    return has_source(p, at) && fluxes;
}

static int is_cooled(const struct problem *p, int s) {
    return s < 2 * p->dim && p->side[s] == ROBIN && p->robin[s] > 0;
}

static int cooled_sides(const struct problem *p) {
    int n = 0;
    for (int s = 0; s < 2 * p->dim; s++) n += is_cooled(p, s);
    return n;
}

static int has_cooled(const struct problem *p, int at) {
    (void)at;
    return cooled_sides(p) > 0;
}

/* A cooled side across that axis, or, for all axes, across two of them. */
static int has_cooled_across(const struct problem *p, int at) {
    int n = 0;
    for (int a = 0; a < p->dim; a++) n += includes(at, a) && (is_cooled(p, 2 * a) || is_cooled(p, 2 * a + 1));
    return at == FAULT_BOTH_AXES ? 0 : n > (at == FAULT_ALL_AXES);
}

static int has_coefficient(const struct problem *p, int at) {
    return at == FAULT_ALL_SIDES ? cooled_sides(p) >= 2 : is_cooled(p, at);
}

static int has_air(const struct problem *p, int at) {
    (void)at;
    for (int s = 0; s < 2 * p->dim; s++)
        if (is_cooled(p, s) && has_value(p, s)) return 1;
    return 0;
}

int fault_is_pace(const struct problem *p) {
    for (int s = 0; s < 2 * p->dim; s++)
        if (p->side[s] == ROBIN || (p->side[s] == NEUMANN && has_value(p, s))) return 0;
    return !p->source && !p->source_at && !p->wall_rate;
}

/* Whether there are two materials without sources, so that the fluxes determine the solution. */
static int has_diffusivities(const struct problem *p, int at) {
    return is_perfect(p, at) && has_capacities(p, at) && fault_is_pace(p);
}

static int has_corner(const struct problem *p, int place) {
    int held = 0;
    if (p->dim == 1 || (p->dim == 2) != (faulty_corner(place, 0) < 4) || p->shape || p->k_law) return 0;
    for (int i = 0; faulty_corner(place, i) >= 0; i++)
        for (int a = 0; a < p->dim; a++) {
            int s = faulty_side(faulty_corner(place, i), a);
            held = held || (s >= 0 && is_open(p, s) && has_value(p, s));
        }
    return held;
}

/* Whether a side there, held or cooled, conducts heat. */
static int has_beside(const struct problem *p, int place) {
    int open = 0;
    if (p->dim != 2 || p->shape || p->k_law || p->direction || p->materials == 2) return 0;
    for (int s = 0; s < 4; s++) {
        const int at_corner = place < BESIDE_ALL && (place >> s / 2 & 1) == s % 2;
        open = open || ((at_corner || s / 2 == place - BESIDE_ALL) && is_open(p, s));
    }
    return open;
}

static int has_changing_walls(const struct problem *p, int at) {
    (void)at;
    return p->wall_rate != NULL;
}

/* Walls that change, or that side if it changes, and another one too. */
static int has_changing_wall(const struct problem *p, int at) {
    int changing = 0, this_one = 0;
    for (int s = 0; p->wall_rate && s < 2 * p->dim; s++) {
        double x[DIM_MAX];
        put_on_side(p, s, 0.37, x);
        int changes = p->wall_rate(p, (enum side)s, x, 0.31 * p->t_end) != 0;
        changing += changes;
        this_one = this_one || (changes && s == at - 1);
    }
    return at == 0 ? p->wall_rate != NULL : this_one && changing > 1;
}

static int is_periodic(const struct problem *p, int axis) {
    return axis < p->dim && p->side[2 * axis] == PERIODIC;
}

static int are_periodic(const struct problem *p, int at) {
    for (int a = 0; a < p->dim; a++)
        if (includes(at, a) && !is_periodic(p, a)) return 0;
    return is_axis(p, at) && !problem_has_cross(p); /* response.c has no steps of a tensor */
}

/* Whether the walls across an axis, or the initial data, are not even about its middle. */
static int is_lopsided(const struct problem *p, int axis) {
    return axis < p->dim && !p->mirror[axis];
}

/* k in the middle of a side. */
static double law_at_side(const struct problem *p, int s) {
    double x[DIM_MAX];
    put_on_side(p, s, 0.5, x);
    return kirchhoff_k(p, p->wall(p, (enum side)s, x, 0));
}

static int has_any_law(const struct problem *p, int at) {
    (void)at;
    return p->k_law != K_CONSTANT && p->k_law != K_PHASES;
}

static int has_phases(const struct problem *p, int at) {
    const double *k = p->phase_k, *rho_c = p->phase_rho_c;
    const int of_k = at < PHASES_RHO_C || at == PHASES_BOTH, of_rho_c = at >= PHASES_RHO_C;
    return p->k_law == K_PHASES && (!of_k || k[0] != k[1]) && (!of_rho_c || rho_c[0] != rho_c[1]);
}

static int has_latent(const struct problem *p, int at) {
    (void)at;
    return p->k_law == K_PHASES;
}

/* With SI units of a metal a run with rho c = 1 has 1e6 times the steps, and a faulty code no answer. */
static int can_lose_capacity(const struct problem *p, int at) {
    static const double FAR = 20;
    int differ = 0;
    if (p->k_law == K_PHASES || (at == 1 && p->materials < 2)) return 0;
    for (int m = 0; m < p->materials; m++) {
        const double rho_c = p->material[m].rho_c;
        if (!(rho_c > 1 / FAR && rho_c < FAR)) return 0;
        differ = differ || rho_c != 1;
    }
    return differ;
}

static int has_no_phases(const struct problem *p, int at) {
    (void)at;
    return p->k_law != K_PHASES;
}

static int has_law(const struct problem *p, int at) {
    int s = at - LAW_SIDE;
    if (!has_any_law(p, at)) return 0;
    if (at == LAW_REF) return p->k_law == K_LINEAR;
    if (at == LAW_START) return p->source_at || p->wall_rate; /* else the start may be steady */
    if (at == LAW_HARMONIC) return 1;
    return s < 2 * p->dim && p->side[s] == DIRICHLET && law_at_side(p, s) > 0;
}

/* ---- Changes ---- */

static void clock(struct faulty *f) {
    f->problem.t_end += f->size;
}

static void conductivity(struct faulty *f) {
    struct problem *q = &f->problem;
    for (int m = 0; m < q->materials; m++)
        for (int a = 0; a < q->dim; a++) q->material[m].k[a] *= 1 + f->size;
    for (int k = 0; k < DIM_MAX; k++) q->cross[k] *= 1 + f->size;
    q->k_par *= 1 + f->size, q->k_perp *= 1 + f->size;
    q->k_0 *= 1 + f->size;
    for (int m = 0; m < 2; m++) q->phase_k[m] *= 1 + f->size;
}

static void heat_capacity(struct faulty *f) {
    for (int m = 0; m < f->problem.materials; m++) f->problem.material[m].rho_c *= 1 + f->size;
}

static void capacity_lost(struct faulty *f) {
    const double first = f->right->material[0].rho_c;
    for (int m = 0; m < f->problem.materials; m++)
        f->problem.material[m].rho_c = f->fault.at == 0 ? 1 : f->right->material[m].rho_c / first;
}

static void axis(struct faulty *f) {
    for (int m = 0; m < f->problem.materials; m++) f->problem.material[m].k[f->fault.at] *= 1 + f->size;
}

static void cross(struct faulty *f) {
    if (f->fault.at == 0) f->problem.is_diagonal = 1;
    if (f->fault.at == 1) f->opposite = 1;
    for (int k = 0; k < DIM_MAX; k++)
        if (f->fault.at < 2 || f->fault.at - 2 == k) f->problem.cross[k] *= f->fault.at == 1 ? -1 : 0;
}

static void normal(struct faulty *f) {
    f->problem.is_even = 1;
}

static int has_field(const struct problem *p, int at) {
    return p->direction && p->k_par != p->k_perp && (at != FIELD_LOST || p->k_perp > 0);
}

/* In the plane K with the two exchanged is that of b turned by 90 degrees. */
static void field(struct faulty *f) {
    struct problem *q = &f->problem;
    const double par = f->right->k_par;
    if (f->fault.at == FIELD_TURNED) q->k_par = q->k_perp, q->k_perp = par;
    if (f->fault.at == FIELD_LOST) q->k_perp = 0;
    if (f->fault.at == FIELD_ALL) q->k_perp = par;
    f->swapped = f->fault.at == FIELD_SWAPPED;
}

static void turn(struct faulty *f) {
    f->turn = f->size * M_PI / 2;
}

static void k_par(struct faulty *f) {
    f->problem.k_par *= 1 + f->size;
}

static void swap(struct faulty *f) {
    double *k = f->problem.material[0].k;
    const double *right = f->right->material[0].k;
    int a = first_of(f->fault.at), b = second_of(f->fault.at);
    k[a] = right[b], k[b] = right[a];
}

static void isotropic(struct faulty *f) {
    f->problem.material[0].k[taker(f->fault.at)] = f->right->material[0].k[giver(f->fault.at)];
}

static void transposed(struct faulty *f) {
    struct problem *q = &f->problem;
    const struct problem *p = f->right;
    int one = first_of(f->fault.at), two = second_of(f->fault.at);
    f->from[one] = two, f->from[two] = one;
    for (int a = 0; a < p->dim; a++) {
        q->material[0].k[a] = p->material[0].k[f->from[a]];
        for (int b = 0; b < a; b++) q->cross[problem_pair(b, a)] = p->cross[problem_pair(f->from[b], f->from[a])];
        q->jumps[a] = p->jumps[f->from[a]];
        memcpy(q->jump[a], p->jump[f->from[a]], sizeof q->jump[a]);
    }
    for (int s = 0; s < 2 * p->dim; s++) {
        enum side from = faulty_from(f, s);
        q->side[s] = p->side[from], q->robin[s] = p->robin[from];
    }
}

static void source(struct faulty *f) {
    f->source = 1 + f->size;
}

static void source_time(struct faulty *f) {
    f->source_late = f->size;
}

static void source_frozen(struct faulty *f) {
    f->source_frozen = 1;
}

static void capacity(struct faulty *f) {
    f->problem.material[1].rho_c = f->problem.material[0].rho_c;
}

static void rho_c(struct faulty *f) {
    f->problem.material[f->fault.at].rho_c *= 1 + f->size;
}

/* With rho c of its own side, a flux between diffusivities is one between conductivities k/rho c. */
static void diffusivity(struct faulty *f) {
    for (int m = 0; m < f->problem.materials; m++) {
        struct material *material = &f->problem.material[m];
        for (int a = 0; a < f->problem.dim; a++) material->k[a] /= material->rho_c;
        material->rho_c = 1;
    }
}

static void interface(struct faulty *f) {
    f->problem.interface += f->size;
}

static void turned(struct faulty *f) {
    f->across = f->fault.at, f->by_steps = 1;
}

static void perfect(struct faulty *f) {
    f->problem.resistance = 0;
}

static void resistance(struct faulty *f) {
    f->problem.resistance *= fmax(0, 1 + f->size);
}

static void mean(struct faulty *f) {
    f->mean = MEAN_ARITHMETIC;
}

/* k(T) is that of the right temperature. */
static void amplitude(struct faulty *f) {
    f->factor = 1 + f->size;
    f->problem.k_ref *= f->factor;
    f->problem.latent *= f->factor;
    f->problem.k_beta /= f->factor;
    if (f->right->k_law == K_POWER) f->problem.k_0 /= pow(f->factor, f->right->k_n);
}

static void offset(struct faulty *f) {
    f->offset = f->size;
    f->problem.k_ref += f->size;
}

static void near_wall(struct faulty *f) {
    for (int s = 0; s < 2 * f->problem.dim; s++) {
        const struct material *beside = &f->problem.material[s == X_HI ? f->problem.materials - 1 : 0];
        const double half = includes(f->fault.at, s / 2) ? f->size / beside->k[s / 2] : 0;
        f->problem.robin[s] /= fmax(0.01, 1 - half * f->problem.robin[s]);
    }
}

static void air_sign(struct faulty *f) {
    f->by_steps = 1; /* the solver refuses a wall that heats itself */
    for (int s = 0; s < SIDES; s++) f->problem.robin[s] *= -1;
}

static void coefficient(struct faulty *f) {
    for (int s = 0; s < SIDES; s++)
        if (f->fault.at == s || f->fault.at == FAULT_ALL_SIDES) f->problem.robin[s] *= 1 + f->size;
}

/* The extent along an axis grows by `more` about its centre. */
static void stretch(struct faulty *f, int a, double more) {
    struct problem *q = &f->problem;
    double s = 1 + more / (q->hi[a] - q->lo[a]);
    f->stretch[a] = s;
    for (int m = 0; m < q->materials; m++) q->material[m].k[a] /= s * s;
    for (int b = 0; b < DIM_MAX; b++)
        if (b != a) q->cross[problem_pair(a, b)] /= s;
    q->k_0 /= s * s;
    for (int m = 0; m < 2; m++) q->phase_k[m] /= s * s;
    for (int hi = 0; hi < 2; hi++) q->robin[2 * a + hi] /= s;
    for (int k = 0; k < q->jumps[a]; k++) q->jump[a][k] = f->centre[a] + (q->jump[a][k] - f->centre[a]) / s;
    if (a == 0) q->resistance *= s;
    if (a == 0) q->interface = f->centre[0] + (q->interface - f->centre[0]) / s;
}

static void extent(struct faulty *f) {
    for (int a = 0; a < f->problem.dim; a++)
        if (includes(f->fault.at, a)) stretch(f, a, 2 * f->size);
}

static void held(struct faulty *f) {
    const struct problem *p = f->right;
    for (int a = 0; a < p->dim; a++) {
        if (!is_held_alone(p, a)) continue;
        f->centre[a] = p->side[2 * a] == ROBIN ? p->lo[a] : p->hi[a]; /* the cooled side stays */
        stretch(f, a, f->size);
    }
}

static void points(struct faulty *f) {
    for (int a = 0; a < f->problem.dim; a++)
        if (includes(f->fault.at, a)) f->moved[a] = f->size;
}

static void mirrored(struct faulty *f) {
    f->mirrored[f->fault.at] = 1;
}

static void start_size(struct faulty *f) {
    f->initial = 1 + f->size;
}

static void start_shift(struct faulty *f) {
    int a = f->fault.at;
    f->start[a] = f->size;
    for (int k = 0; k < f->problem.jumps[a]; k++) f->problem.jump[a][k] += f->size;
}

static void start_width(struct faulty *f) {
    int a = f->fault.at, n = f->problem.jumps[a];
    f->width[a] = f->size;
    for (int k = 0; k < n; k++) f->problem.jump[a][k] += 2 * k < n ? -f->size : f->size;
}

static void wall(struct faulty *f) {
    for (int s = 0; s < 2 * f->problem.dim; s++)
        if (f->fault.at == s || (f->fault.at == FAULT_ALL_SIDES && f->right->side[s] == NEUMANN))
            f->wall[s] = 1 + f->size;
}

static void air(struct faulty *f) {
    for (int s = 0; s < 2 * f->problem.dim; s++)
        if (f->right->side[s] == ROBIN) f->wall[s] = 1 + f->size;
}

static void loads(struct faulty *f) {
    f->source = 0;
    for (int s = 0; s < 2 * f->problem.dim; s++)
        if (f->right->side[s] == NEUMANN) f->wall[s] = 0;
}

static void insulated(struct faulty *f) {
    f->problem.side[f->fault.at] = NEUMANN;
    f->wall[f->fault.at] = 0;
}

/* A loss b T, b in units of k over the extent. */
static void leak(struct faulty *f) {
    struct problem *q = &f->problem;
    for (int s = 0; s < 2 * q->dim; s++) {
        const struct material *beside = &q->material[s == X_HI ? q->materials - 1 : 0];
        if (f->right->side[s] != NEUMANN || (f->fault.at != s && f->fault.at != FAULT_ALL_SIDES)) continue;
        q->side[s] = ROBIN;
        q->robin[s] = f->size * beside->k[s / 2] / (q->hi[s / 2] - q->lo[s / 2]);
    }
}

static void kept(struct faulty *f) {
    f->problem.side[f->fault.at] = DIRICHLET;
    f->kept = f->fault.at;
}

static void along_wall(struct faulty *f) {
    for (int a = 0; a < f->problem.dim; a++)
        if (includes(f->fault.at, a)) f->along[a] = -f->size;
}

static void corner(struct faulty *f) {
    f->corner = f->fault.at;
}

static void beside_corner(struct faulty *f) {
    f->left_out = f->fault.at, f->by_steps = 1;
}

static void wall_time(struct faulty *f) {
    for (int s = 0; s < SIDES; s++)
        if (f->fault.at == 0 || f->fault.at == 1 + s) f->late[s] = f->size;
}

static void wall_frozen(struct faulty *f) {
    f->frozen = 1;
}

static void not_periodic(struct faulty *f) {
    for (int s = 2 * f->fault.at; s < 2 * f->fault.at + 2; s++) f->problem.side[s] = NEUMANN, f->wall[s] = 0;
}

static void twice(struct faulty *f) {
    f->by_steps = 1;
    for (int a = 0; a < f->problem.dim; a++) f->twice[a] = includes(f->fault.at, a);
}

static void laplacian(struct faulty *f) {
    f->laplacian = f->by_steps = 1;
}

static void law(struct faulty *f) {
    struct problem *q = &f->problem;
    int at = f->fault.at, is_single = at == LAW_REF || (at >= LAW_SIDE && at < LAW_HARMONIC);
    double single = at == LAW_REF ? q->k_0 : is_single ? law_at_side(f->right, at - LAW_SIDE) : 0;
    q->k_frozen = at == LAW_START;
    if (at == LAW_HARMONIC) f->mean = MEAN_HARMONIC;
    if (is_single) q->k_law = K_LINEAR, q->k_0 = single, q->k_beta = 0;
}

static void phases(struct faulty *f) {
    const struct problem *p = f->right;
    const int at = f->fault.at, of_k = at < PHASES_RHO_C || at == PHASES_BOTH, of_rho_c = at >= PHASES_RHO_C;
    for (int m = 0; m < 2; m++) {
        const int from = at % PHASES_RHO_C == PHASES_SWAPPED ? 1 - m : at % PHASES_RHO_C == PHASES_LIQUID;
        if (of_k) f->problem.phase_k[m] = p->phase_k[from];
        if (of_rho_c) f->problem.phase_rho_c[m] = p->phase_rho_c[from];
    }
}

static void phase_part(struct faulty *f) {
    struct problem *q = &f->problem;
    *(f->fault.at < 2 ? &q->phase_k[f->fault.at] : &q->phase_rho_c[f->fault.at - 2]) *= 1 + f->size;
}

static void latent(struct faulty *f) {
    f->problem.latent *= fmax(0, 1 + f->size);
}

static void front(struct faulty *f) {
    if (f->fault.at == AT_FRONT_LOST) f->problem.latent = 0;
    if (f->fault.at == AT_FRONT_KEPT) f->problem.latent *= 1e6;
    if (f->fault.at == AT_FRONT_LOCKED) f->front = FRONT_LOCKED;
    if (f->fault.at == AT_FRONT_LOOSE) f->front = FRONT_LOOSE;
}

static void melting_range(struct faulty *f) {
    f->range[0] = f->fault.at > 0 ? f->size / (f->fault.at == 1 ? 2 : 1) : 0;
    f->range[1] = f->size - f->range[0];
}

static void melting_point(struct faulty *f) {
    f->problem.k_ref += f->size;
}

const struct fault_row fault_rows[FAULT_KINDS] = {
#define FAULT(NAME, ...) [FAULT_##NAME] = {.name = #NAME, __VA_ARGS__},
#include "verification/fault/fault.def"
#undef FAULT
};

/* ---- Rows ---- */

int fault_places(enum fault_kind kind) {
    const struct fault_places *places = fault_rows[kind].places;
    return places ? places->count : 1;
}

int fault_applies(const struct problem *p, struct fault fault) {
    const struct fault_row *row = &fault_rows[fault.kind];
    return row->change && fault.at >= 0 && fault.at < fault_places(fault.kind) &&
           (!row->applies || row->applies(p, fault.at));
}

double fault_scale(const struct problem *p, struct fault fault) {
    const int a = fault.at < p->dim ? fault.at : 0;
    const enum fault_unit unit = fault_rows[fault.kind].unit;
    if (unit == UNIT_TIME) return p->t_end;
    if (p->k_law == K_PHASES && unit == UNIT_KELVIN)
        return fabs(p->wall(p, X_HI, p->hi, 0) - p->wall(p, X_LO, p->lo, 0));
    return unit == UNIT_LENGTH || fault.kind == FAULT_SAMPLES ? p->hi[a] - p->lo[a] : 1;
}

double fault_whole(const struct problem *p, struct fault fault) {
    return fault.kind == FAULT_CLOCK || fault.kind == FAULT_RANGE ? fault_scale(p, fault) : 1;
}

double fault_probe(const struct problem *p, struct fault fault) {
    const struct fault_row *row = &fault_rows[fault.kind];
    if (row->probe > 0) return row->probe * fault_scale(p, fault);
    if (p->k_law == K_PHASES && row->unit != UNIT_WHOLE)
        return 0.05 * fault_scale(p, fault); /* many cells of a front */
    return row->unit == UNIT_WHOLE ? 1 : fault_scale(p, fault) * (row->unit == UNIT_LENGTH ? 0.005 : 0.01);
}

int fault_can_be(const struct problem *p, struct fault fault, double size) {
    static const double SIGN = 0.1; /* largest distance from -2 that counts as a wrong sign */
    static const double FAR = 0.25; /* times the extent: beyond, responses are not proportional */
    const struct fault_row *row = &fault_rows[fault.kind];
    if (row->unit == UNIT_LENGTH && fabs(size) > FAR * fault_scale(p, fault)) return 0;
    if (row->least == 0 || size > row->least * fault_scale(p, fault)) return 1;
    return (row->is & FAULT_SIGN) && fabs(size + 2) < SIGN;
}

unsigned fault_sides(const struct problem *p, struct fault fault) {
    unsigned kinds = 0;
    for (int s = 0; s < 2 * p->dim; s++) {
        int across_it = fault.kind == FAULT_EXTENT && includes(fault.at, s / 2);
        int held =
            fault.kind == FAULT_WALL && (s == fault.at || (fault.at == FAULT_ALL_SIDES && p->side[s] == NEUMANN));
        if (across_it || held) kinds |= 1u << p->side[s];
    }
    return kinds;
}
