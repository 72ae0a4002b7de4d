/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Command lines: the values that each verb reads, and each kind of refusal. */
#include "verification/cli/verb.h"

#include "references/scene.h"
#include "solver/options.h"

#include "verification/unit/near.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *options;  /* options of the verb of the last line */
static char *words_of; /* its words */

static void drop(void) {
    if (options) command_free(options);
    free(options);
    free(words_of);
    options = words_of = NULL;
}

/* Reads the line of any verb as main does. */
static int read_line(const char *line, struct failure *why) {
    char *word[200];
    drop();
    *why = (struct failure){0};
    words_of = strcpy(xcalloc(strlen(line) + 1, 1), line);
    int n = command_words(words_of, word, 200);
    if (n < 1) return refuse(why, STATUS_INPUT, "%d words", n);
    const struct verb *v = verb_find(word[0]);
    if (!v) return verb_unknown(word[0], why);
    options = xcalloc(1, v->size);
    return command_parse(v->syntax, v->own, n, word, options, why);
}

static void a_run_is_read(void **state) {
    (void)state;
    struct failure why;
    assert_int_equal(read_line("run --set kappa=0.023 rod-step so_ssph --dx 4/42 --kernel quartic --h 1.27 --order 3 "
                               "--sampling cell --walls=fixed --t-end 3.7 --fourier 0.17 --stepper rk2 --json F",
                               &why),
                     STATUS_OK);
    const struct experiment *e = &((const struct command *)options)->experiment;
    assert_string_equal(e->scene->name, "rod-step");
    assert_string_equal(e->method->name, "so_ssph");
    assert_near(e->options.dx, 4.0 / 42, 0);
    assert_int_equal(e->options.kernel, KERNEL_QUARTIC);
    assert_near(e->options.h, 1.27, 0);
    assert_int_equal(e->options.order, 3);
    assert_int_equal(e->options.sampling, SAMPLING_CELL);
    assert_int_equal(e->options.walls, WALLS_FIXED);
    assert_string_equal(stepper_words[e->options.stepper], "rk2");
    assert_near(e->options.fourier, 0.17, 0);
    assert_near(e->problem.material[0].k[0] / e->problem.material[0].rho_c, 0.023, 1e-17);
    assert_near(e->problem.t_end, 3.7, 0);
    assert_string_equal(command_given(options, "json"), "F");
    assert_null(command_given(options, "dt"));
}

static void a_ladder_has_lists(void **state) {
    (void)state;
    struct failure why;
    struct command c;
    const char *const more[] = {"--expect", "1.9,2.1", NULL};
    assert_int_equal(
        command_read_with("ladder rod-gauss so_ssph --dx 0.25 --dt 0.7,0.3,0.1 --set 'kappa=0.4'", more, &c, &why),
        STATUS_OK);
    assert_int_equal(c.rungs.dt.count, 3);
    assert_near(c.rungs.dt.value[1], 0.3, 0);
    assert_near(c.experiment.options.dt, 0.7, 0);
    assert_near(c.rungs.expect.value[1], 2.1, 0);
    assert_near(c.experiment.problem.material[0].k[0] / c.experiment.problem.material[0].rho_c, 0.4, 1e-16);
    command_free(&c);
}

