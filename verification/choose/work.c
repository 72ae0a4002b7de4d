/* The work of setting up, in the pairs that steps are counted in.
 *
 * A step streams: a vector of LANES doubles (512 bits) does as many pairs at once.  Setting up multiplies and adds
 * one number at a time, and each of these takes the place of LANES pairs.  How many there are follows from the code:
 *
 *     a function    FUNCTION: exp, cos, sqrt: a polynomial of degree 13 or so, and its argument reduced
 *     a particle    PLACE: its place, its start, heat, range and the unfolding: five passes of some four
 *     a sample      POINT: four comparisons on each of four sides, and the data, a function
 *     a wall        a FUNCTION at each place along it; where any wall or source has something to add, also GHOST for
 *                   each ghost: reflected, with the value of a wall, and handed to who reaches it
 *     a weight      kernel and distance, a FUNCTION.  With t Taylor terms (SSPH) also monomials twice, 4 t, the
 *                   matrix, t (t + 1), and the sum, t; then t^3/6 for the factor and t^2 for each of t + 1
 *                   substitutions, t of them for the condition number
 *     a row         four for each point of the 3^d cells around, for each comparison that sorts its columns, and for
 *                   each pair of the first derivatives that are composed (two sweeps)
 *     --h iso       a stencil at each 1/16 of h/dx to either side of 1.2 until a root is passed, seven to polish it
 *     a transform   along an axis 1.25 log2 n for each particle, and for its plans FFTW looks at SOLVERS, TRIED
 *                   each, at log2 n levels (where few modes survive, less is done)
 *     modes         exp(lambda t), and expm1 where walls or a source add; along an axis reach + 1 cosines
 *
 * In the steps each ghost is REFRESHED alone, by a load and a store, where particles go by the vector.
 *
 * No clock has a part in it.  Allocation and traffic through memory are left out. */
#include "verification/choose/work.h"

#include "solver/space/operator.h"
#include "solver/space/sample.h"
#include "verification/run/symmetry.h"
#include "verification/run/result.h"

#include <math.h>
#include <stdlib.h>

enum {
    LANES = 8,
    FUNCTION = 20,
    PLACE = 20,
    POINT = 16 + FUNCTION,
    GHOST = 2 * POINT,
    REFRESHED = 2,
    SOLVERS = 200,
    TRIED = 8
};

/* What is computed of a run: the part that symmetry leaves. */
struct extent {
    struct problem part;
    double n; /* particles */
    int along[2];
};

static struct extent extent_of(const struct problem *p, const struct result *r) {
    const struct options *o = &r->options;
    struct extent e = {.n = (double)r->updates};
    int cut[2];
    double ratio = o->stepper == STEPPER_MATCHED ? sqrt(p->material[0].k[1] / p->material[0].k[0]) : 1;
    if (r->steps > 0) e.n /= (double)r->steps * (r->stages > 0 ? r->stages : 1);
    if (!(e.n < (double)r->particles && symmetry_reduce(p, o, &e.part, cut))) e.part = *p;
    for (int a = 0; a < 2; a++)
        e.along[a] = a < p->dim ? (int)lround((e.part.hi[a] - e.part.lo[a]) / (a ? o->dx * ratio : o->dx)) : 1;
    return e;
}

static struct lattice lattice_of(const struct extent *e) {
    struct lattice l = {.dim = e->part.dim, .n = {e->along[0], e->along[1]}, .dx = {1, 1}};
    for (int a = 0; a < e->part.dim; a++) {
        l.dx[a] = (e->part.hi[a] - e->part.lo[a]) / l.n[a];
        l.first[a] = e->part.lo[a] + l.dx[a] / 2;
    }
    return l;
}

/* Nodes of the averages of all particles along an axis.  Particles share theirs: few where the data are smooth, and
 * two on each piece where walls or jumps cut a support (solver/space/sample.c).  Finite differences take four on each
 * piece of every point's own (solver/differences/ftcs_sample.c). */
static double nodes_along(const struct extent *e, int axis, const struct result *r) {
    const struct problem *p = &e->part;
    int n = e->along[axis], pieces = r->options.sampling == SAMPLING_CELL ? 1 : 4, before = 0;
    double dx = (p->hi[axis] - p->lo[axis]) / n, reach = pieces * dx / 2 * (1 - 1e-9), sum = 0;
    if (r->options.sampling == SAMPLING_POINT || axis >= p->dim) return n;
    struct lattice l = lattice_of(e);
    int cut[2];
    for (int hi = 0; hi < 2; hi++) {
        enum side side = (enum side)(2 * axis + hi);
        cut[hi] = p->side[side] == DIRICHLET && (r->method->scheme == NULL || !sample_meets_wall(p, &l, side));
    }
    for (int i = 0; i < n; i++) {
        double x = p->lo[axis] + (i + 0.5) * dx;
        int cuts = 0;
        for (int k = 0; k < p->jumps[axis]; k++) cuts += fabs(p->jump[axis][k] - x) < reach;
        for (int hi = 0; hi < 2; hi++) cuts += cut[hi] && fabs((hi ? p->hi : p->lo)[axis] - x) < reach;
        if (r->method->scheme == NULL)
            sum += 4 * (pieces + cuts);
        else if (cuts == 0)
            sum += pieces == 1 ? 2 : 1;
        else
            sum += 2 * ((before ? 1 : pieces) + (cuts > before ? cuts - before : 0));
        before = cuts;
    }
    return sum;
}

