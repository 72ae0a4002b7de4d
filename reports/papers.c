/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The statements of all papers. */
#include "reports/papers.h"

#include "reports/operators/operators.h"
#include "reports/pamplona/pamplona.h"
#include "reports/song/song.h"

#include <math.h>

#define CLAIM(id, source, published, measure, argument, expected, why)                                               \
    {id, source, published, measure, argument, CLAIMS_##expected, why, NULL},
#define READ(id, source, published, rule, expected, why, ...)                                                        \
    {id,        source,                                                                                              \
     published, claims_read,                                                                                         \
     rule,      CLAIMS_##expected,                                                                                   \
     why,       (const struct claims_reading[]){__VA_ARGS__, {0}}},
#define SHOWN(...)                                                                                                   \
    { CLAIMS_SHOWN, 0, __VA_ARGS__, 0, 0 }
#define STATED(...)                                                                                                  \
    { CLAIMS_STATED, 0, __VA_ARGS__ }
#define WIDER(...)                                                                                                   \
    { CLAIMS_WIDER, 0, __VA_ARGS__ }
#define STATED_OF(of, ...)                                                                                           \
    { CLAIMS_STATED, of, __VA_ARGS__ }
#define WIDER_OF(of, ...)                                                                                            \
    { CLAIMS_WIDER, of, __VA_ARGS__ }
#define STATED_ORDER(p, name, words) STATED("order " name, "", "ladder " words, "order", p - 0.1, p + 0.1)
#define WIDER_ORDER(p, name, words) WIDER("order " name, "", "ladder " words, "order", p - 0.1, p + 0.1)
#define ORDERS(p)                                                                                                    \
    "an order of " #p " +- 0.1 by the rule of the gates in the first setting (as published) and in the others, if "  \
    "any"
const struct claims_row papers_claims[] = {
#include "reports/song/song.def"
#include "reports/pamplona/pamplona.def"
#include "reports/operators/others.def"
    {0}};
