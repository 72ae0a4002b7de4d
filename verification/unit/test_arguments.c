/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Command lines: what is taken, and the text of every refusal. */
#include "verification/command/arguments.h"

#include "references/scene.h"
#include "verification/command/option.h"
#include "verification/command/verb.h"
#include "verification/text/words.h"

#include "verification/unit/near.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void a_run_is_read(void **state) {
    (void)state;
    struct request r;
    struct failure why;
    assert_int_equal(
        arguments_parse_line("run rod-step so_ssph --dx 4/42 --kernel quartic --h 1.27 --order 3 "
                             "--sampling cell --walls=fixed --set kappa=0.023 --t-end 3.7 --fourier 0.17 "
                             "--stepper rk2 --json",
                             &r, &why),
        STATUS_OK);
    assert_string_equal(r.verb->name, "run");
    assert_string_equal(r.experiment.scene->name, "rod-step");
    assert_string_equal(r.experiment.method->name, "so_ssph");
    assert_near(r.experiment.options.dx, 4.0 / 42, 0);
    assert_int_equal(r.experiment.options.kernel, KERNEL_QUARTIC);
    assert_near(r.experiment.options.h, 1.27, 0);
    assert_int_equal(r.experiment.options.order, 3);
    assert_int_equal(r.experiment.options.sampling, SAMPLING_CELL);
    assert_int_equal(r.experiment.options.walls, WALLS_FIXED);
    assert_int_equal(r.experiment.options.stepper, STEPPER_RK2);
    assert_near(r.experiment.options.fourier, 0.17, 0);
    assert_near(r.experiment.problem.material[0].k[0] / r.experiment.problem.material[0].rho_c, 0.023, 1e-17);
    assert_near(r.experiment.problem.t_end, 3.7, 0);
    assert_int_equal(r.json, 1);
    arguments_free(&r);
}

static void options_may_come_first(void **state) {
    (void)state;
    struct request r;
    struct failure why;
    assert_int_equal(arguments_parse_line("run --set kappa=0.023 --dx 0.1 rod-step ftcs", &r, &why), STATUS_OK);
    assert_near(r.experiment.problem.material[0].k[0] / r.experiment.problem.material[0].rho_c, 0.023, 1e-17);
    arguments_free(&r);
}

static void quotes_hold_blanks(void **state) {
    (void)state;
    struct request r;
    struct failure why;
    assert_int_equal(arguments_parse_line("run rod-step ftcs --dx 0.1 --field 'a  \"b\" c.csv'", &r, &why),
                     STATUS_OK);
    assert_string_equal(r.field_path, "a  \"b\" c.csv");
    arguments_free(&r);
    assert_int_equal(arguments_parse_line("verify --only \"*gauss*\"", &r, &why), STATUS_OK);
    assert_string_equal(r.only, "*gauss*");
    arguments_free(&r);
}

static void a_profile_is_a_choice_of_rows(void **state) {
    (void)state;
    struct request r;
    struct failure why;
    assert_int_equal(arguments_parse_line("verify --profile particles --solver 'p {case} {out}'", &r, &why),
                     STATUS_OK);
    assert_int_equal(r.profile, PROFILE_PARTICLES);
    arguments_free(&r);
    assert_int_equal(arguments_parse_line("case --battery --profile slabs --into d", &r, &why), STATUS_OK);
    assert_int_equal(r.profile, PROFILE_SLABS);
    arguments_free(&r);
}

static void a_choice_is_set_by_its_word(void **state) {
    (void)state;
    struct request r;
    struct failure why;
    assert_int_equal(arguments_parse_line("run plate ftcs --dx 0.01 --set material=titanium", &r, &why), STATUS_OK);
    int i = 0;
    while (strcmp(r.experiment.scene->params[i].name, "material") != 0) i++;
    assert_string_equal(r.experiment.scene->params[i].choice[(int)r.experiment.problem.param[i]], "titanium");
    arguments_free(&r);
}

static void lists_become_ladders(void **state) {
    (void)state;
    struct request r;
    struct failure why;
    assert_int_equal(
        arguments_parse_line("ladder rod-gauss so_ssph --dx 0.25 --dt 0.7,0.3,0.1 --stepper euler", &r, &why),
        STATUS_OK);
    assert_int_equal(r.rungs.dt.count, 3);
    assert_near(r.rungs.dt.value[1], 0.3, 0);
    assert_near(r.experiment.options.dt, 0.7, 0);
    arguments_free(&r);
}

