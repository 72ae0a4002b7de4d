/* --solver CMD: the case goes into a file, the command runs, and its answer comes back from another file.  Both lie
 * in a directory that is gone when the call returns, or in that of --keep.  --results DIR: the answer is there
 * already. */
#include "verification/foreign/program.h"

#include "references/scene.h"
#include "solver/field.h"
#include "solver/options.h"
#include "solver/problem.h"
#include "solver/status.h"
#include "verification/foreign/case_file.h"
#include "verification/foreign/field_file.h"
#include "verification/foreign/process.h"
#include "verification/foreign/results.h"
#include "verification/foreign/scratch.h"
#include "verification/text/atomic_file.h"
#include "verification/text/output.h"
#include "verification/text/words.h"

#include <errno.h>
#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const char program_help[] =
    "--solver lets any program stand in for METHOD, which is then just its name in tables:\n"
    "\n"
    "  heatladder ladder rod-step mine --solver './mine {case} {out}' --dx 0.2,0.1,0.05,0.025 --expect 1.9,2.1\n"
    "\n"
    "In the command {case} becomes the path of the case file, {out} the path that the program writes, {dx} the "
    "spacing\n"
    "and {NAME} what --vary NAME=A,B,C gives.  Its exit status is 0; 77 says that the case is not for it.  What it "
    "prints\n"
    "goes to standard error.  All that it starts ends with it, but for what makes a session of its own\n"
    "(setsid), and what it leaves in TMPDIR is removed.\n"
    "\n"
    "The answer is a table: the line x,T (x,y,T for a rectangle), then a line a point, at points of its own choosing "
    "that\n"
    "cover the domain, as many as dx asks for; commas, semicolons or blanks between.  A column w weights the norms, "
    "else\n"
    "all points count alike.  --columns 'x=X,y=Y,T=temp,w=volume' says what the columns are called (or their places: "
    "\n"
    "T=3).  Legacy ASCII VTK and VTU with ascii arrays are read too: their points, and the point data T.  Lines\n"
    "`# seconds = S`, `# steps = N` and `# updates = N` may tell what the solve itself took.\n"
    "\n"
    "--results DIR judges what is there already: DIR/SCENE/DX/out.csv (or out.vtk, out.vtu, out.dat), beside the "
    "case\n"
    "files that `heatladder case SCENE --dx A,B,C --into DIR` writes; DIR/SCENE/NAME=VALUE,.../DX where --set gives\n"
    "these values and that directory is there, as `heatladder case --battery` makes it.\n";

const char *const program_answers[] = {"out.csv", "out.vtk", "out.vtu", "out.dat", NULL};

int program_given(const struct program *g) {
    return g->solver || g->results;
}

/* Below DIR/SCENE/DX: what else differs from rung to rung. */
static void append_rung(const struct program *g, char path[RESULTS_PATH]) {
    size_t n = strlen(path);
    if (*g->rung) snprintf(path + n, RESULTS_PATH - n, "/%s", g->rung);
}

/* From the axes and temperatures of the case to those of the scene. */
static void map_back(const struct mapping *m, struct field *f) {
    double x[2], at[2];
    for (size_t i = 0; i < f->n; i++) {
        x[0] = f->x[i], x[1] = f->dim == 2 ? f->y[i] : 0;
        mapping_to_scene(m, f->dim, x, at);
        f->x[i] = at[0];
        if (f->dim == 2) f->y[i] = at[1];
        f->T[i] = mapping_temperature_back(m, f->T[i]);
    }
    for (int k = 0; k < 2; k++) f->range[k] = mapping_temperature_back(m, f->range[k]);
}

static double *copy_of(const double *value, size_t n) {
    return value ? memcpy(xcalloc(n, sizeof *value), value, n * sizeof *value) : NULL;
}

