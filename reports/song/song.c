/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Song, Xing, Hou, Lu 2018 (Processes 6, 215): Tables 1-3 and Figures 1-5, measured again.
 *
 * This file has rows only; each row is a command line.  The paper does not print the times of Figure 1c, nor h and
 * dt of the Gaussian case; the notes state the values used. */
#include "reports/song/song.h"

#include "reports/figure/compare.h"
#include "reports/figure/figure.h"
#include "reports/ledger/claim.h"

#include "solver/method.h"

#include <math.h>
#include <string.h>

#define ROD "--dx 0.1 --h 1.05 --stepper euler --dt 5e-5"
#define SQUARE "--dx 0.1 --h 1.1 --stepper euler --dt 0.001"
#define CURVE(name, command) FIGURE_FIELD(name, command, FIGURE_POINTS, 0)
#define EXACT(name, command) FIGURE_FIELD(name, "reference " command, FIGURE_EXACT, 0)
#define CUT(name, command) FIGURE_FIELD(name, command " " SQUARE, FIGURE_CUT, 0.05)
/* At a time in s */
#define ROD_RUN(t) CURVE("so_ssph " #t, "run rod-step so_ssph " ROD " --t-end " #t)
#define ROD_EXACT(t) EXACT("exact " #t, "rod-step --at 0 --time " #t)
#define CUT_RUN(t) CUT("so_ssph " #t, "run square-step so_ssph --t-end " #t)
#define CUT_EXACT(t) EXACT("exact " #t, "square-step --at 0,0.05 --time " #t)
#define ISOTHERMS(t) FIGURE_FIELD(#t " s", "run square-step so_ssph " SQUARE " --t-end " #t, FIGURE_ISOTHERMS, 0)
#define END                                                                                                          \
    { 0 }

#define CHOICES (const struct compare_choice[])

static const struct compare tables[] = {
    {.table = "song_table1",
     .table_title = "Song 2018, Table 1: E of a rod with a discontinuous start, t = 5 s",
     .figure = "song_fig2a",
     .figure_title = "Song 2018, Figure 2a: convergence on the rod, discontinuous start, t = 5 s",
     .scene = "rod-step",
     .choice = CHOICES{{"as published", "--h 1.05 --stepper euler --dt 5e-5", 0, 0},
                       {"no time error", "--h 1.05 --stepper exact", 0, 0},
                       {"walls of fixed ghosts", "--h 1.05 --stepper euler --dt 5e-5 --walls fixed", 0, 0},
                       {"h/dx 1.0", "--h 1.0 --stepper exact", 0, 0},
                       {"h/dx 1.1", "--h 1.1 --stepper exact", 0, 0},
                       {"quartic kernel", "--h 1.05 --kernel quartic --stepper exact", 0, 0},
                       {"Wendland kernel", "--h 1.05 --kernel wendland --stepper exact", 0, 0},
                       END},
     .note = {"Particles are midway between the lattice's nodes, so that the jump is midway between two of them, and "
              "walls are mirrored. E is taken against the infinite-line form (eq. 45), as in the paper; the last "
              "column of the first table has it against the solution between walls: 0.2 % apart in SO-SSPH at dx = "
              "0.01, and not in the printed digits from dx = 0.05 on.",
              "Cubic kernel and h/dx = 1.05 are confirmed: another kernel or h/dx moves the whole SO-SSPH row.",
              "FO-SSPH at dx = 0.5 is a matter of the walls: its stencil reaches four of the eight particles. With "
              "ghosts that hold the wall's temperature the printed number comes out.",
              "SO-SSPH at dx = 0.01 and 0.02: Euler's own error at dt = 5e-5, -(dt/2) kappa^2 d4T/dx4, takes 1.9 % "
              "and 0.5 % off E, so that \"sufficiently small\" (section 5.1) does not hold at the finest spacings. "
              "Without any time error the printed digits come out to 0.1 %: the paper's run had a smaller time error "
              "than its dt gives.",
              NULL}},
    {.table = "song_table2",
     .table_title = "Song 2018, Table 2: E of a rod with a Gaussian start, t = 5 s",
     .figure = "song_fig2b",
     .figure_title = "Song 2018, Figure 2b: convergence on the rod, Gaussian start, t = 5 s",
     .scene = "rod-gauss",
     .choice = CHOICES{{"as for Table 1", "--h 1.05 --stepper euler --dt 5e-5", 0, 0},
                       {"no time error", "--h 1.05 --stepper exact", 0, 0},
                       {"dt = 0.001 s", "--h 1.05 --stepper euler --dt 0.001", 0, 0},
                       {"dt = 0.01 s", "--h 1.05 --stepper euler --dt 0.01", 0, 0},
                       {"h/dx 1.0", "--h 1.0 --stepper exact", 0, 0},
                       {"h/dx 1.1", "--h 1.1 --stepper exact", 0, 0},
                       {"exact solution to 6 decimals", "--h 1.05 --stepper euler --dt 5e-5", 6, 0},
                       {"clock 3e-4 s short", "--h 1.05 --stepper exact --t-end 4.9997", 0, 3e-4},
                       END},
     .note =
         {"The paper prints neither h nor dt here; those of Table 1 are taken.",
          "h/dx = 1.05 is confirmed by dx = 0.25 to 1: within 1 %.",
          "No time step explains dx = 0.1. Euler's error has the opposite sign of the error in space, so that every "
          "dt > 0 takes from E, while the printed numbers are above the run without any time error.",
          "The gap is about 5e-7 at every dx and for both methods. Rounding the exact solution to six "
          "decimals, as in a table of values written to a file, adds that much: 1 % is then left at dx = 0.1. So "
          "does a clock that ends 3e-4 s early. Both are fits of one number to two; neither is an explanation.",
          NULL}},
    {.table = "song_table3",
     .table_title = "Song 2018, Table 3: E of a square with a discontinuous start, t = 5 s",
     .figure = "song_fig5",
     .figure_title = "Song 2018, Figure 5: convergence on the square, discontinuous start, t = 5 s",
     .scene = "square-step",
     .choice = CHOICES{{"as published", "--h 1.1 --stepper euler --dt 0.001", 0, 0},
                       {"no time error", "--h 1.1 --stepper exact", 0, 0},
                       {"walls of fixed ghosts", "--h 1.1 --stepper euler --dt 0.001 --walls fixed", 0, 0},
                       {"dt = 0.01 s", "--h 1.1 --stepper euler --dt 0.01", 0, 0},
                       {"h/dx 1.05", "--h 1.05 --stepper exact", 0, 0},
                       {"h/dx 1.2", "--h 1.2 --stepper exact", 0, 0},
                       {"quartic kernel", "--h 1.1 --kernel quartic --stepper exact", 0, 0},
                       END},
     .note = {"FO-SSPH comes out to the printed digits but at dx = 0.5, where its stencil reaches half of the domain "
              "and the walls decide: ghosts that hold the wall's temperature take the difference down by a quarter.",
              "SO-SSPH comes out at dx = 0.25 and 0.5; at 0.125 and 0.1 the printed numbers are 1.7 % and 4 % lower. "
              "Only a time step ten times the printed one brings all four within 1 %: Euler's error takes most from "
              "the finest. But then 0.25 is 0.5 % low where it was exact, so that this is no proof.",
              NULL}},
};