static const struct refusal {
    const char *line, *part; /* what the text must hold */
} refusals[] = {
    {"", "a verb is missing"},
    {"rnu", "unknown verb 'rnu'; did you mean 'run'?"},
    {"run", "run needs a SCENE"},
    {"run rod-step", "run needs a METHOD"},
    {"run rod-stpe ftcs --dx 0.1", "unknown scene 'rod-stpe'; did you mean 'rod-step'? (valid: "},
    {"run rod-step so_shp --dx 0.1", "unknown method 'so_shp'; did you mean 'so_ssph'? (valid: "},
    {"run rod-step ftcs more --dx 0.1", "'more' is one word too many for run"},
    {"list scenes methods", "'methods' is one word too many for list"},
    {"run rod-step ftcs", "run needs --dx"},
    {"verify --profile particles", "--profile chooses rows of the battery: it needs --solver"},
    {"verify --profile slabs --gates f --solver '{case} {out}'", "--profile chooses rows of the battery"},
    {"case rod-step --profile slabs --dx 0.1 --into d", "--profile chooses rows of the battery"},
    {"verify --profile cells --solver '{case} {out}'", "(valid: all, particles, slabs)"},
    {"run rod-step mine --axes x,z --dx 0.1 --solver '{case} {out}'", "--axes: rod-step is a rod"},
    {"run plate mine --axes z,x --dx 0.01 --solver '{case} {out}'", "(valid: x,y, x,z, y,z)"},
    {"run plate ftcs --axes x,z --dx 0.01", "--axes needs --solver or --results"},
    {"reference rod-step --at 0.3", "reference needs --time"},
    {"reference rod-step --time 0.3", "reference needs either --at X[,Y] or --points FILE"},
    {"reference rod-step --time 0.3 --at 0.1 --points p.csv", "reference needs either --at X[,Y] or --points FILE"},
    {"reference rod-step --time 0.3 --points p.csv --json", "--points is CSV"},
    {"ladder rod-gauss ftcs --dx 1 --dt 0.2,0.1 --fine 0.1", "--fine 0.1: needs --dt A,B,C, and to be below"},
    {"ladder rod-gauss so_ssph --dx 1 --dt 0.2,0.1 --fine 0.01", "--fine: what so_ssph is to reach in time is known"},
    {"reference rod-step --time 0:1 --at 0.1", "numbers with commas between, or FROM:TO:COUNT"},
    {"reference rod-step --time 0:1:1 --at 0.1", "a COUNT from 2 to "},
    {"reference rod-step --time -1:1:5 --at 0.1", "numbers with commas between, or FROM:TO:COUNT"},
    {"reference rod-step --time 0.3,0.4 --at 0.1 --json", "--time T,T,... is CSV"},
    {"reference rod-step --what initial_mean --at 0.1 --dx 0.1,0.2", "--dx: one extent"},
    {"run rod-step ftcs --dx", "--dx needs a value"},
    {"run rod-step ftcs --dx --json", "--dx needs a value"},
    {"run rod-step ftcs --dx ''", "--dx ''"},
    {"run rod-step ftcs --dx 0", "--dx 0: must be a number > 0"},
    {"run rod-step ftcs --dx -0.1", "--dx -0.1: must be a number > 0"},
    {"run rod-step ftcs --dx nan", "--dx 'nan'"},
    {"run rod-step ftcs --dx inf", "--dx 'inf'"},
    {"run rod-step ftcs --dx 0.1m", "--dx '0.1m'"},
    {"ladder rod-step ftcs --dx 0.1,", "--dx '0.1,'"},
    {"run rod-step ftcs --dx 0.1 --dx 0.1", "--dx is given twice"},
    {"run rod-step ftcs --dx 0.1 --dt 0", "--dt 0: must be a number > 0"},
    {"run rod-step ftcs --dx 0.1 --dt -2", "--dt -2: must be a number > 0"},
    {"run rod-step ftcs --dx 0.1 --dt NaN", "--dt 'NaN'"},
    {"run rod-step ftcs --dx 0.1 --dt 1 --fourier 0.1", "--dt and --fourier both set the time step"},
    {"run rod-step so_ssph --dx 0.1 --dt 1 --stepper exact", "--stepper exact: has no time step; leave out --dt"},
    {"page out", "page is removed; use heatladder report page DIR"},
    {"case --run d", "--run is removed; use a batch engine on DIR/cases.txt"},
    {"run rod-step so_ssph --dx 0.1 --xyzzyplugh 1 --time-error 1", "unknown option --xyzzyplugh"},
    {"report sonng", "unknown study 'sonng'; did you mean 'song'?"},
    {"report here song", "unknown study 'here' (valid: song, "},
    {"run rod-step ftcs --dx 0.1 --kernel cubic", "--kernel has no meaning for ftcs; it has for "},
    {"run rod-step ftcs --dx 0.1 --order 3", "it has for so_ssph"},
    {"run rod-step so_ssph --dx 0.1 --kernel cubci", "unknown kernel 'cubci'; did you mean 'cubic'?"},
    {"run rod-step so_ssph --dx 0.1 --krenel cubic",
     "unknown option --krenel; did you mean --kernel? (see: heatladder run --help)"},
    {"run rod-step so_ssph --dx 0.1 --stepper eluer", "unknown stepper 'eluer'; did you mean 'euler'?"},
    {"run rod-step so_ssph --dx 0.1 --order 5", "--order 5: must be a whole number from 2 to 4"},
    {"run rod-step so_ssph --dx 0.1 --order 2.5", "--order 2.5: must be a whole number from 2 to 4"},
    {"run rod-step so_ssph --dx 0.1 --h 0", "--h 0: must be a number > 0, or iso"},
    {"run rod-step so_ssph --dx 0.1 --h isa", "--h isa: must be a number > 0, or iso"},
    {"run rod-step so_ssph --dx 0.1 --layout jitter --jitter 0.51", "--jitter 0.51: must be a number from 0 to 0.5"},
    {"run rod-step so_ssph --dx 0.1 --jitter 0.1", "--jitter 0.1: needs --layout jitter"},
    {"run rod-step so_ssph --dx 0.1 --seed -3", "--seed -3: must be a whole number"},
    {"run rod-step so_ssph --dx 0.1 --threads 0", "--threads 0: must be a whole number from 1"},
    {"run rod-step ftcs --dx 0.1 --set kapa=1", "unknown parameter of rod-step 'kapa'; did you mean 'kappa'?"},
    {"run rod-step ftcs --dx 0.1 --set kappa", "--set 'kappa': must be NAME=VALUE"},
    {"run rod-step ftcs --dx 0.1 --set =3", "--set '=3': must be NAME=VALUE"},
    {"run rod-step ftcs --dx 0.1 --set kappa=", "--set kappa=: must be a finite number"},
    {"run rod-step ftcs --dx 0.1 --set kappa=1e999", "--set kappa=1e999: must be a finite number, in m^2/s"},
    {"run rod-step ftcs --dx 0.1 --set kappa=-1", "--set kappa=-1"},
    {"run rod-step ftcs --dx 0.1 --set kappa=1 --set kappa=1", "parameter 'kappa' is given twice"},
    {"run rod-step ftcs --dx 0.1 --t-end 1 --set t_end=1", "parameter 't_end' is given twice"},
    {"run plate ftcs --dx 0.01 --set material=stel", "unknown material 'stel'; did you mean 'steel'?"},
    {"run rod-step ftcs --dx 0.1 --only x", "--only has no meaning for run"},
    {"limit so_ssph --dim 2 --set kappa_y=0.1", "only the ratio of k_y to k_x counts, --ratio R"},
    {"run rod-step ftcs --dx 0.1 --json=yes", "--json takes no value"},
    {"run rod-step ftcs --dx 0.1 --field ''", "--field: empty"},
    {"ladder rod-step ftcs --dx 0.1,0.2 --expect 2", "--expect 2: needs LO,HI"},
    {"ladder rod-step ftcs --dx 0.1,0.2 --expect 2.1,1.9", "--expect 2.1,1.9: needs LO,HI with LO < HI"},
    {"reference rod-step --at 0.1,0.2 --time 1", "--at needs one number for rod-step"},
    {"reference square-step --at 0.1 --time 1", "--at needs X,Y for square-step"},
    {"ladder --results q --at 1,2,3", "--at needs X or X,Y for a point"},
    {"reference rod-step --at 0.1 --time -1", "--time -1: must be a number >= 0"},
    {"run rect-manufactured ftcs --dx 0.1 --aspect 2", "--aspect needs --solver or --results"},
    {"run rod-step mine --dx 0.1 --aspect 2 --solver '{case}{out}'", "--aspect: rod-step has no rows"},
    {"run disc-mode mine --dx 0.1 --aspect 2 --solver '{case}{out}'", "--aspect: disc-mode has no rows"},
    {"verify --only 'a", "a quote is left open"},
    {"verify --set kappa=1", "--set has no meaning for verify (see: heatladder verify --help)"},
    {"run rod-step ftcs --xyzzyplugh 1", "unknown option --xyzzyplugh (see: heatladder run --help)"},
    {"run rod-step ftcs -v --dx 0.1", "'-v' is one word too many for run (wanted: run SCENE METHOD)"},
    {"run rod-step --dx 0.1 --solver '{case}{out}'", "run needs a METHOD"},
    {"ladder --results q --dx 0.1", "--dx needs a SCENE (see: heatladder ladder --help)"},
    {"ladder --results=q --dx 0.1", "--dx needs a SCENE"},
    {"case --battery --dt 0.1 --into d", "--dt needs a SCENE"},
    {"run rod-step so_ssph --dx 0.1 --angle 10", "--angle: is for round bodies; plane walls take --shift S"},
    {"run rod-step so_ssph --dx 0.1 --origin 0,0", "--origin: is for round bodies; plane walls take --shift S"},
    {"run disc-mode so_ssph --dx 0.1 --origin 0,0,0", "--origin 0,0,0: needs X,Y, in dx"},
    {"report ./sonng other", "unknown study './sonng'; did you mean 'song'?"},
    {"report song a b", "'b' is one word too many for report"},
    {"case rod-step --battery --dx 0.1 --into d", "--battery has scenes of its own"},
    {"case --into d", "case needs a scene, or --battery"},
    {"case rod-step --into d", "case needs --dx A,B,C"},
    {"case rod-step --dx 0.1", "case needs --into DIR"},
    {"case --battery", "case needs --into DIR"},
    {"run rod-step so_ssph --dx 0.1 --fourier 1 --stepper exact", "has no time step; leave out --fourier"},
    {"run rod-step so_ssph --dx 0.1 --layout hexagonal --jitter 0.1",
     "--jitter 0.1: needs --layout jitter or relaxed"},
    {"run square-step so_ssph --dx 0.1 --layout jitter --sweeps 1", "--sweeps 1: needs --layout relaxed"},
    {"run rod-step brookshaw --dx 0.1 --xi 0.1", "--xi 0.1: needs --volume tuned"},
    {"ladder rod-gauss ftcs --dx 1 --dt 0.2 --fine 0.1", "--fine 0.1: needs --dt A,B,C, and to be below"},
    {"ladder rod-step ftcs --dx 0.1,0.2 --expect 2,2", "--expect 2,2: needs LO,HI with LO < HI"},
    {"ladder rod-step ftcs --dx 0.1,0.2 --expect 1,2,3", "--expect 1,2,3: needs LO,HI with LO < HI"},
    {"reference rod-step --at 0.1 --time 1 --what k_x --json", "(--at, --time); --what is CSV"},
    {"reference rod-step --time 1 --at x", "--at 'x': must be 1 to 32 numbers with commas between, such as -0.3,0.7"},
    {"ladder rod-step ftcs --dx 1,2,3,4,5,6,7,8,9,1,2,3,4,5,6,7,8,9,1,2,3,4,5,6,7,8,9,1,2,3,4,5,6",
     "must be 1 to 32 numbers with commas between"},
    {"run rod-step ftcs --dx x", "must be 1 to 32 numbers with commas between, such as 0.1,0.05,4/160"},
    {"reference rod-step --time 0:-1:5 --at 0.1", "numbers with commas between, or FROM:TO:COUNT"},
    {"reference rod-step --time 0:1:10000001 --at 0.1", "with a COUNT from 2 to 10000000"},
    {"run rod-step ftcs --dx 0.1 --timeout 3", "--timeout needs --solver 'CMD'"},
    {"run rod-step ftcs --dx 0.1 --keep k", "--keep needs --solver 'CMD'"},
    {"verify --jobs 2", "--jobs needs --solver 'CMD'"},
    {"verify --seed 3", "--seed draws the battery"},
    {"verify --gates f --seed 3 --solver '{case}{out}'", "--seed draws the battery"},
    {"run plate ftcs --dx 0.01 --map y,x", "--map needs --solver or --results"},
    {"run plate ftcs --dx 0.01 --scale 2", "--scale needs --solver or --results"},
    {"run plate ftcs --dx 0.01 --offset 5", "--offset needs --solver or --results"},
    {"case rod-step --dx 0.1 --into d --offset x", "--offset x: must be a finite number"},
    {"case rod-step --dx 0.1 --into d --aspect 2", "--aspect: rod-step has no rows of cells along y"},
    {"case rod-step --dx 0.1 --into d --axes x,z", "--axes: rod-step is a rod along x"},
    {"reference rod-step --at 0.1 --time 1 --map y,x", "--map: rod-step has x alone: x or -x"},
    {"reference plate --at 0.01,0.01 --time 1 --map=-x", "--map: plate has x and y, such as y,-x"},
    {"reference plate --at 0.01,0.01 --time 1 --map z,x", "--map 'z,x': must name each axis of the scene once"},
    {"verify --rungs 5", "--rungs needs --solver, --results, --gates or --battery"},
    {"verify --time-order 2", "--time-order needs --solver, --results, --gates or --battery"},
    {"verify --gates f --seeds 3", "--seeds needs --solver or --results"},
    {"verify --solver '{case}{out}' --order 0", "--order 0: must be 1, 2 or 4"},
    {"verify --solver '{case}{out}' --order 5", "--order 5: must be 1, 2 or 4"},
    {"run rod-step ftcs --dx 0.1 --columns x=X", "--columns needs --solver or --results"},
    {"run rod-step ftcs --dx 0.1 --columns w=W", "--columns needs --solver or --results"},
    {"ladder rod-step ftcs --dx 0.1 --vary n=1,2", "--vary needs --solver or --results"},
    {"ladder rod-step mine --dx 0.1 --solver '{case}{out}' --vary dx=1,2", "and not case, out or dx"},
    {"ladder rod-step mine --dx 0.1 --solver '{case}{out}' --vary n", "--vary 'n': must be NAME=A,B,C,..., NAME of"},
    {"ladder rod-step mine --dx 0.1 --solver '{case}{out}' --vary n=1,0", "with 1 to 32 numbers > 0"},
    {"ladder rod-step mine --dx 0.1 --solver '{case}{out}' --vary n=1,", "with 1 to 32 numbers > 0"},
};