/* One or two lines for each verb, and values at the ends of ranges. */
static const char *const taken[] = {
    "list gates",
    "list battery -v",
    "run square-step so_ssph --dx 0.1 --layout relaxed --jitter 0.5 --sweeps 1 --seed 4294967295",
    "run rod-step so_ssph --dx 0.1 --order 4 --shift 0.999999 --field 'a  \"b\" c.csv'",
    "run disc-mode so_ssph --dx 0.1 --origin 0,0 --angle -360",
    "run plate ftcs --dx 0.01 --set material=titanium",
    "ladder rod-gauss ftcs --dx 1 --dt 0.2,0.1 --fine 0.09",
    "ladder rod-step ftcs --expect -2,-1 --dx 1,2,3,4,5,6,7,8,9,1,2,3,4,5,6,7,8,9,1,2,3,4,5,6,7,8,9,1,2,3,4,5",
    "ladder rod-step mine --dx 0.1 --solver '{case}{out}' --vary n_2=1,1e-300 -v",
    "ladder --results q --at 1,2",
    "limit contact_ssph --dim 2 --contact 1 --ratio 1 --stepper rkl2 --stages 3",
    "reference rod-step --at 0.1 --time 0:1.5:10000000",
    "reference rod-step --points p.csv --what initial_mean --dx 0.1 --map=-x --scale 2",
    "case --battery --profile particles --order 4 --seed 3 --rungs 12 --seeds 16 --into d",
    "case rect-manufactured --dx 0.1 --aspect 2 --map y,-x --scale 2 --offset -5 --into d",
    "verify --gates f --rungs 5 --time-order 6",
    "verify --solver '{case}{out}' --order 2 --seed 3 --jobs 1024 --timeout 1 --keep k --only a --only b",
    "bench --json F here",
    "report ./song",
    "report song",

};

static void valid_lines_are_read(void **state) {
    (void)state;
    struct failure why;
    for (size_t i = 0; i < sizeof taken / sizeof *taken; i++)
        if (read_line(taken[i], &why)) fail_msg("heatladder %s: \"%s\"", taken[i], why.text);
}

