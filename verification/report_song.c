/* Song, Xing, Hou, Lu 2018 (Mathematics 6, 215), Tables 1-3 and Figures 1-5, measured again.
 *
 * Rows only: what each shows is a command line.  The paper does not print the times of Figure 1c, nor h and dt of the
 * Gaussian case; the notes say what was taken. */
#include "verification/report_song.h"

#include "verification/report_compare.h"
#include "verification/report_figure.h"

#include "solver/method.h"

#define ROD "--dx 0.1 --h 1.05 --stepper euler --dt 5e-5"
#define SQUARE "--dx 0.1 --h 1.1 --stepper euler --dt 0.001"
#define END                                                                                                          \
    { 0 }

static const struct report_compare tables[] = {
    {.table = "song_table1",
     .table_title = "Song 2018, Table 1: E of a rod with a discontinuous start, t = 5 s",
     .figure = "song_fig2a",
     .figure_title = "Song 2018, Figure 2a: convergence on the rod, discontinuous start",
     .scene = "rod-step",
     .choice =
         (const struct report_compare_choice[]){{"as published", "--h 1.05 --stepper euler --dt 5e-5"},
                                                {"no time error", "--h 1.05 --stepper exact"},
                                                {"h/dx 1.0", "--h 1.0 --stepper exact"},
                                                {"h/dx 1.1", "--h 1.1 --stepper exact"},
                                                {"quartic kernel", "--h 1.05 --kernel quartic --stepper exact"},
                                                {"Wendland kernel", "--h 1.05 --kernel wendland --stepper exact"},
                                                {"cell averages", "--h 1.05 --sampling cell --stepper exact"},
                                                END},
     .note = "NOTE1"},
    {.table = "song_table2",
     .table_title = "Song 2018, Table 2: E of a rod with a Gaussian start, t = 5 s",
     .figure = "song_fig2b",
     .figure_title = "Song 2018, Figure 2b: convergence on the rod, Gaussian start",
     .scene = "rod-gauss",
     .choice = (const struct report_compare_choice[]){{"as for Table 1", "--h 1.05 --stepper euler --dt 5e-5"},
                                                      {"no time error", "--h 1.05 --stepper exact"},
                                                      {"dt = 0.001 s", "--h 1.05 --stepper euler --dt 0.001"},
                                                      {"dt = 0.05 s", "--h 1.05 --stepper euler --dt 0.05"},
                                                      {"h/dx 1.0", "--h 1.0 --stepper exact"},
                                                      {"h/dx 1.1", "--h 1.1 --stepper exact"},
                                                      END},
     .note = "NOTE2"},
    {.table = "song_table3",
     .table_title = "Song 2018, Table 3: E of a square with a discontinuous start, t = 5 s",
     .figure = "song_fig5",
     .figure_title = "Song 2018, Figure 5: convergence on the square, discontinuous start",
     .scene = "square-step",
     .choice = (const struct report_compare_choice[]){{"as published", "--h 1.1 --stepper euler --dt 0.001"},
                                                      {"no time error", "--h 1.1 --stepper exact"},
                                                      {"h/dx 1.05", "--h 1.05 --stepper exact"},
                                                      {"h/dx 1.2", "--h 1.2 --stepper exact"},
                                                      {"quartic kernel", "--h 1.1 --kernel quartic --stepper exact"},
                                                      END},
     .note = "NOTE3"},
};

