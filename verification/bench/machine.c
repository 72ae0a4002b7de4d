/* The header of a benchmark: processor from /proc/cpuinfo where there is one; the flags come from the Makefile. */
#include "verification/bench/machine.h"

#include "solver/options.h"

#include <omp.h>
#include <stdio.h>
#include <string.h>

#ifndef BENCH_FLAGS
#define BENCH_FLAGS "unknown"
#endif

static void name_processor(char *name, int size) {
    char line[256];
    FILE *in = fopen("/proc/cpuinfo", "r");
    snprintf(name, (size_t)size, "unknown");
    if (!in) return;
    while (fgets(line, sizeof line, in)) {
        const char *colon = strchr(line, ':');
        if (!colon || strncmp(line, "model name", 10) != 0) continue;
        snprintf(name, (size_t)size, "%.100s", colon + 2);
        name[strcspn(name, "\n")] = '\0';
        break;
    }
    fclose(in);
}

struct bench_machine bench_machine_here(void) {
    struct bench_machine m = {.cores = omp_get_num_procs(), .flags = BENCH_FLAGS};
#ifdef __clang__
    m.compiler = "clang " __VERSION__;
#else
    m.compiler = "gcc " __VERSION__;
#endif
    struct failure ignored; /* a width that the machine lacks was refused when the command line was read */
    if (options_lanes_forced(&m.lanes, &ignored) || m.lanes == 0) m.lanes = options_lanes_most();
    name_processor(m.processor, sizeof m.processor);
    return m;
}
