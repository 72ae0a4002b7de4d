/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any list of points is read as points of the domain, or refused with a text: of a rod (first byte even), of a
 * rectangle. */
#include "verification/case/points.h"

#include "references/scene.h"
#include "solver/problem.h"
#include "solver/status.h"

#include "verification/unit/fuzz_file.h"

static void check(const struct points *points, const struct problem *p) {
    fuzz_require(points->dim == p->dim);
    for (size_t i = 0; i < points->n; i++)
        for (int a = 0; a < p->dim; a++) {
            fuzz_require(points->x[i][a] >= p->lo[a] && points->x[i][a] <= p->hi[a]);
            fuzz_require(!points->cell || points->cell[i][a] >= 0);
            int on_side = points->x[i][a] == p->lo[a] || points->x[i][a] == p->hi[a]; /* moved onto a side */
            fuzz_require(points->typed[i][a].length > 0 || on_side);
        }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static struct problem p[2];
    static const char *const scene[] = {"rod-gauss", "rect-manufactured"};
    struct failure why = {0};
    struct points points;
    if (size == 0) return 0;
    int k = data[0] & 1;
    if (!p[k].initial) {
        scene_defaults(scene_find(scene[k]), &p[k]);
        fuzz_require(scene_find(scene[k])->setup(&p[k], &why) == STATUS_OK);
    }
    FILE *in = fopen(fuzz_put(data + 1, size - 1), "r");
    fuzz_require(in != NULL);
    int status = points_read(in, "file", &p[k], &points, &why);
    fclose(in);
    fuzz_require(status == STATUS_OK || (status == STATUS_INPUT && why.text[0]));
    if (status) return 0;
    check(&points, &p[k]);
    points_free(&points);
    return 0;
}