static const struct report_figure figures[] = {
    {"song_fig1a",
     "Song 2018, Figure 1a: the rod at the start",
     (const struct report_figure_series[]){{"exact", "reference rod-step --at 0 --time 0", REPORT_FIGURE_EXACT, 0},
                                           {"particles", "run rod-step so_ssph " ROD, REPORT_FIGURE_START, 0},
                                           END},
     {0}},
    {"song_fig1b",
     "Song 2018, Figure 1b: FO-SSPH and SO-SSPH on the rod, t = 5 s",
     (const struct report_figure_series[]){{"exact", "reference rod-step --at 0 --time 5", REPORT_FIGURE_EXACT, 0},
                                           {"fo_ssph", "run rod-step fo_ssph " ROD, REPORT_FIGURE_POINTS, 0},
                                           {"so_ssph", "run rod-step so_ssph " ROD, REPORT_FIGURE_POINTS, 0},
                                           END},
     {0}},
    {"song_fig1c",
     "Song 2018, Figure 1c: SO-SSPH on the rod at four times",
     (const struct report_figure_series[]){
         {"exact 0.5", "reference rod-step --at 0 --time 0.5", REPORT_FIGURE_EXACT, 0},
         {"exact 1", "reference rod-step --at 0 --time 1", REPORT_FIGURE_EXACT, 0},
         {"exact 2.5", "reference rod-step --at 0 --time 2.5", REPORT_FIGURE_EXACT, 0},
         {"exact 5", "reference rod-step --at 0 --time 5", REPORT_FIGURE_EXACT, 0},
         {"so_ssph 0.5", "run rod-step so_ssph " ROD " --t-end 0.5", REPORT_FIGURE_POINTS, 0},
         {"so_ssph 1", "run rod-step so_ssph " ROD " --t-end 1", REPORT_FIGURE_POINTS, 0},
         {"so_ssph 2.5", "run rod-step so_ssph " ROD " --t-end 2.5", REPORT_FIGURE_POINTS, 0},
         {"so_ssph 5", "run rod-step so_ssph " ROD " --t-end 5", REPORT_FIGURE_POINTS, 0}},
     {0}},
    {"song_fig1d",
     "Song 2018, Figure 1d: FTCS on the rod, with and without heat fluxes, t = 5 s",
     (const struct report_figure_series[]){
         {"exact", "reference rod-step --at 0 --time 5", REPORT_FIGURE_EXACT, 0},
         {"ftcs_flux", "run rod-step ftcs_flux --dx 0.1 --dt 5e-5", REPORT_FIGURE_POINTS, 0},
         {"ftcs direct", "run rod-step ftcs --dx 0.1 --dt 5e-5", REPORT_FIGURE_POINTS, 0},
         END},
     {0}},
    {"song_fig3a",
     "Song 2018, Figure 3a: the square at the start",
     (const struct report_figure_series[]){{"particles", "run square-step so_ssph " SQUARE, REPORT_FIGURE_START, 0},
                                           END},
     {0}},
    {"song_fig3b",
     "Song 2018, Figure 3b: FO-SSPH and SO-SSPH on the square along y = 0.05 m, t = 5 s",
     (const struct report_figure_series[]){
         {"exact", "reference square-step --at 0,0.05 --time 5", REPORT_FIGURE_EXACT, 0},
         {"fo_ssph", "run square-step fo_ssph " SQUARE, REPORT_FIGURE_CUT, 0.05},
         {"so_ssph", "run square-step so_ssph " SQUARE, REPORT_FIGURE_CUT, 0.05},
         END},
     {0}},
    {"song_fig4",
     "Song 2018, Figure 4a-e: isotherms of SO-SSPH on the square",
     (const struct report_figure_series[]){
         {"1 s", "run square-step so_ssph " SQUARE " --t-end 1", REPORT_FIGURE_ISOTHERMS, 0},
         {"2 s", "run square-step so_ssph " SQUARE " --t-end 2", REPORT_FIGURE_ISOTHERMS, 0},
         {"3 s", "run square-step so_ssph " SQUARE " --t-end 3", REPORT_FIGURE_ISOTHERMS, 0},
         {"4 s", "run square-step so_ssph " SQUARE " --t-end 4", REPORT_FIGURE_ISOTHERMS, 0},
         {"5 s", "run square-step so_ssph " SQUARE " --t-end 5", REPORT_FIGURE_ISOTHERMS, 0},
         END},
     {1, 2, 9}},
    {"song_fig4f",
     "Song 2018, Figure 4f: SO-SSPH on the square along y = 0.05 m",
     (const struct report_figure_series[]){
         {"exact 1", "reference square-step --at 0,0.05 --time 1", REPORT_FIGURE_EXACT, 0},
         {"exact 2", "reference square-step --at 0,0.05 --time 2", REPORT_FIGURE_EXACT, 0},
         {"exact 3", "reference square-step --at 0,0.05 --time 3", REPORT_FIGURE_EXACT, 0},
         {"exact 5", "reference square-step --at 0,0.05 --time 5", REPORT_FIGURE_EXACT, 0},
         {"so_ssph 1", "run square-step so_ssph " SQUARE " --t-end 1", REPORT_FIGURE_CUT, 0.05},
         {"so_ssph 2", "run square-step so_ssph " SQUARE " --t-end 2", REPORT_FIGURE_CUT, 0.05},
         {"so_ssph 3", "run square-step so_ssph " SQUARE " --t-end 3", REPORT_FIGURE_CUT, 0.05},
         {"so_ssph 5", "run square-step so_ssph " SQUARE " --t-end 5", REPORT_FIGURE_CUT, 0.05}},
     {0}},
};

int report_song_write(const char *dir, struct failure *why) {
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++)
        if (report_compare_write(&tables[i], dir, why)) return why->status;
    for (size_t i = 0; i < sizeof figures / sizeof *figures; i++)
        if (report_figure_write(&figures[i], dir, why)) return why->status;
    return STATUS_OK;
}