/* A text to its end. */
static const struct refusal whole_refusals[] = {
    {"run rod-step ftcs --dx 0.1 --set kappa=x", "--set kappa=x: must be a finite number, in m^2/s"},
    {"run rod-cosine ftcs --dx 0.1 --set mode=x", "--set mode=x: must be a finite number"},
    {"reference rod-step --at 0.1,0.2 --time 1", "--at needs one number for rod-step"},
    {"verify --seed 4294967296 --solver '{case}{out}'",
     "--seed 4294967296: must be a whole number from 0 to 4294967295"},
};

/* What lies at the edge of what an option takes, or needs one of several others. */
static const char *const taken[] = {
    "run square-step so_ssph --dx 0.1 --layout relaxed --jitter 0.5",
    "run square-step so_ssph --dx 0.1 --layout relaxed --sweeps 1",
    "run square-step so_ssph --dx 0.1 --layout jitter --jitter 0 --seed 4294967295",
    "run rod-step so_ssph --dx 0.1 --order 2 --shift 0",
    "run rod-step so_ssph --dx 0.1 --order 4 --shift 0.999999",
    "run rod-step brookshaw --dx 0.1 --volume tuned --xi 0.1",
    "run disc-mode so_ssph --dx 0.1 --origin 0,0 --angle -360",
    "run disc-mode so_ssph --dx 0.1 --angle 360",
    "ladder rod-gauss ftcs --dx 1 --dt 0.2,0.1 --fine 0.09",
    "ladder rod-step ftcs --expect -2,-1 --dx 1,2,3,4,5,6,7,8,9,1,2,3,4,5,6,7,8,9,1,2,3,4,5,6,7,8,9,1,2,3,4,5",
    "ladder rod-step mine --dx 0.1,0.2 --solver '{case}{out}' --seeds 2",
    "ladder rod-step mine --dx 0.1 --solver '{case}{out}' --vary n_2=1,1e-300",
    "limit contact_ssph --dim 2 --contact 1 --ratio 1 --stepper rkl2 --stages 3",
    "limit contact_ssph --dim 1 --stepper rkl2 --stages 99",
    "reference rod-step --at 0.1 --time 0:0:2",
    "reference rod-step --at 0.1 --time 0:1.5:10000000",
    "reference plate --at 0.01,0.01 --time 0 --json",
    "case --battery --order 1 --seed 3 --rungs 4 --seeds 16 --into d",
    "case --battery --order 4 --rungs 12 --into d",
    "case rect-manufactured --dx 0.1 --aspect 2 --axes x,z --map y,-x --scale 2 --offset -5 --into d",
    "verify --gates f --rungs 5 --time-order 6",
    "verify --gates f --time-order 0.5",
    "verify --solver '{case}{out}' --order 2 --seed 3 --jobs 1 --timeout 1 --keep k",
    "bench --json",
    "report ./sonng",
};

