#ifndef HEATLADDER_REFERENCES_RECTANGLE_H
#define HEATLADDER_REFERENCES_RECTANGLE_H

#include "references/series.h"

/* Response of a rectangle at zero to one side that is held at 1 from t = 0 on, the other three at zero.  The point
 * lies at the distance xi from the hot side (0 <= xi <= W) and eta from one of its neighbours (0 <= eta <= B); s =
 * sqrt(4 kappa t), m, stands for the time. */

struct approx rectangle_response(double xi, double W, double eta, double B, double s);

/* The same from quadrature over time of the wall's Green's function; shares no form with rectangle_response. */
struct approx rectangle_quadrature(double xi, double W, double eta, double B, double s);

/* The limit s -> infinity. */
struct approx rectangle_steady(double xi, double W, double eta, double B);

/* The same from the first n terms of the sine series of Pamplona 2019 eq. 2, plainly and accelerated. */
struct series_levin rectangle_steady_series(double xi, double W, double eta, double B, size_t n);

/* sinh(q a)/sinh(q b) for 0 <= a <= b, q > 0, without overflow. */
double rectangle_sinh_ratio(double q, double a, double b);

/* Deficit by one corner: erfc(xi/s) less the temperature of a quarter plane whose side at the distance xi is held at
 * 1 and the other, at the distance eta, at 0. */
double rectangle_corner(double xi, double eta, double s);

#endif
