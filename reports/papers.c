/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The statements of all papers. */
#include "reports/papers.h"

#include "reports/operators/operators.h"
#include "reports/pamplona/pamplona.h"
#include "reports/song/song.h"

#define CLAIM(id, source, published, measure, argument, expected, why)                                               \
    {id, source, published, measure, argument, CLAIMS_##expected, why},
const struct claims_row papers_claims[] = {
#include "reports/song/song.def"
#include "reports/pamplona/pamplona.def"
#include "reports/operators/others.def"
    {0}};
#undef CLAIM
