/* SPDX-License-Identifier: GPL-3.0-or-later */
/* --solver CMD: writes the case to a file, runs the command, and reads its answer from another file.  Both files are
 * in a temporary directory, removed on return, or in that of --keep. --results DIR: reads an existing answer. */
#include "verification/solve/program.h"

#include "references/scene.h"
#include "solver/field.h"
#include "solver/options.h"
#include "solver/problem.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/case/case_file.h"
#include "verification/solve/case_run.h"
#include "verification/solve/field_file.h"
#include "verification/case/results.h"
#include "verification/solve/process.h"
#include "verification/solve/runs.h"
#include "verification/solve/scratch.h"
#include "verification/text/output.h"
#include "verification/text/shell.h"
#include "verification/text/whole_file.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const char program_help[] =
    "--solver runs your program.  METHOD of a ladder is then only its name in tables:\n"
    "\n"
    "  heatladder ladder rod-step mine --solver './mine {case} {out}' --dx 0.2,0.1,0.05,0.025 --expect 1.9,2.1\n"
    "\n"
    "In the command, {case} becomes the path of the case file, {out} the path of the answer, {dx} the spacing\n"
    "and {NAME} the value of --vary NAME=A,B,C.  The program exits with 0, or with 77 if it cannot run the case.\n"
    "Its output goes to standard error.  Child processes are ended too, unless they called setsid; its files in\n"
    "TMPDIR are removed.\n"
    "\n"
    "The answer is a table: the line x,T (x,y,T in the plane, x,y,z,T in space), then one line for each point,\n"
    "separated by commas, semicolons or blanks.  The program chooses its points: they cover the domain at a\n"
    "spacing of dx.  A column w holds the weights of the norms; without it all points have the same weight.\n"
    "--columns 'x=X,y=Y,T=temp,w=volume' gives the names of the columns, or their numbers (T=3).  NumPy's .npy\n"
    "is read too (these columns, or named fields).  The lines `# seconds = S`, `# steps = N` and `# updates = N`\n"
    "of a table may give the time, steps and updates of the solve alone.\n"
    "\n"
    "--results DIR judges existing answers: DIR/SCENE/DX/out.csv (or out.npy, out.dat), beside\n"
    "the case files of `heatladder case SCENE --dx A,B,C --into DIR`.  With --set it first looks for\n"
    "DIR/SCENE/NAME=VALUE,.../DX, as `heatladder case --battery` writes it.  A file `status` there with the\n"
    "number 77 in place of an answer says that the program cannot run the case.\n";

/* Maps points and temperatures to other axes and units with mapping_to_scene and mapping_temperature_back, or
 * back. */
static void map_points(const struct mapping *m, struct field *f,
                       void (*place)(const struct mapping *m, int dim, const double *from, double to[DIM_MAX]),
                       double (*temperature)(const struct mapping *m, double T)) {
    for (size_t i = 0; i < f->n; i++) {
        double x[DIM_MAX], at[DIM_MAX];
        place(m, f->dim, field_place(f, i, x), at);
        field_put(f, i, at);
        f->T[i] = temperature(m, f->T[i]);
    }
}

static double *copy_of(const double *value, size_t n) {
    return value ? memcpy(xcalloc(n, sizeof *value), value, n * sizeof *value) : NULL;
}

struct field program_as_given(const struct program *g, const struct field *f, double *exact) {
    const struct mapping *m = &g->map;
    struct field copy = *f;
    for (int a = 0; a < f->dim; a++) copy.x[a] = copy_of(f->x[a], f->shape[0] ? (size_t)f->shape[a] : f->n);
    copy.T = copy_of(f->T, f->n), copy.weight = copy_of(f->weight, f->n);
    if (mapping_is_none(m)) return copy;
    map_points(m, &copy, mapping_to_case, mapping_temperature);
    for (size_t i = 0; i < f->n && exact; i++) exact[i] = mapping_temperature(m, exact[i]);
    return copy;
}

/* Reads the answer at `path`, which messages call `name`, and checks it against the case. */
static int read_answer(const struct program *g, const char *path, const char *name, const struct problem *p,
                       const struct options *o, struct field *f, struct failure *why) {
    const double d[DIM_MAX] = {o->dx, options_spacing(o, 1), o->dx};
    struct image image;
    mapping_image(&g->map, p, &image);
    if (field_file_read(path, name, &g->columns, &image, d, f, why)) return why->status;
    if (mapping_is_none(&g->map)) return STATUS_OK;
    map_points(&g->map, f, mapping_to_scene, mapping_temperature_back);
    for (int k = 0; k < 2; k++) f->range[k] = mapping_temperature_back(&g->map, f->range[k]);
    return STATUS_OK;
}

