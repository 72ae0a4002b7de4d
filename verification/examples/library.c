/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The largest error of second-order symmetric SPH on a rod, by libheatladder:
 *
 *     cc library.c $(pkg-config --cflags --libs heatladder) -lm && ./a.out */
#include <heatladder.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

int main(void) {
    struct hl_error why;
    struct hl_setting settings[] = {{"kappa", 0.02}, {NULL, 0}};
    struct hl_problem *problem = hl_problem_create("rod-step", settings, &why);
    for (double dx = 0.1; problem && dx > 0.02; dx /= 2) {
        struct hl_field field;
        struct hl_options options = {.dx = dx};
        if (hl_solve(problem, "so_ssph", &options, &field, &why)) break;
        double *exact = calloc(2 * field.n, sizeof *exact), *bound = exact + field.n, largest = 0;
        if (!exact || hl_exact(problem, field.t, field.n, field.x, field.y, exact, bound, &why)) break;
        for (size_t i = 0; i < field.n; i++) largest = fmax(largest, fabs(field.T[i] - exact[i]) + bound[i]);
        printf("dx = %g m: %zu particles, largest error %.3g K\n", dx, field.n, largest);
        hl_field_free(&field);
        free(exact);
    }
    if (!problem || why.status) fprintf(stderr, "%s\n", why.text);
    hl_problem_free(problem);
    return !problem || why.status;
}