static void every_refusal_says_what_is_valid(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++) {
        struct request r;
        struct failure why = {0};
        int status = arguments_parse_line(refusals[i].line, &r, &why);
        if (status != STATUS_INPUT || !strstr(why.text, refusals[i].part))
            fail_msg("heatladder %s: status %d, \"%s\"; wanted \"%s\"", refusals[i].line, status, why.text,
                     refusals[i].part);
        assert_int_equal(why.status, STATUS_INPUT);
        assert_null(strchr(why.text, '\n'));
        arguments_free(&r);
    }
}

static void a_refusal_ends_where_it_should(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof whole_refusals / sizeof *whole_refusals; i++) {
        struct request r;
        struct failure why = {0};
        assert_int_equal(arguments_parse_line(whole_refusals[i].line, &r, &why), STATUS_INPUT);
        assert_string_equal(why.text, whole_refusals[i].part);
        arguments_free(&r);
    }
}

static void what_is_valid_is_taken(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof taken / sizeof *taken; i++) {
        struct request r;
        struct failure why = {0};
        if (arguments_parse_line(taken[i], &r, &why)) fail_msg("heatladder %s: \"%s\"", taken[i], why.text);
        arguments_free(&r);
    }
}

/* 64 options and 128 words fit. */
static void a_line_has_room_for_so_much(void **state) {
    (void)state;
    struct request r;
    struct failure why;
    char line[2000], *to = line + sprintf(line, "verify");
    for (int i = 0; i < 64; i++) to += sprintf(to, " --only=%d", i);
    assert_int_equal(arguments_parse_line(line, &r, &why), STATUS_OK);
    assert_true(strncmp(r.only, "0,1,2,", 6) == 0 && strcmp(r.only + strlen(r.only) - 6, ",62,63") == 0);
    arguments_free(&r);
    strcpy(to, " --only=64");
    assert_int_equal(arguments_parse_line(line, &r, &why), STATUS_INPUT);
    assert_string_equal(why.text, "more than 64 options");
    arguments_free(&r);
    to = line + sprintf(line, "list");
    for (int i = 1; i < 128; i++) to += sprintf(to, " \tw");
    assert_int_equal(arguments_parse_line(line, &r, &why), STATUS_INPUT);
    assert_has(why.text, "'w' is one word too many for list");
    arguments_free(&r);
    strcpy(to, " w");
    assert_int_equal(arguments_parse_line(line, &r, &why), STATUS_INPUT);
    assert_has(why.text, "too many words");
    arguments_free(&r);
}

