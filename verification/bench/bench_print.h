/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_BENCH_BENCH_PRINT_H
#define HEATLADDER_VERIFICATION_BENCH_BENCH_PRINT_H

#include <stdio.h>

struct bench_scene;
struct json;

/* Text: the machine; for a scene the Pareto fronts, the failures and what does not apply. */
void bench_print_machine(FILE *out);
void bench_print_scene(const struct bench_scene *b, FILE *out);

/* Members of an object that is open. */
void bench_print_machine_json(struct json *j);
void bench_print_scene_json(const struct bench_scene *b, struct json *j);

/* The data of the charts as CSV: one block per candidate, then the two fronts. */
void bench_print_data(const struct bench_scene *b, FILE *out);

#endif
