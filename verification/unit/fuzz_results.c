/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any file is read as a field of finite numbers that covers the domain, or refused with a reason: for a rod (first
 * byte even) or a rectangle, with or without a map of columns (second bit). */
#include "verification/solve/field_file.h"

#include "references/mapping.h"
#include "references/scene.h"
#include "solver/field.h"
#include "solver/problem.h"
#include "solver/status.h"
#include "verification/case/samples.h"

#include "verification/unit/fuzz_file.h"

#include <math.h>

static void check(const struct field *f, int dim) {
    fuzz_require(f->n > 0 && f->T);
    for (int a = 0; a < dim; a++) fuzz_require(f->x[a] != NULL);
    for (size_t i = 0; i < f->n; i++) {
        for (int a = 0; a < dim; a++) fuzz_require(isfinite(f->x[a][i]));
        fuzz_require(isfinite(f->T[i]));
        fuzz_require(!f->weight || f->weight[i] >= 0);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static struct problem p[2];
    static const char *const scene[] = {"rod-gauss", "rect-manufactured"};
    static const double dx[] = {10, 0.35}; /* three cells along, few enough for a short file to cover */
    struct failure why = {0};
    struct column_map c = {0};
    struct field f;
    if (size == 0) return 0;
    int k = data[0] & 1;
    if (!p[k].initial) {
        scene_defaults(scene_find(scene[k]), &p[k]);
        fuzz_require(scene_find(scene[k])->setup(&p[k], &why) == STATUS_OK);
    }
    if (data[0] & 2) fuzz_require(samples_columns_read(k ? "x=a,y=b,T=c,w=d" : "x=2,T=1", &c, &why) == STATUS_OK);
    const struct image image = {.problem = p[k]};
    int status =
        field_file_read(fuzz_put(data + 1, size - 1), "file", &c, &image, (double[2]){dx[k], dx[k]}, &f, &why);
    const int is_refused = status == STATUS_INPUT || status == STATUS_NUMERICAL || status == STATUS_UNSTABLE;
    fuzz_require(status == STATUS_OK || (is_refused && why.text[0]));
    if (status) return 0;
    check(&f, k + 1);
    field_free(&f);
    return 0;
}