struct field program_as_given(const struct program *g, const struct field *f, double *exact) {
    const struct mapping *m = &g->map;
    struct field copy = *f;
    copy.x = copy_of(f->x, f->n), copy.y = copy_of(f->y, f->n);
    copy.T = copy_of(f->T, f->n), copy.weight = copy_of(f->weight, f->n);
    for (size_t i = 0; i < f->n && !mapping_is_none(m); i++) {
        double x[2] = {f->x[i], f->dim == 2 ? f->y[i] : 0}, at[2];
        mapping_to_case(m, f->dim, x, at);
        copy.x[i] = at[0];
        if (f->dim == 2) copy.y[i] = at[1];
        copy.T[i] = mapping_temperature(m, f->T[i]);
        if (exact) exact[i] = mapping_temperature(m, exact[i]);
    }
    return copy;
}

/* The answer at `path`, which messages call `name`: read and checked as the case has it. */
static int read_answer(const struct program *g, const char *path, const char *name, const struct problem *p,
                       double dx, struct field *f, struct failure *why) {
    struct image image;
    mapping_image(&g->map, p, &image);
    if (field_file_read(path, name, &g->columns, &image.problem, dx, f, why)) return why->status;
    if (!mapping_is_none(&g->map)) map_back(&g->map, f);
    return STATUS_OK;
}

/* ---- Now ---- */

struct place {
    char input[RESULTS_PATH + 16], output[RESULTS_PATH + 16], log[RESULTS_PATH + 16];
};

static void place_in(const char *dir, struct place *at) {
    snprintf(at->input, sizeof at->input, "%s/case", dir);
    snprintf(at->output, sizeof at->output, "%s/out.csv", dir);
    snprintf(at->log, sizeof at->log, "%s/log", dir);
}

static int make_directories(char *path, struct failure *why) {
    for (char *slash = strchr(path + 1, '/');; slash = strchr(slash + 1, '/')) {
        if (slash) *slash = '\0';
        int bad = mkdir(path, 0777) && errno != EEXIST, error = errno;
        if (slash) *slash = '/';
        if (bad) return refuse(why, STATUS_INPUT, "--keep: cannot make '%.300s': %s", path, strerror(error));
        if (!slash) return STATUS_OK;
    }
}

/* Where case and answer lie: the directory of --keep without an older answer, or the scratch. */
static int choose_place(const struct program *g, const struct scene *s, const struct options *o,
                        const struct scratch *scratch, struct place *at, struct failure *why) {
    char dir[RESULTS_PATH];
    if (g->keep) {
        char dx[40];
        results_number(o->dx, dx);
        if (strlen(g->keep) > RESULTS_PATH - 300)
            return refuse(why, STATUS_INPUT, "--keep '%.100s...': too long a path", g->keep);
        snprintf(dir, sizeof dir, "%s/%s/%s", g->keep, s->name, dx);
        append_rung(g, dir);
        if (!words_is_plain(dir))
            return refuse(why, STATUS_INPUT, "--keep '%.200s': letters, digits and /._-+=,@%% are wanted in its name",
                          g->keep);
        if (make_directories(dir, why)) return STATUS_INPUT;
    } else {
        snprintf(dir, sizeof dir, "%s", scratch->dir);
    }
    place_in(dir, at);
    if (g->keep && unlink(at->output) && errno != ENOENT)
        return refuse(why, STATUS_INPUT, "--keep: cannot replace '%.300s': %s", at->output, strerror(errno));
    return STATUS_OK;
}

static int write_case(const struct program *g, const struct scene *s, const struct problem *p,
                      const struct options *o, const char *path, struct failure *why) {
    struct output page;
    FILE *out = output_open(&page, "%s", path);
    case_file_write(s, p, o, &(struct case_extra){g->label, &g->map, *g->vary ? g->vary : NULL, g->value, g->seed},
                    out);
    return output_close(&page, 1, why);
}

