/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_CEILING_H
#define HEATLADDER_VERIFICATION_GATES_CEILING_H

/* Predicted errors for the bounds of gates.def, from the moments of the kernel, the spacing and the exact solution
 * of the scene.  No code of the operators is used.  Each function has the experiment at its finest rung as its
 * argument and returns E1 unless stated otherwise; NAN if the formula does not apply. */

#include "verification/solve/experiment.h"

/* ---- The symbol of a method on a lattice ---- */

/* -(q_x^2 + ratio q_y^2) + dx^2 sum_b fourth[b] q_x^(4-2b) q_y^2b - dx^4 sum_b sixth[b] q_x^(6-2b) q_y^2b, in units
 * of kappa_x: fourth[b] = sum w x^(4-2b) y^2b/((4-2b)! (2b)!). */
enum { CEILING_REACH = 4 };
struct ceiling_symbol {
    double fourth[3], sixth[4];
    double by_axes[DIM_MAX][DIM_MAX]; /* sum w x_a^4/24, or sum w x_a^2 x_b^2/4 */
    double row;                       /* sum |w| of a row */
    double link[CEILING_REACH + 1];   /* w of a neighbour n dx away */
    double blind;    /* first derivatives applied twice: diffusivity of the envelope of (-1)^i over kappa; else 0 */
    double ghost[2]; /* over pairs of a row i + 1/2 and a ghost k + 1/2 from the wall: sum w (i + 1/2) (k + 1/2)^4
                        across x, sum w (k + 1/2)^5 across y over the ratio */
    double h;        /* h/dx; 0 for finite differences */
};
struct ceiling_symbol ceiling_symbol(const struct experiment *e);

/* sum fourth[b] of the method divided by that of the central difference, in the direction of the largest ratio */
double ceiling_worst(const struct experiment *e);

/* ---- Errors in space ---- */

/* Second order: dx^2 (kappa t (A T_xxxx ...) + m/24 lap T), with m = 0 for smooth data, -1 for point samples of a
 * jump midway between points, 1 for cell averages, 4 for cubic splines; Euler steps add -dt/2 t T_tt. */
double ceiling_lattice(const struct experiment *e);
/* As ceiling_lattice, with point samples of the initial data. */
double ceiling_points(const struct experiment *e);
/* As ceiling_lattice, averaged over all directions of the lattice, for round bodies. */
double ceiling_round(const struct experiment *e);
double ceiling_round_largest(const struct experiment *e); /* its largest value, K */
/* E1/dx if a Dirichlet outer wall is displaced by dx: |dT/dn| in a layer of width sqrt(4 kappa t/pi). */
double ceiling_layer(const struct experiment *e);
/* Fourth order on rods: the next term of the symbol. */
double ceiling_fourth(const struct experiment *e);
/* A matched run (solver/time/matched.c): the sixth derivatives, and the fourth derivatives of the averaged initial
 * data, in the direction of their maximum. */
double ceiling_matched(const struct experiment *e);
/* rod-step by first derivatives applied twice: samples of a piece that is `off` dx wider at either edge, and the
 * envelope of (-1)^i with a source of `half` dx at either edge. */
double ceiling_blind(const struct experiment *e, double off, double half);
/* 2 A^2 - (r d)^2 (1 + 3 u^2)/3 of a matched run with kappa t/dx^2 = rt. */
double ceiling_matched_rest(double A, double rt);
/* rect-manufactured: solves e_t = L e + r on a separate grid, with r from fourth derivatives, or from sixth ones at
 * order 4 and in a matched run with k_x = k_y. */
double ceiling_manufactured(const struct experiment *e);
/* rod-cooling, and plate-cooling with its hot side at the temperature of the air: discrete modes.  Fourth moments
 * are `more` times those of the lattice; cloud: 1 if the distances of ghosts vary. */
