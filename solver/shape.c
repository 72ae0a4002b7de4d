/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shapes of bodies.  A rod, rectangle or box is the box from lo to hi; a round body is bounded by circles about 0, a
 * ball by a sphere.
 *
 * The area of a disc inside a box is the integral over x of the length of the line at x inside both, clamp(s, c, d)
 * - clamp(-s, c, d), s = sqrt(R^2 - x^2).  Between the positions at which s crosses |c| or |d| each term is either
 * constant or an arc with the integral (x s + R^2 asin(x/R))/2.
 *
 * The volume of a ball in a box is an alternating sum over its corners c of the volume between 0 and c.  If c is
 * outside the ball, the divergence of x/3 gives it as (sum_k c_k A_k + R S)/3, with the area A_k of a disc on the
 * face through c across axis k and the area S of the sphere inside: that of the octant less the caps beyond the
 * faces, plus twice counted parts of two caps.  Rounding is some eps R^3. */
#include "solver/shape.h"

#include <math.h>
#include <string.h>

static double clamp(double x, double lo, double hi) {
    return x < lo ? lo : x > hi ? hi : x;
}

static double half_chord(double R, double x) {
    return sqrt(fmax(0, (R - x) * (R + x)));
}

/* Integral of half_chord from a to b, |a|, |b| <= R. */
static double arc(double R, double a, double b) {
    return (b * half_chord(R, b) - a * half_chord(R, a) + R * R * (asin(b / R) - asin(a / R))) / 2;
}

/* Integral over x of clamp(sign s, c, d) from a to b, an interval without such a position. */
static double under(double R, int sign, double a, double b, double c, double d) {
    double middle = sign * half_chord(R, (a + b) / 2);
    return middle < c ? (b - a) * c : middle > d ? (b - a) * d : sign * arc(R, a, b);
}

static double disc_area(double R, const double *lo, const double *hi) {
    double at[6], area = 0, from = clamp(lo[0], -R, R), to = clamp(hi[0], -R, R);
    int n = 0;
    at[n++] = from;
    for (int k = 0; k < 4; k++) { /* ascending by construction: -far, -near, near, far */
        double c = fabs(lo[1]), d = fabs(hi[1]), y = (k == 0 || k == 3) == (c < d) ? c : d;
        at[n++] = clamp(k < 2 ? -half_chord(R, y) : half_chord(R, y), from, to);
    }
    at[n++] = to;
    for (int k = 0; k + 1 < n; k++)
        if (at[k + 1] > at[k])
            area += under(R, 1, at[k], at[k + 1], lo[1], hi[1]) - under(R, -1, at[k], at[k + 1], lo[1], hi[1]);
    return area;
}

static double round_area(const struct problem *p, const double *lo, const double *hi) {
    double hole = p->radius[0] > 0 ? disc_area(p->radius[0], lo, hi) : 0;
    return fmax(0, disc_area(p->radius[1], lo, hi) - hole);
}

static struct foot round_foot(const struct problem *p, enum side s, const double *x) {
    double R = p->radius[s], r = hypot(x[0], x[1]), u[2] = {r > 0 ? x[0] / r : 1, r > 0 ? x[1] / r : 0};
    int out = s == X_HI ? 1 : -1;
    return (struct foot){{R * u[0], R * u[1], 0}, {out * u[0], out * u[1], 0}, out * (R - r)};
}

const struct shape shape_disc = {"disc", round_foot, round_area};
const struct shape shape_annulus = {"annulus", round_foot, round_area};

static struct foot ball_foot(const struct problem *p, enum side s, const double *x) {
    double R = p->radius[1], r = hypot(hypot(x[0], x[1]), x[2]);
    struct foot f = {.depth = R - r};
    (void)s;
    for (int a = 0; a < 3; a++) f.normal[a] = r > 0 ? x[a] / r : a == 0, f.x[a] = R * f.normal[a];
    return f;
}

/* Area on the unit sphere with x > a, y > b and z > 0, 0 <= a, b <= 1: the integral of acos(b/sqrt(1 - x^2)) over
 * x > a, by Archimedes' theorem. */
static double two_caps(double a, double b) {
    double rest = 1 - a * a - b * b;
    if (rest <= 0) return 0;
    return M_PI / 2 - atan2(a * b, sqrt(rest)) - a * acos(b / sqrt(1 - a * a)) - b * acos(a / sqrt(1 - b * b));
}