/* ---- Running a solver ---- */

/* Sets DIR/SCENE/SETTING/DX/RUNG below `root`.  Returns 0, or -1 if the path is too long. */
static int place_below(const struct program *g, const char *root, const struct scene *s, const struct options *o,
                       char dir[RESULTS_PATH]) {
    char of_scene[RESULTS_PATH];
    if (results_of_scene(root, s, g->setting, of_scene) || results_directory(of_scene, o->dx, dir)) return -1;
    if (*g->rung) words_add(dir, RESULTS_PATH, "/%s", g->rung);
    return 0;
}

static int kept_place(const struct program *g, const struct scene *s, const struct options *o, char dir[RESULTS_PATH],
                      struct failure *why) {
    if (place_below(g, g->keep, s, o, dir))
        return refuse(why, STATUS_INPUT, "--keep '%.100s...': too long a path", g->keep);
    if (!shell_is_plain(dir))
        return refuse(why, STATUS_INPUT, "--keep '%.200s': letters, digits and /._-+=,@%% are wanted in its name",
                      g->keep);
    char file[RESULTS_PATH + 8];
    snprintf(file, sizeof file, "%s/case", dir);
    return output_folders(file, why);
}

/* Sets the text of the case file, which the caller frees. */
static void case_text(const struct program *g, const struct scene *s, const struct problem *p,
                      const struct options *o, char **text) {
    size_t size;
    FILE *out = output_stream(text, &size);
    case_file_write(s, p, o, &(struct case_extra){g->label, &g->map, *g->vary ? g->vary : NULL, g->value, g->seed},
                    out);
    fclose(out);
}

static int run_in(const struct program *g, const struct options *o, const char *dir, const char *text,
                  const char *label, const struct scratch *scratch, int *code, struct failure *why) {
    char dx[40];
    struct output page;
    results_number(o->dx, dx);
    fputs(text, output_open(&page, "%s/case", dir));
    if (output_close(&page, 1, why)) return why->status;
    struct case_run run = {dir, g->solver, dx, *g->vary ? g->vary : NULL, g->value, label, g->timeout};
    return case_run(&run, scratch->dir, code, why);
}

/* Runs the case when its turn comes, in the directory of --keep or in a scratch directory; sets `dir` to it. */
static int run_in_turn(const struct program *g, const struct scene *s, const struct options *o, const char *text,
                       struct scratch *scratch, char dir[RESULTS_PATH], double *seconds, struct failure *why) {
    char dx[40], label[200], shown[240];
    int code = -1;
    results_number(o->dx, dx);
    snprintf(label, sizeof label, "%s dx=%s%s%s", s->name, dx, *g->rung ? " " : "", g->rung);
    snprintf(shown, sizeof shown, "%s%.200s", g->diagnosis ? "diagnosis of " : "", g->row ? g->row : label);
    enum runs_turn turn = RUNS_NOW;
    if (g->runs) turn = runs_begin(g->runs, g->keep ? dir : NULL, text, shown, dx, seconds, why);
    if (turn == RUNS_BEFORE || turn == RUNS_OVER) return why->status;
    const char *shared = turn == RUNS_NOW && g->keep ? dir : NULL;
    if (!shared) snprintf(dir, RESULTS_PATH, "%s", scratch->dir);
    double begin = omp_get_wtime();
    run_in(g, o, dir, text, label, scratch, &code, why);
    *seconds = omp_get_wtime() - begin;
    if (g->runs) runs_end(g->runs, shared, code, *seconds, why);
    return why->status;
}

static int solve_at(const struct program *g, const struct scene *s, const struct problem *p, const struct options *o,
                    struct scratch *scratch, struct field *f, struct failure *why) {
    char dir[RESULTS_PATH], path[RESULTS_PATH + 16], *text;
    struct image image;
    double seconds = 0;
    *why = (struct failure){0};
    mapping_image(&g->map, p, &image);
    if (case_file_check(&image.problem, o, why)) return why->status;
    if (g->keep && kept_place(g, s, o, dir, why)) return why->status;
    case_text(g, s, p, o, &text);
    int status = run_in_turn(g, s, o, text, scratch, dir, &seconds, why);
    free(text);
    if (status) return status;
    if (!results_answer(dir, path, sizeof path))
        return refuse(why, STATUS_NUMERICAL, "--solver: exit status 0, but no answer at {out}");
    if (read_answer(g, path, "{out}", p, o, f, why)) { /* the program failed */
        if (why->status != STATUS_UNSTABLE) why->status = STATUS_NUMERICAL;
        return why->status;
    }
    f->cost.seconds = seconds;
    return STATUS_OK;
}

