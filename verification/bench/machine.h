#ifndef HEATLADDER_VERIFICATION_BENCH_MACHINE_H
#define HEATLADDER_VERIFICATION_BENCH_MACHINE_H

/* Where a benchmark ran, and by what it was compiled. */

struct bench_machine {
    char processor[120]; /* as the system names it; "unknown" where it does not */
    int cores;           /* that this process may use */
    int lanes;           /* doubles in the vectors of the lattice's sweeps */
    const char *compiler, *flags;
};

struct bench_machine bench_machine_here(void);

#endif
