/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_SOLVER_TIME_RKL2_H
#define HEATLADDER_SOLVER_TIME_RKL2_H

/* Stages that RKL2 needs for steps of dt (s), odd, from the bound (s^-1) on the spectrum; or more than
 * STEPPER_STAGES_MAX. */
int rkl2_stages(double dt, double bound);

/* The stages of a damping first step of dt (s). */
void rkl2_start(double dt, double bound, int stages[2]);

#endif
