/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help, printed from the tables that also parse the arguments, so that the two cannot differ. */
#include "verification/cli/help.h"

#include "solver/words.h"
#include "verification/case/case_file.h"
#include "verification/solve/program.h"
#include "verification/cli/verb.h"

#include "version.inc"

#include <string.h>

static const char columns_help[] =
    "LIST is one or more of these, separated by commas (SI units):\n"
    "  temperature         the exact solution; nan where it has no value (a corner of two different temperatures)\n"
    "  error_bound         bound of its error by truncation and rounding\n"
    "  flux_x flux_y flux_z   -k_x dT/dx, ..., at a time > 0; at an interface, of the upper material\n"
    "  initial             the initial temperature; on a jump, the value of the closed piece\n"
    "  initial_mean        its average over the cell around the point, clipped to the body; columns dx, dy and dz "
    "of\n"
    "                      the points give the extents of the cell (without dy: dy = dx), else --dx for all.  Where\n"
    "                      two materials share the cell, the temperature that keeps its heat: the integral of\n"
    "                      rho_c T over that of rho_c\n"
    "  source k_x k_y k_z rho_c   of the equation; at an interface, of the upper material\n"
    "  wall                three columns, wall_kind, wall_value and wall_b.  Kind 0: not on a side; 1 (Dirichlet):\n"
    "                      T = value; 2 (Neumann): k dT/dn = value, the flux into the body; 3 (Robin):\n"
    "                      k dT/dn = b (value - T).  In a corner: the side of the lowest kind; the mean of\n"
    "                      different temperatures; else the first of the sides across x, y, z\n"
    "  nearest             the nearest wall: its nearest point and outward normal there (nearest_x, nearest_y,\n"
    "                      normal_x, normal_y), the distance, and kind, value and b as for wall; nan without walls\n"
    "  wall_x wall_y wall_z   as wall, for the sides across x, y or z only: a corner gives all\n"
    "--points: CSV with the header x (x,y or x,y,z) and one point a line; other columns are ignored; - is standard "
    "input.\n"
    "Each line of the answer repeats the coordinates as typed (a point within 1e-9 extents of a side moves onto\n"
    "it), then `time` if several are given (all points of the first time come first), then the columns with 17\n"
    "digits.  Columns that do not depend on time need no --time; source, wall and nearest need it in a scene\n"
    "where they change.\n"
    "\n"
    "Initial values for your code:\n"
    "  your unknowns are       use             at                          with the cell\n"
    "  cell averages           initial_mean    the centre of each cell     that cell\n"
    "  values at nodes         initial_mean    each node                   half-way to its neighbours\n"
    "  particles               initial_mean    each particle               its volume, m/rho\n"
    "  nodes of elements       initial         each node, or, where data   -\n"
    "                                          jump, the points of the\n"
    "                                          quadrature of rho_c T v\n"
    "An interface or a jump may cut a cell.  At a node or corner on a side, the cell is its part in the domain.\n";

enum { WIDE = 100 }; /* characters per line */

const char help_version[] = VERSION_TEXT;

const char help_about[] =
    "heatladder VERB --help lists the options of a verb.\n"
    "Environment:\n"
    "  HEATLADDER_LANES  vector width of the hot loops in doubles, 2, 4 or 8 (default: the widest of the machine);\n"
    "                    results are the same to the bit for every width\n"
    "  HEATLADDER        path of this program, set for the program of --solver unless you set it\n"
    "  TMPDIR            directory of temporary files, default /tmp; the program of --solver gets its own\n"
    "  NO_COLOR          if set: no colours on a terminal\n"
    "  GITHUB_ACTIONS    if set: verify also prints failing gates as annotations\n"
    "Exit status: 0 all passed, 1 a gate failed, 2 bad usage or input, 3 numerical failure, 4 inconclusive,\n"
    "  77 skipped: the program cannot run the case.\n";

/* A word or two, then a text in lines of at most `WIDE` letters that begin below each other. */
static void put_entry(FILE *out, const char *lead, int indent, const char *text) {
    int column = fprintf(out, "%-*s", indent, lead);
    while (*text) {
        int length = (int)strcspn(text, " ");
        if (column > indent && column + 1 + length > WIDE) column = fprintf(out, "\n%*s", indent, "") - 1;
        column += fprintf(out, "%s%.*s", column > indent ? " " : "", length, text);
        text += length + (text[length] == ' ');
    }
    fputc('\n', out);
}

void help_program(FILE *out) {
    fprintf(out, "heatladder: verification and benchmarks for solvers of transient heat conduction\n\n");
    for (int i = 0; verbs[i]; i++) {
        char lead[40];
        snprintf(lead, sizeof lead, "  heatladder %s ", verbs[i]->syntax->name);
        put_entry(out, lead, 24, verbs[i]->about);
    }
    fprintf(out, "\n%s", help_about);
}

void help_verb(const struct verb *v, FILE *out) {
    const struct option *list[VERB_ROWS];
    const struct command_syntax *s = v->syntax;
    int lists = 0, indent = 0, n = verb_options(v, list);
    fprintf(out, "heatladder %s%s%s [options]\n\n", s->name, *s->positionals ? " " : "", s->positionals);
    put_entry(out, "  ", 2, v->about);
    fputc('\n', out);
    for (int i = 0; i < n; i++) {
        int width = 7 + (int)strlen(list[i]->name) + (list[i]->value ? (int)strlen(list[i]->value) : 0);
        if (width > indent) indent = width;
    }
    for (int i = 0; i < n; i++) {
        const struct option *o = list[i];
        char words[200] = "", lead[80], text[600];
        if (o->words) words_join(o->words, words, sizeof words), lists = 1;
        snprintf(lead, sizeof lead, "  --%s %s", o->name, o->value ? o->value : "");
        snprintf(text, sizeof text, "%s%s%s%s", o->about, *words ? ": " : "", words,
                 words_among(s->required, o->name) ? " (required)" : "");
        put_entry(out, *o->name ? lead : "", *o->name ? indent : 0, text);
    }
    if (lists) fprintf(out, "\nThe first of listed words is the default.\n");
    if (command_option(s, v->own, "solver")) fprintf(out, "\n%s\n%s", program_help, case_file_help);
    if (command_option(s, v->own, "what")) fprintf(out, "\n%s", columns_help);
}
