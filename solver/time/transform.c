/* Sine and cosine transforms along the axes of a lattice.
 *
 * Mode k is phi_k(i) = sin or cos(theta_k s_i), odd or even about the low wall, at the distance s_i from it; theta_k
 * is such that it is odd or even about the high wall too.  Forward: c_k = 2 sum_i w_i phi_k(i) T_i, w_i = 1/2 on an
 * insulated wall, else 1; back: T_i = sum_k m_k c_k phi_k(i), m_k = 1 where phi_k^2 = 1 throughout, else 2.  These
 * are FFTW's r2r transforms ("1d Real-even DFTs", "1d Real-odd DFTs").  On a short axis the sums themselves are done
 * in less time than FFTW takes to load and plan.
 *
 * Each pass takes rows along one axis to columns, so that two passes are a transform of the plane. */
#include "solver/time/transform.h"

#include <fftw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#if defined(__x86_64__) && defined(__gnu_linux__)
#define CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define CLONES
#endif

enum { LINES = 4, WIDTH = 8 }; /* the tile of a product */

/* WIDTH doubles that need no more alignment than one; the compiler makes of them what the machine has. */
typedef double vector __attribute__((vector_size(8 * WIDTH), aligned(8), may_alias));

struct basis {
    fftw_r2r_kind kind[2]; /* forward, back */
    double first;          /* theta_k = pi (k + first) / (n + more) */
    int more;
};

/* Indexed by [node layout][low side even][high side even]. */
static const struct basis bases[2][2][2] = {
    {{{{FFTW_RODFT10, FFTW_RODFT01}, 1, 0}, {{FFTW_RODFT11, FFTW_RODFT11}, 0.5, 0}},
     {{{FFTW_REDFT11, FFTW_REDFT11}, 0.5, 0}, {{FFTW_REDFT10, FFTW_REDFT01}, 0, 0}}},
    {{{{FFTW_RODFT00, FFTW_RODFT00}, 1, 1}, {{FFTW_RODFT01, FFTW_RODFT10}, 0.5, 0}},
     {{{FFTW_REDFT01, FFTW_REDFT10}, 0.5, 0}, {{FFTW_REDFT00, FFTW_REDFT00}, 0, -1}}},
};

struct axis {
    int n, lines;
    double *sums[2]; /* n rows of `padded`: what T_i counts for in each c_k, and c_k in each T_i */
    fftw_plan plan[2];
};

struct transform {
    int dim, alike; /* alike: both axes are one */
    struct axis axis[2];
    double *work; /* n[0] x n[1] */
};

static const struct basis *basis_of(const struct lattice *l, int axis) {
    return &bases[l->shift[2 * axis] != 0][l->sign[2 * axis] > 0][l->sign[2 * axis + 1] > 0];
}

double transform_angle(const struct lattice *l, int axis, int k) {
    const struct basis *b = basis_of(l, axis);
    return M_PI * (k + b->first) / (l->n[axis] + b->more);
}

double transform_gain(const struct lattice *l) {
    double gain = 1;
    for (int a = 0; a < l->dim; a++) gain *= 2.0 * (l->n[a] + basis_of(l, a)->more);
    return gain;
}

static size_t padded(int n) {
    return ((size_t)n + WIDTH - 1) / WIDTH * WIDTH;
}

static int alike(const struct lattice *l) {
    return l->dim == 2 && l->n[0] == l->n[1] && basis_of(l, 0) == basis_of(l, 1);
}

size_t transform_library_bytes(int n) {
    return (size_t)n * 5 * sizeof(double);
}

size_t transform_bytes(const struct lattice *l) {
    size_t bytes = (size_t)l->n[0] * (size_t)l->n[1] * sizeof(double);
    for (int a = 0; a < (alike(l) ? 1 : l->dim); a++)
        bytes += l->n[a] > TRANSFORM_SHORT ? transform_library_bytes(l->n[a])
                                           : 2 * (size_t)l->n[a] * padded(l->n[a]) * sizeof(double);
    return bytes;
}