/* The weights of one particle. */
static double weighing(const struct result *r, int dim, double neighbours) {
    int order = r->method->scheme->sweeps == 2 ? 1 : r->options.order > 2 ? r->options.order : 2;
    int t = dim == 1 ? order : (order + 1) * (order + 2) / 2 - 1;
    if (r->method->scheme->volume) return neighbours * FUNCTION; /* no moment matrix */
    return neighbours * (FUNCTION + t * (t + 6)) + t * t * (t / 6.0 + t + 1);
}

/* Neighbours within 2 h of a lattice's particle. */
static double surrounding(int dim, double h) {
    return dim == 1 ? 2 * (ceil(2 * h) - 1) : M_PI * 4 * h * h - 1;
}

static double rows(const struct extent *e, const struct result *r, double columns) {
    int dim = e->part.dim;
    double h = r->options.h, near = surrounding(dim, h), visited = dim == 1 ? 3 * 2 * h : 9 * 4 * h * h;
    double composed = r->method->scheme->sweeps == 2 ? near * near : 0;
    return e->n * (4 * (visited + composed + columns * log2(columns + 1)) + weighing(r, dim, near));
}

/* Whether walls or a source add anything. */
static int has_constants(const struct extent *e) {
    int any = e->part.source != NULL;
    for (int s = 0; s < 2 * e->part.dim; s++) any |= e->part.wall(&e->part, (enum side)s, e->part.lo) != 0;
    return any;
}

static double reach_of(const struct result *r) {
    return (ceil(2 * r->options.h) - 1) * r->method->scheme->sweeps;
}

static double stencil(const struct extent *e, const struct result *r) {
    int dim = e->part.dim;
    double reach = reach_of(r), framed = 1, feet = 0;
    double searched = r->options.h_iso ? 2 * ceil(16 * fabs(r->options.h - 1.2)) + 7 : 0;
    for (int a = 0; a < dim; a++) framed *= e->along[a] + 2 * reach;
    for (int a = 0; a < dim; a++) feet += 2 * (dim == 1 ? 1 : e->along[1 - a] + 2 * reach);
    return feet * FUNCTION + has_constants(e) * (framed - e->n) * GHOST +
           weighing(r, dim, surrounding(dim, r->options.h)) * (1 + searched);
}

/* `times` transforms along an axis. */
static double transforms(const struct extent *e, int axis, int times) {
    double n = e->along[axis];
    return (times * e->n * 1.25 + 2 * SOLVERS * TRIED) * log2(n);
}

static double modes(const struct extent *e, const struct result *r) {
    int walls = has_constants(e);
    double sum = 0, reach = ceil(2 * r->options.h) * r->method->scheme->sweeps;
    for (int a = 0; a < e->part.dim; a++) sum += transforms(e, a, 2 + walls) + reach * e->along[a] * FUNCTION;
    return sum + e->n * (1 + walls) * FUNCTION;
}

static int has_rows(const struct problem *p, const struct result *r) {
    return r->method->scheme && (r->options.layout == LAYOUT_JITTER || p->materials == 2);
}

double work_of_ghosts(const struct problem *p, const struct result *r) {
    struct extent e = extent_of(p, r);
    double layers = r->method->scheme ? reach_of(r) : 2, ghosts = 0;
    if (has_rows(p, r)) return 0;
    for (int a = 0; a < p->dim; a++) ghosts += 2 * layers * (p->dim == 1 ? 1 : e.along[1 - a]);
    return LANES * REFRESHED * ghosts * (double)r->steps * r->stages;
}

double work_of_setup(const struct problem *p, const struct result *r) {
    struct extent e = extent_of(p, r);
    double scalar = PLACE * (double)r->particles, samples = nodes_along(&e, 0, r) * nodes_along(&e, 1, r);
    scalar += POINT * samples;
    if (has_rows(p, r))
        scalar += rows(&e, r, (double)r->interactions / (double)r->updates);
    else if (r->method->scheme)
        scalar += stencil(&e, r);
    if (r->method->scheme && r->steps == 0) scalar += modes(&e, r);
    return LANES * scalar;
}