static const struct figure figures[] = {
    {"song_fig1b", "Song 2018, Figure 1b: FO-SSPH and SO-SSPH on the rod, t = 5 s",
     (const struct figure_series[]){EXACT("exact", "rod-step --at 0 --time 5"),
                                    CURVE("fo_ssph", "run rod-step fo_ssph " ROD),
                                    CURVE("so_ssph", "run rod-step so_ssph " ROD), END}},
    {"song_fig1c", "Song 2018, Figure 1c: SO-SSPH on the rod at four times",
     (const struct figure_series[]){ROD_EXACT(0.5), ROD_EXACT(1), ROD_EXACT(2.5), ROD_EXACT(5), ROD_RUN(0.5),
                                    ROD_RUN(1), ROD_RUN(2.5), ROD_RUN(5), END}},
    {"song_fig1d", "Song 2018, Figure 1d: FTCS on the rod, with and without heat fluxes, t = 5 s",
     (const struct figure_series[]){EXACT("exact", "rod-step --at 0 --time 5"),
                                    CURVE("ftcs_flux", "run rod-step ftcs_flux --dx 0.1 --dt 5e-5"),
                                    CURVE("ftcs direct", "run rod-step ftcs --dx 0.1 --dt 5e-5"), END}},
    {"song_fig3b", "Song 2018, Figure 3b: FO- and SO-SSPH on the square, y = 0.05 m, t = 5 s",
     (const struct figure_series[]){EXACT("exact", "square-step --at 0,0.05 --time 5"),
                                    CUT("fo_ssph", "run square-step fo_ssph"),
                                    CUT("so_ssph", "run square-step so_ssph"), END}},
    {"song_fig4", "Song 2018, Figure 4a-e: isotherms of SO-SSPH on the square",
     (const struct figure_series[]){ISOTHERMS(1), ISOTHERMS(2), ISOTHERMS(3), ISOTHERMS(4), ISOTHERMS(5), END}},
    {"song_fig4f", "Song 2018, Figure 4f: SO-SSPH on the square, y = 0.05 m",
     (const struct figure_series[]){CUT_EXACT(1), CUT_EXACT(2), CUT_EXACT(3), CUT_EXACT(4), CUT_EXACT(5), CUT_RUN(1),
                                    CUT_RUN(2), CUT_RUN(3), CUT_RUN(4), CUT_RUN(5), END}},
    END};

/* "TABLE": every error of the table, run again by the paper's protocol. */
void song_table(struct claims_measured *m) {
    const struct compare *of = tables;
    double worst = 1;
    struct published t;
    int held = 0;
    while (strcmp(of->table, m->row->argument) != 0) of++;
    if (claim_published(&t, m, of->table)) return;
    for (int r = 0; r < t.rows; r++) claim_quote(m, &t, r);
    for (int k = 0; k < t.rows * t.columns; k++) {
        int r = k / t.columns, i = k % t.columns;
        struct result run;
        if (claim_result(&run, m, "run %s %s %s --dx %s", of->scene, t.method[r], of->choice->options, t.where[i]))
            return;
        double ratio = run.error[NORM_L1] / t.value[r][i];
        int digits = fabs(published_units(t.cell[r][i], run.error[NORM_L1])) <= 1,
            near = digits || fabs(ratio - 1) <= 0.02;
        if (!near) claim_number(m, ratio, "", "measured over printed, %s at dx = %s", t.method[r], t.where[i]);
        if (!digits && !(fabs(ratio - 1) <= fabs(worst - 1))) worst = ratio;
        held += near;
    }
    claim_number(m, t.rows * t.columns, "", "errors compared");
    claim_number(m, held, "", "within 2 %% or a unit of the last digit");
    claim_number(m, worst, "", "worst ratio of those more than a unit of the last digit off");
    claim_decide(m, fabs(worst - 1) <= 0.10, held == t.rows * t.columns,
                 "every error within 2 %% or one unit of its last digit; within 10 %% leaves a choice open");
}

int song_write(const char *dir, struct failure *why) {
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++)
        if (compare_write(&tables[i], dir, why)) return why->status;
    return figure_write_all(figures, dir, why);
}