/* The command with what is between braces replaced, to be freed; braces of any other word stay. */
static char *fill_in(const struct program *g, const struct options *o, const struct place *at) {
    char *text, dx[40];
    size_t size;
    results_number(o->dx, dx);
    const char *name[] = {"case", "out", "dx", *g->vary ? g->vary : NULL},
               *value[] = {at->input, at->output, dx, g->value};
    FILE *out = output_stream(&text, &size);
    for (const char *c = g->solver; *c; c++) {
        int found = -1;
        for (int i = 0; *c == '{' && i < 4 && name[i]; i++) {
            size_t n = strlen(name[i]);
            if (strncmp(c + 1, name[i], n) == 0 && c[n + 1] == '}') found = i;
        }
        if (found < 0) {
            fputc(*c, out);
        } else {
            fputs(value[found], out);
            c += strlen(name[found]) + 1;
        }
    }
    fclose(out);
    return text;
}

static int run_command(const struct program *g, const struct scene *s, const struct options *o,
                       const struct place *at, struct scratch *scratch, struct failure *why) {
    char dx[40], label[200];
    char *command = fill_in(g, o, at);
    results_number(o->dx, dx);
    snprintf(label, sizeof label, "%s dx=%s%s%s", s->name, dx, *g->rung ? " " : "", g->rung);
    struct process process = {.command = command, .label = label, .scratch = scratch, .timeout = g->timeout};
    if (g->keep && !(process.log = fopen(at->log, "w")))
        refuse(why, STATUS_INPUT, "--keep: cannot write '%.300s': %s", at->log, strerror(errno));
    else
        process_run(&process, why);
    if (process.log) fclose(process.log);
    free(command);
    return why->status;
}

static int solve_at(const struct program *g, const struct scene *s, const struct problem *p, const struct options *o,
                    struct scratch *scratch, struct field *f, struct failure *why) {
    struct place at;
    struct image image;
    *why = (struct failure){0};
    mapping_image(&g->map, p, &image);
    if (case_file_check(&image.problem, o->dx, why)) return why->status;
    if (choose_place(g, s, o, scratch, &at, why) || write_case(g, s, p, o, at.input, why)) return why->status;
    double begin = omp_get_wtime();
    int status = run_command(g, s, o, &at, scratch, why);
    double seconds = omp_get_wtime() - begin;
    if (status || read_answer(g, at.output, "{out}", p, o->dx, f, why)) return why->status;
    f->seconds = seconds;
    return STATUS_OK;
}

static int solve_now(const struct program *g, const struct scene *s, const struct problem *p, const struct options *o,
                     struct field *f, struct failure *why) {
    struct scratch scratch;
    if (!strstr(g->solver, "{case}") || !strstr(g->solver, "{out}"))
        return refuse(why, STATUS_INPUT, "--solver '%.200s': must hold {case} and {out}, which become paths",
                      g->solver);
    atomic_file_hold();
    int status = scratch_open(&scratch, why);
    if (!status) {
        status = solve_at(g, s, p, o, &scratch, f, why);
        scratch_close(&scratch);
    }
    atomic_file_release();
    return status;
}

/* ---- Later ---- */

static int solve_later(const struct program *g, const struct scene *s, const struct problem *p,
                       const struct options *o, struct field *f, struct failure *why) {
    char of_scene[RESULTS_PATH], dir[RESULTS_PATH], path[RESULTS_PATH + 16];
    if (results_of_scene(g->results, s, g->setting, of_scene) || results_directory(of_scene, o->dx, dir))
        return refuse(why, STATUS_INPUT, "--results '%.200s': too long a path", g->results);
    append_rung(g, dir);
    for (int i = 0; program_answers[i]; i++) {
        snprintf(path, sizeof path, "%s/%s", dir, program_answers[i]);
        if (access(path, F_OK) == 0) break;
        if (!program_answers[i + 1]) snprintf(path, sizeof path, "%s/%s", dir, program_answers[0]);
    }
    if (read_answer(g, path, path, p, o->dx, f, why)) return why->status;
    f->seconds = f->step_seconds;
    return STATUS_OK;
}

int program_solve(const struct program *g, const struct scene *s, const struct problem *p, const struct options *o,
                  struct field *f, struct failure *why) {
    int status = (g->results ? solve_later : solve_now)(g, s, p, o, f, why);
    if (!status && isnan(f->step_seconds)) f->step_seconds = f->seconds;
    return status;
}