/* The angles theta_k s_i are whole multiples of pi / (4 N), N = n + more. */
static void fill_sums(const struct lattice *l, int axis, double *sums[2]) {
    const struct basis *b = basis_of(l, axis);
    int n = l->n[axis], N = n + b->more, node = l->shift[2 * axis] != 0, even = l->sign[2 * axis] > 0;
    size_t stride = padded(n);
    double *wave = xcalloc(8 * (size_t)N, sizeof *wave);
    for (int m = 0; m < 8 * N; m++) wave[m] = even ? cos(M_PI * m / (4 * N)) : sin(M_PI * m / (4 * N));
    for (int k = 0; k < n; k++)
        for (int i = 0; i < n; i++) {
            int mode = (int)(2 * (k + b->first)), place = 2 * i + (node ? 2 * !even : 1);
            double phi = wave[mode * place % (8 * N)];
            sums[0][(size_t)i * stride + (size_t)k] = (node && (place == 0 || place == 2 * N) ? 1 : 2) * phi;
            sums[1][(size_t)k * stride + (size_t)i] = (mode == 0 || mode == 2 * N ? 1 : 2) * phi;
        }
    free(wave);
}

static struct axis prepare(const struct lattice *l, int axis, double *T, double *work) {
    struct axis a = {.n = l->n[axis], .lines = l->dim == 2 ? l->n[1 - axis] : 1};
    if (a.n <= TRANSFORM_SHORT) {
        for (int way = 0; way < 2; way++) a.sums[way] = xcalloc((size_t)a.n * padded(a.n), sizeof *a.sums[way]);
        fill_sums(l, axis, a.sums);
        return a;
    }
#pragma omp critical(fftw_planner)
    for (int way = 0; way < 2; way++)
        a.plan[way] = fftw_plan_many_r2r(1, &a.n, a.lines, T, NULL, 1, a.n, work, NULL, a.lines, 1,
                                         &basis_of(l, axis)->kind[way], FFTW_ESTIMATE);
    return a;
}

struct transform *transform_create(const struct lattice *l, double *T) {
    struct transform *t = xcalloc(1, sizeof *t);
    t->dim = l->dim;
    t->alike = alike(l);
    t->work = xcalloc((size_t)l->n[0] * (size_t)l->n[1], sizeof *t->work);
    t->axis[0] = prepare(l, 0, T, t->work);
    if (l->dim == 2) t->axis[1] = t->alike ? t->axis[0] : prepare(l, 1, T, t->work);
    return t;
}

void transform_free(struct transform *t) {
    for (int a = 0; a < (t->alike ? 1 : t->dim); a++)
        for (int way = 0; way < 2; way++) {
            free(t->axis[a].sums[way]);
#pragma omp critical(fftw_planner)
            if (t->axis[a].plan[way]) fftw_destroy_plan(t->axis[a].plan[way]);
        }
    free(t->work);
    free(t);
}

/* out[k][j] = sum_i sums[i][k] in[j][i], LINES x WIDTH of them at a time, i ascending. */
CLONES static void multiply(int n, int lines, const double *sums, const double *in, double *out) {
    size_t stride = padded(n), width = (size_t)n, height = (size_t)lines;
    for (size_t j = 0; j < height; j += LINES)
        for (size_t k = 0; k < width; k += WIDTH) {
            const double *row[LINES], *column = sums + k;
            for (size_t r = 0; r < LINES; r++) row[r] = in + (j + r < height ? j + r : j) * width;
            vector s0 = {0}, s1 = {0}, s2 = {0}, s3 = {0};
            for (size_t i = 0; i < width; i++, column += stride) {
                vector c = *(const vector *)column;
                s0 += c * row[0][i], s1 += c * row[1][i], s2 += c * row[2][i], s3 += c * row[3][i];
            }
            const vector sum[LINES] = {s0, s1, s2, s3};
            for (size_t c = 0; c < WIDTH && k + c < width; c++)
                for (size_t r = 0; r < LINES && j + r < height; r++) out[(k + c) * height + j + r] = sum[r][c];
        }
}

static void pass(const struct axis *a, int way, double *in, double *out) {
    if (a->plan[way])
        fftw_execute_r2r(a->plan[way], in, out);
    else
        multiply(a->n, a->lines, a->sums[way], in, out);
}

static void both_passes(struct transform *t, int way, double *T) {
    pass(&t->axis[0], way, T, t->work);
    if (t->dim == 2)
        pass(&t->axis[1], way, t->work, T);
    else
        memcpy(T, t->work, (size_t)t->axis[0].n * sizeof *T);
}

void transform_forward(struct transform *t, double *T) {
    both_passes(t, 0, T);
}

void transform_backward(struct transform *t, double *T) {
    both_passes(t, 1, T);
}
