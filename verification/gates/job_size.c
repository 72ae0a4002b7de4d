/* Work = sum over rungs of particles x steps; steps = t kappa / (F dx^2), with F as given, or the 1/600 or so at
 * which the time error of Euler's method falls below 1 %, and a few for the exact stepper. */
#include "verification/gates/job_size.h"

#include "verification/command/arguments.h"

#include <math.h>

static double steps_at(const struct request *r, double dx) {
    const struct experiment *e = &r->experiment;
    const struct material *m = &e->problem.material[0];
    double diffusion = e->problem.t_end * m->k[0] / m->rho_c / (dx * dx), steps = 0;
    for (int i = 0; i < r->rungs.dt.count; i++) steps += e->problem.t_end / r->rungs.dt.value[i];
    for (int i = 0; i < r->rungs.fourier.count; i++) steps += diffusion / r->rungs.fourier.value[i];
    if (steps > 0) return steps;
    return e->method && e->method->scheme && e->options.stepper <= STEPPER_EXACT ? 20 : 600 * diffusion;
}

double job_size_of_request(const struct request *r) {
    const struct problem *p = &r->experiment.problem;
    double work = 0;
    for (int i = 0; i < r->rungs.dx.count; i++) {
        double particles = 1;
        for (int a = 0; a < p->dim; a++) particles *= (p->hi[a] - p->lo[a]) / r->rungs.dx.value[i];
        work += particles * steps_at(r, r->rungs.dx.value[i]);
    }
    return work;
}

double job_size_of_line(const char *command) {
    struct request r;
    struct failure why;
    double work = arguments_parse_line(command, &r, &why) ? 0 : job_size_of_request(&r);
    arguments_free(&r);
    return isfinite(work) ? work : 0;
}
