/* --solver CMD: the case goes into a file, the command runs, and its answer comes back from another file.
 *
 * Both files lie in a directory of their own, which is gone when the call returns.  Interrupts wait until then: the
 * command gets them (it shares the terminal), ends, and what it left is removed before this program ends too. */
#include "verification/run/external.h"

#include "verification/run/external_case.h"
#include "verification/run/external_csv.h"
#include "verification/run/experiment.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <omp.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

const char external_help[] =
    "--solver lets any program stand in for METHOD, which is then just its name in tables:\n"
    "\n"
    "  heatladder ladder rod-step mine --solver './mine {case} {out}' --dx 0.2,0.1,0.05,0.025 --expect 1.9,2.1\n"
    "\n"
    "{case} becomes the path of a file with one `key = value` a line (SI, several values with commas between):\n"
    "  scene, label, dim        the names on the command line; 1 for a rod, 2 for a rectangle\n"
    "  param_NAME               every parameter of the scene (heatladder list scenes tells what each means)\n"
    "  lo, hi                   the domain, m: along x, and along y\n"
    "  materials, interface     1; or 2, the second at x >= interface, m\n"
    "  k_x, k_y, rho_c          W/(m K), J/(m^3 K): of each material\n"
    "  side_x_lo, side_x_hi, side_y_lo, side_y_hi\n"
    "                           dirichlet, K or neumann, W/m^2 into the body; one value, or nine evenly along the "
    "side\n"
    "  source                   yes where the scene has one, else no\n"
    "  t_end, dx, dt, fourier   s, m; dt or fourier only where given\n"
    "  threads                  how many the program may use\n"
    "{out} becomes the path that the program writes: the line x,T (x,y,T for a rectangle), then a line a point, at\n"
    "points of its own choosing, all counted alike in a norm.  Lines `# seconds = S`, `# steps = N` and\n"
    "`# updates = N` may tell what the solve itself took.  Its exit status must be 0; what it prints goes to "
    "standard\n"
    "error.\n";

enum { PATH_ROOM = 256 };

struct place {
    char dir[PATH_ROOM], input[PATH_ROOM], output[PATH_ROOM];
};

struct method *external_method(const char *label) {
    struct method *m = xcalloc(1, sizeof *m);
    *m = (struct method){.name = label, .about = "another program (--solver)", .accepts = ""};
    return m;
}

/* Under TMPDIR where its name needs no quotes in a shell. */
static int make_place(struct place *at, struct failure *why) {
    static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789/._-+";
    const char *parent = getenv("TMPDIR");
    if (!parent || *parent != '/' || strlen(parent) > PATH_ROOM - 40 || parent[strspn(parent, plain)])
        parent = "/tmp";
    snprintf(at->dir, sizeof at->dir, "%.215s/heatladder-XXXXXX", parent);
    if (!mkdtemp(at->dir))
        return refuse(why, STATUS_INPUT, "cannot make a directory in '%.200s': %s", parent, strerror(errno));
    snprintf(at->input, sizeof at->input, "%.240s/case", at->dir);
    snprintf(at->output, sizeof at->output, "%.240s/out.csv", at->dir);
    return STATUS_OK;
}

static void remove_place(const struct place *at) {
    unlink(at->input);
    unlink(at->output);
    rmdir(at->dir);
}

static int write_case(const struct experiment *e, const struct place *at, struct failure *why) {
    FILE *out = fopen(at->input, "w");
    if (!out) return refuse(why, STATUS_INPUT, "cannot write '%.200s': %s", at->input, strerror(errno));
    external_case_write(e, out);
    if (ferror(out) | fclose(out)) return refuse(why, STATUS_INPUT, "cannot write '%.200s'", at->input);
    return STATUS_OK;
}

/* The command with {case} and {out} replaced, to be freed. */
static char *fill_in(const char *command, const struct place *at) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (!out) return NULL;
    while (*command) {
        if (strncmp(command, "{case}", 6) == 0) {
            fputs(at->input, out);
            command += 6;
        } else if (strncmp(command, "{out}", 5) == 0) {
            fputs(at->output, out);
            command += 5;
        } else {
            fputc(*command++, out);
        }
    }
    fclose(out);
    return text;
}

/* Runs `sh -c command`, its standard output on standard error: what this program prints stays its own.  0, or an
 * errno. */
static int spawn(const char *command, const sigset_t *mask, int *status) {
    char *argv[] = {"sh", "-c", (char *)command, NULL};
    posix_spawn_file_actions_t files;
    posix_spawnattr_t how;
    pid_t child;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, STDERR_FILENO, STDOUT_FILENO);
    posix_spawnattr_init(&how);
    posix_spawnattr_setsigmask(&how, mask);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSIGMASK);
    int error = posix_spawn(&child, "/bin/sh", &files, &how, argv, environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&how);
    while (!error && waitpid(child, status, 0) < 0)
        if (errno != EINTR) error = errno;
    return error;
}

static int run_command(const char *command, const sigset_t *mask, struct failure *why) {
    int status = 0, error = spawn(command, mask, &status);
    if (error) return refuse(why, STATUS_INPUT, "--solver '%.200s': %s", command, strerror(error));
    if (WIFSIGNALED(status))
        return refuse(why, STATUS_NUMERICAL, "--solver '%.200s': ended by signal %d", command, WTERMSIG(status));
    status = WEXITSTATUS(status);
    if (status == 126 || status == 127)
        return refuse(why, STATUS_INPUT, "--solver '%.200s': could not be run (exit status %d)", command, status);
    if (status) return refuse(why, STATUS_NUMERICAL, "--solver '%.200s': exit status %d", command, status);
    return STATUS_OK;
}

static int solve_at(const struct experiment *e, const struct place *at, const sigset_t *mask, struct field *f,
                    struct failure *why) {
    if (write_case(e, at, why)) return why->status;
    char *command = fill_in(e->solver, at);
    if (!command) return refuse(why, STATUS_NUMERICAL, "out of memory for --solver");
    double begin = omp_get_wtime();
    int status = run_command(command, mask, why);
    double seconds = omp_get_wtime() - begin;
    free(command);
    if (status || external_csv_read(at->output, &e->problem, f, why)) return why->status;
    f->seconds = seconds;
    if (isnan(f->step_seconds)) f->step_seconds = seconds;
    return STATUS_OK;
}

int external_solve(const struct experiment *e, struct field *f, struct failure *why) {
    if (!strstr(e->solver, "{case}") || !strstr(e->solver, "{out}"))
        return refuse(why, STATUS_INPUT, "--solver '%.200s': must hold {case} and {out}, which become paths",
                      e->solver);
    struct place at;
    sigset_t held, before;
    sigemptyset(&held);
    sigaddset(&held, SIGINT);
    sigaddset(&held, SIGTERM);
    sigaddset(&held, SIGHUP);
    pthread_sigmask(SIG_BLOCK, &held, &before);
    int status = make_place(&at, why);
    if (!status) {
        status = solve_at(e, &at, &before, f, why);
        remove_place(&at);
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return status;
}