double ceiling_cooled(const struct experiment *e, double more, int cloud);
/* rod-driven and plate-driven: e_t = L e + r, with r(t) from the fourth derivatives, or from the sixth ones on a rod
 * at order 4. */
double ceiling_driven(const struct experiment *e);
/* The part of a cell-centred code without dT/dt in its walls: with T_w - T_0 over half a cell the wall is off by
 * dx^2/8 T_nn. */
double ceiling_plain_wall(const struct experiment *e);
/* 4th moments under jitter of j dx: 1 + 4 j^2 */
double ceiling_jitter(const struct experiment *e);

/* k that depends on T: the truncation error of operator and mean on a rod with smooth data; parts of the heat of the
 * front's wave, in the cell behind the front, and ahead of its initial place. */
double ceiling_kirchhoff(const struct experiment *e);
double ceiling_kirchhoff_time(const struct experiment *e); /* errors in time, of euler, rk2 or rkl2 */
double ceiling_tip(const struct experiment *e);
double ceiling_ahead(const struct experiment *e);

/* The exact solution compared with the exact solution for a parameter larger by `by`, or for a time shorter by the
 * fraction `part`. */
double ceiling_changed(const struct experiment *e, const char *name, double by);
double ceiling_late(const struct experiment *e, double part);

/* The error of the five-point difference at the larger of dx and dy; linf: 1 for the largest error, K.  On faces:
 * for a jump at its place in the scene. */
double ceiling_five_point(const struct experiment *e, int linf);
double ceiling_five_point_on_faces(const struct experiment *e);
double ceiling_harmonic_mean(const struct experiment *e); /* the same with harmonic means, for k that depends on T */

/* The error of the seven-point difference in a ball, averaged over the directions of its lattice. */
double ceiling_ball(const struct experiment *e);

/* ---- Bounds for codes of any kind ---- */

/* The effect of cell means used as values, dx^2/24 lap T; of a field displaced by a cell along each axis; and |T_xx
 * / T_x| at the high end of a rod, m^-1. */
double ceiling_cell_mean(const struct experiment *e);
double ceiling_cell_away(const struct experiment *e);
double ceiling_bend(const struct experiment *e);
/* rect-manufactured in steps of dt: the error of a source taken one step away, and that of Euler's method in the
 * decaying part. */
double ceiling_source_step(const struct experiment *e, double dt);
double ceiling_euler(const struct experiment *e, double dt);

/* The resistance, divided by dx, that harmonic means add to a contact midway between particles; E1 on rod-contact
 * for a resistance R dx; E1 on a rod of pairs in series whose distances are jittered. */
double ceiling_harmonic(const struct experiment *e);
double ceiling_contact(const struct experiment *e, double R);
double ceiling_stall(const struct experiment *e);
double ceiling_pair(const struct experiment *e, double r); /* the weight of a pair at distance r dx, up to a factor */

/* ---- Errors in time ---- */

/* Euler: dt/2 t T_tt; midpoint rule: dt^2/6 t T_ttt; RKL2: (1 + 8/(s^2 + s - 2))/18 dt^2 t T_ttt. */
double ceiling_time(const struct experiment *e);
/* The factor of dt^2 t T_ttt of the last two. */
double ceiling_third(const struct experiment *e);
/* rod-driven and plate-driven: also the data of each step, linear in time. */
double ceiling_driven_time(const struct experiment *e);
/* rod-driven by polynomials in time: the data of each step, of degree 4. */
double ceiling_driven_polynomials(const struct experiment *e);
/* rod-driven: explicit Euler steps of dt with the wall of their end, or implicit ones with that of their start. */
double ceiling_driven_step(const struct experiment *e, double dt);
/* dx^4/540 t T_ttt/kappa^2: Euler steps at F = 1/6 cancel the leading error of the three-point difference. */
double ceiling_sixth(const struct experiment *e);

/* ---- Parameters ---- */

double ceiling_param(const struct experiment *e, const char *name); /* parameter of the scene; NAN if it has none */

#endif
