/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_GATES_CEILING_H
#define HEATLADDER_VERIFICATION_GATES_CEILING_H

/* Ceilings: bounds of errors for gates.def and battery.def.  e is the experiment at its finest rung; each function
 * returns E1 unless stated otherwise, NAN where it does not apply.
 *
 * `ceiling` holds for any scene, wall and operator of second order.  The finite differences, which share no line with
 * the particles, run the same problem at the same spacing, without an error in time; an operator whose fourth moment
 * in some direction is up to `ceiling_worst` times theirs has an error up to that much larger.  30 % cover terms of
 * either sign that cancel differently in the two codes.  The finite differences themselves have the bounds of theory
 * (ceiling_truncation).  The others below are for rows where this cannot hold, each named after its idea. */

#include "verification/case/experiment.h"

double ceiling(const struct experiment *e);
double ceiling_largest(const struct experiment *e); /* the same of the largest error, K */
/* The same with means of k(T) that are harmonic: their error is another one. */
double ceiling_harmonic_pairs(const struct experiment *e);

/* The largest ratio of fourth moments over all directions u, sum w (u.x)^4/24 of the method over that of the central
 * difference. */
double ceiling_worst(const struct experiment *e);

/* The error of the five-point difference (seven points in space; rings and shells in round bodies) at the larger of
 * dx and dy.  largest: 1 for the largest error, K.  On faces: with the jumps moved to the nearest faces. */
double ceiling_five_point(const struct experiment *e, int largest);
double ceiling_five_point_on_faces(const struct experiment *e);
double ceiling_harmonic_mean(const struct experiment *e); /* with harmonic means, for k that depends on T */

/* The fourth moments under a jitter of j dx over those of the lattice: 1 + 4 j^2 (distances of pairs vary by
 * <d^2> = 2/3 j^2 dx^2). */
double ceiling_jitter(const struct experiment *e);

/* ---- Truncation: derivatives of the exact solution at the end, times t ---- */

/* Second order, without walls that add an error: A dx^2 kappa t T_xxxx with the fourth moment A, averaged over the
 * directions of a round body; in the plane and in space the bilaplacian over the smallest kappa, up to 4 times as
 * large.  An averaged start has m/24 dx^2 lap T more (m = -1 for point samples of a jump midway between points, 1 for
 * cells, 4 for cubic splines), Euler steps -dt/2 t T_tt. */
double ceiling_truncation(const struct experiment *e);
double ceiling_central(const struct experiment *e); /* the same of the central difference, without an error in time */
double ceiling_fourth(const struct experiment *e);  /* fourth order on rods: the sixth moment */
/* Fourth order where walls and sources add to the error: the next term of the series, (q dx)^2 times the ratio of the
 * sixth moment to that of the central difference's fourth, of `ceiling`.  q: wave number of the data, m^-1. */
double ceiling_next(const struct experiment *e, double q);
/* A matched run (solver/time/matched.c): the sixth derivatives that it leaves, and the fourth ones of an averaged
 * start, in the direction of their maximum. */
double ceiling_matched(const struct experiment *e);
/* dx^4/540 t T_ttt/kappa^2: Euler steps at F = 1/6 cancel the leading error of the three-point difference. */
double ceiling_sixth(const struct experiment *e);
/* Errors in time, of order 1 and 2.  Euler: dt/2 t T_tt; midpoint rule: dt^2/6 t T_ttt; RKL2: (1 + 8/(s^2 + s -
 * 2))/18 dt^2 t T_ttt. */
double ceiling_time(const struct experiment *e);
double ceiling_euler(const struct experiment *e, double dt);

/* ---- Truncation over the run ---- */

/* The heat operator does not increase the mean of |e|.  An error that solves e_t = L e + r is therefore at most the
 * integral of the mean of |r| over the run. */
double ceiling_run_time(const struct experiment *e); /* errors in time where walls change or k depends on T */
/* rod-driven by polynomials of degree 4 in time: the drive of a step between its five values. */
double ceiling_polynomials(const struct experiment *e);