/* Words that are put after those of the line, until there are too many. */
static void more_words_follow_a_line(void **state) {
    (void)state;
    struct request r;
    struct failure why;
    const char *more[129] = {"--only", "it's a, \"b\"", "--quick"};
    assert_int_equal(arguments_parse_line_with("verify --skip 'c d'", more, &r, &why), STATUS_OK);
    assert_string_equal(r.only, "it's a, \"b\"");
    assert_string_equal(r.skip, "c d");
    assert_int_equal(r.quick, 1);
    arguments_free(&r);
    for (int i = 0; i < 127; i++) more[i] = "w";
    assert_int_equal(arguments_parse_line_with("list", more, &r, &why), STATUS_INPUT);
    assert_has(why.text, "'w' is one word too many for list");
    arguments_free(&r);
    more[127] = "w";
    assert_int_equal(arguments_parse_line_with("list", more, &r, &why), STATUS_INPUT);
    assert_string_equal(why.text, "'list': too many words");
    arguments_free(&r);
}

/* Round bodies have walls that fit, but for methods of cells, a grid's and another program's. */
static void round_walls_fit(void **state) {
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
        struct request r;
        struct failure why;
        assert_int_equal(arguments_parse_line(row[i].line, &r, &why), STATUS_OK);
        assert_int_equal(r.experiment.options.walls, row[i].walls);
        arguments_free(&r);
    }
}