static const struct {
    const char *line, *part; /* a part of the message */
} refusals[] = {
    /* verbs and positionals */
    {"rnu", "unknown verb 'rnu'; did you mean 'run'?"},
    {"man", "man is removed; use man heatladder"},
    {"completion", "completion is removed; use scripts/completion.bash"},
    {"run", "run needs a SCENE"},
    {"run rod-step --dx 0.1 --solver '{case}{out}'", "run needs a METHOD"},
    {"run rod-stpe ftcs --dx 0.1", "unknown scene 'rod-stpe'; did you mean 'rod-step'? (valid: "},
    {"run rod-step so_shp --dx 0.1", "unknown method 'so_shp'; did you mean 'so_ssph'? (valid: "},
    {"run rod-step ftcs more --dx 0.1", "'more' is one word too many for run (wanted: run SCENE METHOD)"},
    /* names of options */
    {"run rod-step ftcs --dx 0.1 --krenel cubic", "unknown option --krenel; did you mean --kernel? (see: "},
    {"run rod-step ftcs --xyzzyplugh 1", "unknown option --xyzzyplugh (see: heatladder run --help)"},
    {"reference rod-step --q 3", "unknown option --q (see: heatladder reference --help)"},
    {"verify --set kappa=1", "--set has no meaning for verify (see: heatladder verify --help)"},
    {"run rod-step ftcs --dx 0.1 --order 3", "--order has no meaning for ftcs; it has for so_ssph"},
    {"run rod-step mine --dx 0.1 --solver '{case}{out}' --kernel cubic", "--kernel has no meaning for mine"},
    {"run rod-step ftcs -v --dx 0.1", "'-v' is one word too many for run"},
    {"run rod-step ftcs", "run needs --dx DX[,DX...]: spacing"},
    {"ladder rod-step ftcs", "ladder needs --dx A,B,C,..., or --results DIR"},
    {"case --battery", "case needs --into DIR"},
    {"run rod-step ftcs --dx 0.1 --dx 0.1", "--dx is given twice"},
    {"run rod-step ftcs --dx 0.1 --json", "--json needs a value: --json FILE"},
    {"run rod-step ftcs --dx --json", "--dx needs a value: --dx DX[,DX...]"},
    {"run rod-step ftcs --dx", "--dx needs a value: --dx DX[,DX...]"},
    {"ladder --results=q --dx 0.1", "--dx needs a SCENE (see: heatladder ladder --help)"},
    {"case --battery --dt 0.1 --into d", "--dt needs a SCENE"},
    {"verify --only 'a", "-1 words"}, /* a quote is open */
    /* values */
    {"run rod-step ftcs --dx 0", "--dx 0: must be a number > 0"},
    {"run rod-step ftcs --dx nan",
     "--dx: entry 1, 'nan', is not a number; must be 1 to 32 numbers with commas between, such as 0.1,0.05,4/160"},
    {"ladder rod-step ftcs --dx 0.1,", "--dx: entry 2, ''"},
    {"run rod-step ftcs --dx 0.1,0.05x,0.2", "--dx: entry 2, '0.05x', is not a number"},
    {"reference rod-step --time 1 --at x",
     "--at: entry 1, 'x', is not a number; must be 1 to 32 numbers with commas between, such as -0.3,0.7"},
    {"reference rod-step --at 0.1 --time -1", "--time -1: must be a number >= 0"},
    {"reference rod-step --time 0:1:1 --at 0.1",
     "or FROM:TO:COUNT, such as 0:1.5:16, with a COUNT from 2 to 10000000"},
    {"run rod-step so_ssph --dx 0.1 --order 2.5", "--order 2.5: must be a whole number from 2 to 4"},
    {"run rod-step so_ssph --dx 0.1 --h isa", "--h isa: must be a number > 0, or iso"},
    {"run rod-step so_ssph --dx 0.1 --jitter 0.51", "--jitter 0.51: must be a number from 0 to 0.5"},
    {"run rod-step so_ssph --dx 0.1 --seed 4294967296",
     "--seed 4294967296: must be a whole number from 0 to 4294967295"},
    {"run rod-step so_ssph --dx 0.1 --kernel cubci", "unknown --kernel 'cubci'; did you mean 'cubic'?"},
    {"case rod-step --dx 0.1 --into d --offset x", "--offset x: must be a finite number"},
    {"run rod-step ftcs --dx 0.1 --field ''", "--field: empty; valid: FILE"},
    {"verify --only ''", "--only: empty"},
    {"run rod-step ftcs --dx 0.1 --set kapa=1", "unknown parameter of rod-step 'kapa'; did you mean 'kappa'?"},
    {"run rod-step ftcs --dx 0.1 --set kappa", "--set 'kappa': must be NAME=VALUE"},
    {"run rod-step ftcs --dx 0.1 --set kappa=1e999", "--set kappa=1e999: must be a finite number, in m^2/s"},
    {"run rod-step ftcs --dx 0.1 --set kappa=-1", "--set kappa=-1"},
    {"run rod-step ftcs --dx 0.1 --t-end 1 --set t_end=1", "--set t_end is given twice"},
    {"run plate ftcs --dx 0.01 --set material=stel", "unknown material 'stel'; did you mean 'steel'?"},
    {"reference plate --at 0.01,0.01 --time 1 --map z,x", "--map 'z,x': must name each axis of the scene once"},
    {"ladder rod-step mine --dx 0.1 --solver '{case}{out}' --vary dx=1,2", "and not case, out or dx"},
    {"ladder rod-step mine --dx 0.1 --solver '{case}{out}' --vary n=1,0", "with 1 to 32 numbers > 0"},
    {"verify --solver '{case}{out}' --order 3", "unknown --order '3'"},
    {"run cube-step so_ssph --dx 0.1 --dz 0.1", "unknown option --dz; --dx is the spacing along every axis"},
    /* options that need or exclude others */
    {"run rod-step ftcs --dx 0.1 --dt 1 --fourier 0.1", "--dt and --fourier exclude each other: give one of them"},
    {"run rod-step m --dx 0.1 --solver '{case}{out}' --results d", "--solver and --results exclude each other"},
    {"verify --gates f --seed 3 --solver '{case}{out}'", "--seed and --gates exclude each other"},
    {"verify --jobs 2", "--jobs needs --solver"},
    {"run plate ftcs --dx 0.01 --map y,x", "--map needs --solver or --results"},
    {"case rod-step --profile particles --dx 0.1 --into d", "--profile needs --battery"},
    {"verify --time-order 2", "--time-order needs --solver, --results or --gates"},
    {"run rod-step so_ssph --dx 0.1 --fourier 1 --stepper exact", "--fourier 1: the stepper takes no time step"},
    {"run rod-step so_ssph --dx 0.1 --dt 1 --stepper exact", "--dt 1: the stepper takes no time step"},
    {"run rod-step so_ssph --dx 0.1 --jitter 0.1", "--jitter 0.1: these particles do not move; take --layout jitter"},
    {"run square-step so_ssph --dx 0.1 --layout jitter --sweeps 1", "take --layout relaxed"},
    {"run rod-step brookshaw --dx 0.1 --xi 0.1", "take --volume tuned"},
    {"reference square-step --at 0.1 --time 1", "--at 0.1: the point has as many numbers as axes; take X,Y"},
    {"ladder --results q --at 1,2,3,4", "take X or X,Y or X,Y,Z"},
    {"ladder rod-gauss ftcs --dx 1 --dt 0.2,0.1 --fine 0.1", "--fine 0.1: it is finer than each of several --dt"},
    {"ladder rod-gauss so_ssph --dx 1 --dt 0.2,0.1 --fine 0.01", "take no --fine"},
    {"ladder rod-step ftcs --dx 0.1,0.2 --expect 2,2", "--expect 2,2: a band is LO < HI"},
    {"case disc-mode --dx 0.1 --aspect 2 --into d", "--aspect 2: the scene is no rectangle"},
    {"reference rod-step --at 0.1 --time 1 --map y,x", "--map y,x: the scene has x alone; take x or -x"},
    {"run disc-mode so_ssph --dx 0.1 --origin 0,0,0", "--origin 0,0,0: it is a point; take X,Y, in dx"},
    {"run disc-mode so_ssph --dx 0.1 --shift 0.3", "--shift 0.3: it is for plane walls"},
    {"run rod-step so_ssph --dx 0.1 --angle 10", "--angle 10: it is for round bodies"},
    {"run rod-step so_ssph --dx 0.1 --origin 0,0", "--origin 0,0: it is for round bodies"},
};

