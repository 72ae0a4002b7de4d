/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any case file beside an answer gives a scene's parameters, which make a problem or are refused, or is refused
 * itself. The first byte names the scene. */
#include "verification/case/case_file.h"
#include "verification/case/results.h"

#include "references/scene.h"
#include "solver/problem.h"
#include "solver/status.h"

#include "verification/unit/fuzz_file.h"

#include <math.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct failure why = {0};
    struct problem p = {0};
    struct mapping map = {0};
    double aspect = 0;
    struct results_known known = {.p = &p, .map = &map, .aspect = &aspect};
    int count = 0;
    if (size == 0) return 0;
    while (scenes[count]) count++;
    const struct scene *s = scenes[data[0] % count];
    struct rows r;
    scene_defaults(s, &p);
    int status = case_file_read(fuzz_put(data + 1, size - 1), &r, &why);
    if (!status) status = results_case_params(&r, s, &known, &why);
    rows_free(&r);
    fuzz_require(status == STATUS_OK || (status == STATUS_INPUT && why.text[0]));
    if (status) return 0;
    status = s->setup(&p, &why);
    fuzz_require(status == STATUS_OK || (status == STATUS_INPUT && why.text[0]));
    if (!status)
        for (int a = 0; a < p.dim; a++) fuzz_require(isfinite(p.lo[a]) && p.hi[a] > p.lo[a]);
    return 0;
}