static void the_width_of_vectors_comes_from_the_environment(void **state) {
    (void)state;
    static const char *const wrong[] = {"1", "3", "0", "16", "4x", " 4", "-2", "wide"};
    struct request r;
    struct failure why;
    char word[12];
    for (int lanes = 2; lanes <= 8; lanes *= 2) {
        snprintf(word, sizeof word, "%d", lanes);
        setenv("HEATLADDER_LANES", word, 1);
        int status = arguments_parse_line("run rod-step ftcs --dx 4/42", &r, &why);
        assert_int_equal(status, lanes <= options_lanes_most() ? STATUS_OK : STATUS_INPUT);
        if (!status) assert_int_equal(r.experiment.options.lanes, lanes);
        arguments_free(&r);
    }
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        setenv("HEATLADDER_LANES", wrong[i], 1);
        assert_int_equal(arguments_parse_line("run rod-step ftcs --dx 4/42", &r, &why), STATUS_INPUT);
        assert_has(why.text, wrong[i]);
        assert_has(why.text, "vectors of 2");
        arguments_free(&r);
    }
    unsetenv("HEATLADDER_LANES");
    assert_int_equal(arguments_parse_line("run rod-step ftcs --dx 4/42", &r, &why), STATUS_OK);
    assert_int_equal(r.experiment.options.lanes, 0);
    arguments_free(&r);
}