static void invalid_lines_are_refused_with_what_is_valid(void **state) {
    (void)state;
    struct failure why;
    for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++) {
        int status = read_line(refusals[i].line, &why);
        if (status != STATUS_INPUT || !strstr(why.text, refusals[i].part))
            fail_msg("heatladder %s: status %d, \"%s\"; expected \"%s\"", refusals[i].line, status, why.text,
                     refusals[i].part);
        assert_int_equal(why.status, STATUS_INPUT);
        assert_null(strchr(why.text, '\n'));
    }
}

/* Verbs check further combinations themselves. */
static void verbs_refuse_combinations(void **state) {
    (void)state;
    static const struct {
        const char *line, *part;
    } row[] = {{"reference rod-step --time 0.3", "reference needs either --at X[,Y[,Z]] or --points FILE"},
               {"reference rod-step --at 0.3", "reference needs --time"},
               {"reference rod-step --time 0.3 --points p.csv --json F", "--points is CSV"},
               {"case rod-step --battery --dx 0.1 --into d", "--battery has scenes of its own"},
               {"case --into d", "case needs a scene, or --battery"},
               {"case rod-step --into d", "case needs --dx A,B,C"},
               {"run rod-step ftcs --dx 0.1,0.2", "run takes one --dx; for several: heatladder ladder"},
               {"bench --scene rod-stpe", "unknown --scene 'rod-stpe'; did you mean 'rod-step'?"},
               {"list gatse", "unknown topic 'gatse'; did you mean 'gates'?"},
               {"report sonng", "unknown study 'sonng'; did you mean 'song'?"},
               {"report here song", "unknown study 'here' (valid: song, "},
               {"report song --json F", "--json has a meaning for report claims alone"}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct failure why;
        if (read_line(row[i].line, &why)) fail_msg("heatladder %s: \"%s\"", row[i].line, why.text);
        int status = verb_find(((const struct command *)options)->syntax->name)->act(options, &why);
        if (status != STATUS_INPUT || !strstr(why.text, row[i].part))
            fail_msg("heatladder %s: status %d, \"%s\"", row[i].line, status, why.text);
    }
}

