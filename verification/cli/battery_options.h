/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_CLI_BATTERY_OPTIONS_H
#define HEATLADDER_VERIFICATION_CLI_BATTERY_OPTIONS_H

/* Options of the verbs case and verify that choose and draw rows of the battery. */

#include "verification/cli/verb.h"
#include "verification/gates/battery.h"

struct battery_options {
    int order_word; /* order of the code in space: place in battery_order_words */
    enum profile profile;
    unsigned long seed; /* seed of the draw, default 1; 0: rows as written */
    int rungs;          /* rungs of each ladder; 0: as written */
};

static const char *const battery_order_words[] = {"2", "1", "4", NULL};

static inline int battery_order(const struct battery_options *b) {
    return battery_order_words[b->order_word][0] - '0';
}

static inline unsigned long battery_seed(const struct command *c, const struct battery_options *b) {
    return command_given(c, "seed") ? b->seed : 1;
}

/* Rows for a struct of this type, which has a struct battery_options `battery`. */
#define BATTERY_OPTIONS(type)                                                                                        \
    {"order",                                                                                                        \
     "P",                                                                                                            \
     "order of your code in space",                                                                                  \
     option_word,                                                                                                    \
     OPTION_PLACE(type, battery.order_word),                                                                         \
     .words = battery_order_words,                                                                                   \
     .needs = "solver results battery",                                                                              \
     .excludes = "gates"},                                                                                           \
        {"profile",                                                                                                  \
         "P",                                                                                                        \
         "rows of the battery (particles: for periodic codes without walls)",                                        \
         option_word,                                                                                                \
         OPTION_PLACE(type, battery.profile),                                                                        \
         .words = battery_profile_words,                                                                             \
         .needs = "solver results battery",                                                                          \
         .excludes = "gates"},                                                                                       \
        {"rungs",                                                                                                    \
         "N",                                                                                                        \
         "rungs of each ladder of the battery; further rungs halve dx",                                              \
         option_whole,                                                                                               \
         OPTION_PLACE(type, battery.rungs),                                                                          \
         4,                                                                                                          \
         12,                                                                                                         \
         .needs = "solver results battery gates"},                                                                   \
    {                                                                                                                \
        "seed", "N",                                                                                                 \
            "seed of the battery's parameters, mirror images and scales, default 1; 0: its rows as written",         \
            option_seed, OPTION_PLACE(type, battery.seed), .needs = "solver results battery", .excludes = "gates"    \
    }

#endif