/* A name in a verb's lists that no option has would make it unreachable without a word. */
static void the_tables_agree(void **state) {
    (void)state;
    int n = 0;
    const char *keys[WORDS_MAX] = {0};
    for (const struct option *o = options_table; o->key; o++) {
        keys[n++] = o->key;
        assert_order(n, <, WORDS_MAX);
        assert_non_null(o->read);
    }
    for (const struct verb *v = verbs; v->name; v++) {
        char list[400], *at = list;
        assert_order(strlen(v->options) + strlen(v->required) + 2, <, sizeof list);
        strcpy(list, v->options);
        strcat(strcat(list, " "), v->required);
        for (char *key = strtok_r(list, " ", &at); key; key = strtok_r(NULL, " ", &at))
            if (words_index(keys, key) < 0) fail_msg("%s lists '%s', which is no option", v->name, key);
    }
}

/* Of a command line nothing follows the last word. */
static void the_last_option_needs_a_value_too(void **state) {
    (void)state;
    char *argv[] = {"run", "rod-step", "ftcs", "--dx", NULL};
    struct request r = {0};
    struct failure why;
    assert_int_equal(arguments_parse(4, argv, &r, &why), STATUS_INPUT);
    assert_string_equal(why.text, "--dx needs a value: --dx DX[,DX...]");
    arguments_free(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_run_is_read),
        cmocka_unit_test(options_may_come_first),
        cmocka_unit_test(quotes_hold_blanks),
        cmocka_unit_test(a_profile_is_a_choice_of_rows),
        cmocka_unit_test(a_choice_is_set_by_its_word),
        cmocka_unit_test(lists_become_ladders),
        cmocka_unit_test(every_refusal_says_what_is_valid),
        cmocka_unit_test(the_last_option_needs_a_value_too),
        cmocka_unit_test(a_refusal_ends_where_it_should),
        cmocka_unit_test(what_is_valid_is_taken),
        cmocka_unit_test(a_line_has_room_for_so_much),
        cmocka_unit_test(more_words_follow_a_line),
        cmocka_unit_test(round_walls_fit),
        cmocka_unit_test(the_tables_agree),
        cmocka_unit_test(the_width_of_vectors_comes_from_the_environment),
    };
    return cmocka_run_group_tests_name("arguments", tests, NULL, NULL);
}