/* ---- Single ideas (ceiling_ideas.c) ---- */

double ceiling_blind(const struct experiment *e, double off, double half); /* first derivatives twice, and a jump */
double ceiling_layer(const struct experiment *e);    /* E1/dx of a Dirichlet outer wall that is displaced by dx */
double ceiling_harmonic(const struct experiment *e); /* resistance over dx that harmonic links add to a contact */
double ceiling_contact(const struct experiment *e, double R);   /* E1 on rod-contact of a resistance R dx */
double ceiling_stall(const struct experiment *e);               /* jittered pairs in series */
double ceiling_front(const struct experiment *e, double width); /* heat of the tip of a front of that width, m */
/* front with x0 >= L: the flux that a mean of k(T) misses, in units of the wave. */
double ceiling_wave(const struct experiment *e, double units);

/* ring, data=patch: fluxes at faces damp radial waves by kappa dx^2 sin^2(2 theta) q^4/16; an edge spreads by d =
 * (kappa t dx^2 sin^2(2 theta)/16)^(1/4), and misses c d A of each edge, c the integral of |step - its image under
 * exp(-q^4)|, 1.211. */
double ceiling_patch(const struct experiment *e);

/* The same: K, T - Tm at the end on the circle r2 at theta = pi, the largest jump of T there. */
double ceiling_patch_jump(const struct experiment *e);

/* aligned with a quantity at a point: its relative error if the rate of psi is off by par k_par dx^2 and by the
 * fraction all dx^2. */
double ceiling_aligned(const struct experiment *e, double par, double all);

/* wave: sum w (q.x)^4/24, times kappa and t, of the decayed wave; of any tensor. */
double ceiling_tensor(const struct experiment *e);

/* The exact solution compared with the exact solution for a parameter larger by `by`, or for a time shorter by the
 * fraction `part`. */
double ceiling_changed(const struct experiment *e, const char *name, double by);
double ceiling_late(const struct experiment *e, double part);
/* rod-driven: Euler steps of dt, with the wall of their start, or one step early. */
double ceiling_driven_step(const struct experiment *e, double dt, int early);

/* Codes of any kind: the effect of cell means used as values, dx^2/24 lap T; of a field displaced by a cell along
 * each axis; |T_xx| of the six cells at the high end of a rod, by their weights in the gradient there, over
 * |T_x| there, m^-1; a source of rect-manufactured taken dt away. */
double ceiling_cell_mean(const struct experiment *e);
double ceiling_cell_away(const struct experiment *e);
double ceiling_bend(const struct experiment *e);
double ceiling_source_step(const struct experiment *e, double dt);

/* K, the largest error at nodes on the edge of a cooled side and one of given flux, in a body with steady walls.
 *
 * A face's load g (the flux, b T_a) that is taken at its nodes exceeds the integral of g times a linear function,
 * with which the stiffness of linear elements is consistent, by dx^2/6 dg/ds per length of the edge.  On the wall
 * inside these parts cancel.  On the edge they are a source of q = dx^2/6 (|dg_1/ds_1| + |dg_2/ds_2|), W/m; values at
 * the middle of faces have half of it, of the other sign.  Steady, in the quarter space with the conductivities k_1
 * across the side of given flux and k_2 across the cooled one, on the lattice,
 *
 *     T = 2 q/(pi sqrt(k_1 k_2)) log(4 k_2/(b dx) sqrt(k_1/(k_1 + k_2)))
 *
 * from the integral over u = s dx/2, 0 to pi/2, of 1/(sin u sqrt(1 + k_1/k_2 sin^2 u) + b dx/(2 sqrt(k_1 k_2))), s
 * the wave number along the cooled side, for b dx much below k. */
double ceiling_edges(const struct experiment *e);

double ceiling_param(const struct experiment *e, const char *name); /* parameter of the scene; NAN if it has none */

#endif