/* Volume of the unit ball in the box from 0 to c, of the sign of the product of c. */
static double ball_corner(const double c[3]) {
    double a[3], zero[2] = {0, 0}, sum = M_PI / 2, sign = 1; /* sum: area on the octant of the sphere */
    for (int k = 0; k < 3; k++) a[k] = fmin(fabs(c[k]), 1), sign *= c[k] < 0 ? -1 : 1;
    if (a[0] * a[0] + a[1] * a[1] + a[2] * a[2] <= 1) return sign * a[0] * a[1] * a[2];
    for (int k = 0; k < 3; k++) sum += two_caps(a[k], a[(k + 1) % 3]) - M_PI / 2 * (1 - a[k]);
    for (int k = 0; k < 3; k++) {
        double face[2] = {a[(k + 1) % 3], a[(k + 2) % 3]}, R = half_chord(1, a[k]);
        if (R > 0) sum += a[k] * disc_area(R, zero, face);
    }
    return sign * sum / 3;
}

static double ball_volume(const struct problem *p, const double *lo, const double *hi) {
    double sum = 0, R = p->radius[1];
    for (int corner = 0; corner < 8; corner++) {
        double c[3], sign = 1;
        for (int a = 0; a < 3; a++) c[a] = (corner >> a & 1 ? hi[a] : lo[a]) / R, sign *= corner >> a & 1 ? 1 : -1;
        sum += sign * ball_corner(c);
    }
    return fmax(0, sum) * R * R * R;
}

const struct shape shape_ball = {"ball", ball_foot, ball_volume};

void shape_round(struct problem *p, double hole, double radius) {
    p->dim = 2;
    p->shape = hole > 0 ? &shape_annulus : &shape_disc;
    p->radius[0] = hole, p->radius[1] = radius;
    for (int a = 0; a < 2; a++) p->lo[a] = -radius, p->hi[a] = radius;
}

void shape_make_ball(struct problem *p, double radius) {
    p->dim = 3;
    p->shape = &shape_ball;
    p->radius[1] = radius;
    for (int a = 0; a < 3; a++) p->lo[a] = -radius, p->hi[a] = radius;
}

int shape_has_wall(const struct problem *p, int s) {
    if (p->shape) return s == X_HI || (s == X_LO && p->radius[0] > 0);
    return s < 2 * p->dim && p->side[s] != PERIODIC;
}

static double wall_depth(const struct problem *p, int s, const double *x) {
    if (p->shape) return p->shape->foot(p, (enum side)s, x).depth;
    return s % 2 ? p->hi[s / 2] - x[s / 2] : x[s / 2] - p->lo[s / 2];
}

struct foot shape_foot(const struct problem *p, int s, const double *x) {
    if (p->shape) return p->shape->foot(p, (enum side)s, x);
    int a = s / 2, out = s % 2 ? 1 : -1;
    struct foot f = {.depth = 0};
    for (int b = 0; b < p->dim; b++) f.x[b] = x[b];
    f.x[a] = s % 2 ? p->hi[a] : p->lo[a];
    f.normal[a] = out;
    f.depth = wall_depth(p, s, x);
    return f;
}

struct foot shape_nearest(const struct problem *p, const double *x, int *s) {
    struct foot nearest = {.depth = INFINITY};
    *s = -1;
    for (int k = 0; k < 2 * p->dim; k++) {
        if (!shape_has_wall(p, k)) continue;
        struct foot f = shape_foot(p, k, x);
        if (f.depth < nearest.depth) nearest = f, *s = k;
    }
    return nearest;
}

double shape_depth(const struct problem *p, const double *x) {
    double least = INFINITY;
    for (int k = 0; k < 2 * p->dim; k++) {
        double depth = shape_has_wall(p, k) ? wall_depth(p, k, x) : INFINITY;
        if (depth < least) least = depth;
    }
    return least;
}

double shape_clipped(const struct problem *p, const double *lo, const double *hi) {
    if (p->shape) return p->shape->area(p, lo, hi);
    double volume = 1;
    for (int a = 0; a < p->dim; a++) volume *= fmax(0, fmin(hi[a], p->hi[a]) - fmax(lo[a], p->lo[a]));
    return volume;
}

double shape_volume(const struct problem *p) {
    return shape_clipped(p, p->lo, p->hi);
}

int shape_pieces(const struct problem *p, double x, double lo, double hi, double piece[2][2]) {
    double most = p->shape ? half_chord(p->radius[1], x) : INFINITY;
    double least = p->shape && fabs(x) < p->radius[0] ? half_chord(p->radius[0], x) : 0;
    double whole[2][2] = {{-most, least > 0 ? -least : most}, {least, most}};
    int n = 0;
    for (int k = 0; k < (least > 0 ? 2 : 1); k++) {
        piece[n][0] = fmax(whole[k][0], fmax(lo, p->lo[1]));
        piece[n][1] = fmin(whole[k][1], fmin(hi, p->hi[1]));
        n += piece[n][1] > piece[n][0];
    }
    return n;
}