int program_check(const struct program *g, struct failure *why) {
    if (!g->solver || (strstr(g->solver, "{case}") && strstr(g->solver, "{out}"))) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "--solver '%.200s': must contain {case} and {out}, which become paths",
                  g->solver);
}

static int solve_now(const struct program *g, const struct scene *s, const struct problem *p, const struct options *o,
                     struct field *f, struct failure *why) {
    struct scratch scratch;
    if (program_check(g, why)) return why->status;
    output_hold();
    int status = scratch_open(&scratch, why);
    if (!status) {
        status = solve_at(g, s, p, o, &scratch, f, why);
        scratch_close(&scratch);
    }
    output_release();
    return status;
}

/* ---- Reading existing answers ---- */

/* Refuses an answer to another case than the one asked for, if the case is beside it. */
static int check_case(const struct program *g, const char *dir, const struct scene *s, const struct problem *p,
                      const struct options *o, struct failure *why) {
    char path[RESULTS_PATH + 16], *text;
    struct rows kept;
    snprintf(path, sizeof path, "%s/case", dir);
    if (access(path, F_OK)) return STATUS_OK;
    int status = case_file_read(path, &kept, why);
    if (!status) {
        case_text(g, s, p, o, &text);
        status = case_file_compare(&kept, text, g->vary, why);
    }
    rows_free(&kept);
    return status;
}

static int are_same(const char *path, const char *other) {
    struct stat is, of;
    size_t size[2];
    if (stat(path, &is) || stat(other, &of) || is.st_size != of.st_size) return 0;
    char *bytes[] = {whole_file_at(path, &size[0]), whole_file_at(other, &size[1])};
    int same = bytes[0] && bytes[1] && size[0] == size[1] && memcmp(bytes[0], bytes[1], size[0]) == 0;
    for (int k = 0; k < 2; k++) free(bytes[k]);
    return same;
}

/* Refuses an answer that is also there for another spacing. */
static int check_copied(const struct program *g, const char *path, const struct scene *s, const struct options *o,
                        struct failure *why) {
    char dir[RESULTS_PATH], other[RESULTS_PATH + 16];
    struct options with = *o;
    struct numbers dx;
    struct failure ignored;
    if (results_of_scene(g->results, s, g->setting, dir) || results_list(dir, &dx, &ignored)) return STATUS_OK;
    for (int i = 0; i < dx.count; i++) {
        with.dx = dx.value[i];
        if (with.dx == o->dx || place_below(g, g->results, s, &with, dir)) continue;
        if (results_answer(dir, other, sizeof other) && are_same(path, other))
            return refuse(why, STATUS_INPUT, "%.200s: the same file as %.200s, which is the answer for dx = %g m",
                          path, other, with.dx);
    }
    return STATUS_OK;
}

static int solve_later(const struct program *g, const struct scene *s, const struct problem *p,
                       const struct options *o, struct field *f, struct failure *why) {
    char dir[RESULTS_PATH], path[RESULTS_PATH + 16];
    if (place_below(g, g->results, s, o, dir))
        return refuse(why, STATUS_INPUT, "--results '%.200s': too long a path", g->results);
    int answered = results_answer(dir, path, sizeof path), code = case_run_status(dir);
    if (code == STATUS_SKIPPED) return refuse(why, STATUS_SKIPPED, PROCESS_DECLINED);
    if (!answered && code > 0)
        return refuse(why, STATUS_NUMERICAL, "%.300s: the program ended with exit status %d (%.300s/log)", path, code,
                      dir);
    if (answered && check_copied(g, path, s, o, why)) return why->status;
    if (check_case(g, dir, s, p, o, why) || read_answer(g, path, path, p, o, f, why)) return why->status;
    f->cost.seconds = f->cost.step_seconds;
    return STATUS_OK;
}

int program_solve(const struct program *g, const struct scene *s, const struct problem *p, const struct options *o,
                  struct field *f, struct failure *why) {
    int status = (g->results ? solve_later : solve_now)(g, s, p, o, f, why);
    if (!status && isnan(f->cost.step_seconds)) f->cost.step_seconds = f->cost.seconds;
    return status;
}