/* A line holds 64 options, and command_read 128 words. */
static void long_lines_are_refused(void **state) {
    (void)state;
    struct failure why;
    struct command c;
    char line[2000], *to = line + sprintf(line, "verify");
    for (int i = 0; i < 64; i++) to += sprintf(to, " --only=%d", i);
    assert_int_equal(read_line(line, &why), STATUS_OK);
    strcpy(to, " --only=64");
    assert_int_equal(read_line(line, &why), STATUS_INPUT);
    assert_string_equal(why.text, "more than 64 options");
    to = line + sprintf(line, "run");
    for (int i = 1; i < 128; i++) to += sprintf(to, " \tw");
    assert_int_equal(command_read(line, &c, &why), STATUS_INPUT);
    assert_has(why.text, "'w' is one word too many for run");
    command_free(&c);
    assert_int_equal(command_read_with(line, (const char *const[]){"w", NULL}, &c, &why), STATUS_INPUT);
    assert_has(why.text, "too many words");
    command_free(&c);
    assert_int_equal(command_read("list", &c, &why), STATUS_INPUT);
    assert_has(why.text, "unknown verb 'list'; did you mean 'limit'? (valid: run, ladder, limit, reference)");
    command_free(&c);
}

/* Round bodies have walls of type fit by default, but not for cells, finite differences and other programs. */
static void round_bodies_have_fitted_walls(void **state) {
    (void)state;
    static const struct {
        const char *line;
        enum walls walls;
    } row[] = {{"run disc-mode so_ssph --dx 0.1", WALLS_FIT},
               {"run disc-mode so_ssph --dx 0.1 --walls image", WALLS_IMAGE},
               {"run disc-mode ftcs --dx 0.1", WALLS_MIRROR},
               {"run disc-mode voronoi_flux --dx 0.1", WALLS_MIRROR},
               {"run rod-step so_ssph --dx 0.1", WALLS_MIRROR}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct failure why;
        assert_int_equal(read_line(row[i].line, &why), STATUS_OK);
        assert_int_equal(((const struct command *)options)->experiment.options.walls, row[i].walls);
    }
}

static void the_environment_sets_the_vector_width(void **state) {
    (void)state;
    static const char *const wrong[] = {"1", "3", "16", "4x", "-2"};
    struct failure why;
    setenv("HEATLADDER_LANES", "2", 1);
    assert_int_equal(read_line("run rod-step ftcs --dx 4/42", &why), STATUS_OK);
    assert_int_equal(((const struct command *)options)->experiment.options.lanes, 2);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        setenv("HEATLADDER_LANES", wrong[i], 1);
        assert_int_equal(read_line("run rod-step ftcs --dx 4/42", &why), STATUS_INPUT);
        assert_has(why.text, wrong[i]);
    }
    unsetenv("HEATLADDER_LANES");
}

/* Each name in a syntax is the name of a row, so that each option can be reached. */
static void syntaxes_name_existing_options(void **state) {
    (void)state;
    for (int i = 0; verbs[i]; i++) {
        const struct command_syntax *s = verbs[i]->syntax;
        char list[600], *rest = list;
        snprintf(list, sizeof list, "%s %s %s", s->options, s->required, s->sceneless ? s->sceneless : "");
        for (char *name; (name = strtok_r(rest, " ", &rest));)
            if (!command_option(s, verbs[i]->own, name)) fail_msg("%s: no option '%s'", s->name, name);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_run_is_read),
        cmocka_unit_test(a_ladder_has_lists),
        cmocka_unit_test(valid_lines_are_read),
        cmocka_unit_test(invalid_lines_are_refused_with_what_is_valid),
        cmocka_unit_test(verbs_refuse_combinations),
        cmocka_unit_test(long_lines_are_refused),
        cmocka_unit_test(round_bodies_have_fitted_walls),
        cmocka_unit_test(the_environment_sets_the_vector_width),
        cmocka_unit_test(syntaxes_name_existing_options),
    };
    int failed = cmocka_run_group_tests_name("arguments", tests, NULL, NULL);
    drop();
    return failed;
}
