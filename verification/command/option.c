/* The table of options, and the readers of their values.  A value is taken whole or refused; the text of a refusal
 * names the option, the value, and what would be valid. */
#include "verification/command/option.h"

#include "references/scene.h"
#include "verification/text/number.h"
#include "verification/command/request.h"
#include "verification/command/stack.h"
#include "verification/text/words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The smallest number that counts as positive: a bound of the table is inclusive. */
#define ABOVE_ZERO 1e-300

static void *place(struct request *r, const struct option *o) {
    return (char *)r + o->offset;
}

static int read_flag(struct request *r, const struct option *o, const char *text, struct failure *why) {
    (void)text, (void)why;
    *(int *)place(r, o) = 1;
    return STATUS_OK;
}

static int read_text(struct request *r, const struct option *o, const char *text, struct failure *why) {
    if (*text == '\0') return refuse(why, STATUS_INPUT, "--%s: empty; valid: %s", o->name, o->value);
    *(const char **)place(r, o) = text;
    return STATUS_OK;
}

static int refuse_number(const struct option *o, const char *text, struct failure *why) {
    char valid[80];
    if (o->lo == ABOVE_ZERO && o->hi == INFINITY)
        snprintf(valid, sizeof valid, "a number > 0");
    else if (o->lo == -INFINITY)
        snprintf(valid, sizeof valid, "a finite number");
    else if (o->hi == INFINITY)
        snprintf(valid, sizeof valid, "a number >= %g", o->lo);
    else
        snprintf(valid, sizeof valid, "a number from %g to %g", o->lo, o->hi);
    return refuse(why, STATUS_INPUT, "--%s %.60s: must be %s", o->name, text, valid);
}

static int read_number(struct request *r, const struct option *o, const char *text, struct failure *why) {
    double value;
    if (number_read(text, &value) || value < o->lo || value > o->hi) return refuse_number(o, text, why);
    *(double *)place(r, o) = value;
    return STATUS_OK;
}

static int read_numbers(struct request *r, const struct option *o, const char *text, struct failure *why) {
    struct numbers *list = place(r, o);
    list->count = number_read_list(text, list->value, NUMBERS_MAX);
    list->text = text;
    if (list->count < 0)
        return refuse(why, STATUS_INPUT, "--%s '%.60s': must be 1 to %d numbers with commas between, such as %s",
                      o->name, text, NUMBERS_MAX, o->lo >= 0 ? "0.1,0.05,4/160" : "-0.3,0.7");
    for (int i = 0; i < list->count; i++)
        if (list->value[i] < o->lo || list->value[i] > o->hi) return refuse_number(o, text, why);
    return STATUS_OK;
}

/* T,T,... or FROM:TO:COUNT, evenly, both ends with them. */
static int read_times(struct request *r, const struct option *o, const char *text, struct failure *why) {
    enum { MOST = 10000000 };
    const char *first = strchr(text, ':'), *last = strrchr(text, ':');
    char word[2][40];
    long count = 0;
    r->times = 0;
    if (!first) return read_numbers(r, o, text, why);
    int bad = last == first || first - text >= 40 || last - first > 40;
    for (int k = 0; k < 2 && !bad; k++) {
        const char *from = k ? first + 1 : text;
        snprintf(word[k], sizeof word[k], "%.*s", (int)((k ? last : first) - from), from);
        bad = number_read(word[k], &r->time.value[k]) || r->time.value[k] < o->lo;
    }
    if (bad || number_read_whole(last + 1, MOST, &count) || count < 2)
        return refuse(why, STATUS_INPUT,
                      "--%s '%.60s': must be numbers with commas between, or FROM:TO:COUNT, such as "
                      "0:1.5:16, with a COUNT from 2 to %d",
                      o->name, text, MOST);
    r->time.count = 2, r->time.text = text, r->times = (int)count;
    return STATUS_OK;
}

static int read_whole(struct request *r, const struct option *o, const char *text, struct failure *why) {
    long value;
    if (number_read_whole(text, (long)o->hi, &value) || value < (long)o->lo)
        return refuse(why, STATUS_INPUT, "--%s %.60s: must be a whole number from %.0f to %.0f", o->name, text, o->lo,
                      o->hi);
    *(int *)place(r, o) = (int)value;
    return STATUS_OK;
}

static int read_order_of(struct request *r, const struct option *o, const char *text, struct failure *why) {
    long value;
    if (number_read_whole(text, 4, &value) || value == 0 || value == 3)
        return refuse(why, STATUS_INPUT, "--%s %.60s: must be 1, 2 or 4", o->name, text);
    *(int *)place(r, o) = (int)value;
    return STATUS_OK;
}

static int read_seed(struct request *r, const struct option *o, const char *text, struct failure *why) {
    long value;
    if (number_read_whole(text, 4294967295, &value))
        return refuse(why, STATUS_INPUT, "--%s %.60s: must be a whole number from 0 to 4294967295", o->name, text);
    r->experiment.options.seed = (unsigned long)value;
    return STATUS_OK;
}

/* An enumerator has the size of an int; its place is written as bytes, since each is a type of its own. */
static int read_word(struct request *r, const struct option *o, const char *text, struct failure *why) {
    int value = words_index(o->words, text);
    if (value < 0) return words_unknown(o->words, o->name, text, why);
    memcpy(place(r, o), &value, sizeof value);
    return STATUS_OK;
}

static int read_h(struct request *r, const struct option *o, const char *text, struct failure *why) {
    if (strcmp(text, "iso") != 0) {
        if (read_number(r, o, text, why) == STATUS_OK) return STATUS_OK;
        return refuse(why, STATUS_INPUT, "--h %.60s: must be a number > 0, or iso", text);
    }
    r->experiment.options.h_iso = 1;
    return STATUS_OK;
}

static int read_choice(const struct param *p, const char *text, double *value, struct failure *why) {
    int index = words_index(p->choice, text);
    if (index < 0) return words_unknown(p->choice, p->name, text, why);
    *value = index;
    return STATUS_OK;
}

static int set_param(struct request *r, const char *name, const char *text, struct failure *why) {
    const struct param *table = r->experiment.scene->params;
    const char *names[PARAM_MAX + 1] = {0};
    char what[64];
    for (int i = 0; table[i].name; i++) names[i] = table[i].name;
    int i = words_index(names, name);
    snprintf(what, sizeof what, "parameter of %s", r->experiment.scene->name);
    if (i < 0) return words_unknown(names, what, name, why);
    if (r->overridden & 1ul << i) return refuse(why, STATUS_INPUT, "parameter '%s' is given twice", name);
    r->overridden |= 1ul << i;
    if (table[i].choice) return read_choice(&table[i], text, &r->experiment.problem.param[i], why);
    if (number_read(text, &r->experiment.problem.param[i]) == 0) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "--set %s=%.60s: must be a finite number%s%s", name, text,
                  *table[i].unit ? ", in " : "", table[i].unit);
}

static int read_set(struct request *r, const struct option *o, const char *text, struct failure *why) {
    char name[64];
    size_t length = strcspn(text, "=");
    if (text[length] != '=' || length == 0 || length >= sizeof name)
        return refuse(why, STATUS_INPUT, "--%s '%.60s': must be NAME=VALUE", o->name, text);
    memcpy(name, text, length);
    name[length] = '\0';
    return set_param(r, name, text + length + 1, why);
}

static int read_t_end(struct request *r, const struct option *o, const char *text, struct failure *why) {
    (void)o;
    return set_param(r, "t_end", text, why);
}

static int read_columns(struct request *r, const struct option *o, const char *text, struct failure *why) {
    (void)o;
    return samples_columns_read(text, &r->experiment.program.columns, why);
}

static int read_vary(struct request *r, const struct option *o, const char *text, struct failure *why) {
    static const char *const taken[] = {"case", "out", "dx", NULL};
    struct program *g = &r->experiment.program;
    struct numbers *list = &r->rungs.vary;
    size_t length = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
    snprintf(g->vary, sizeof g->vary, "%.*s", (int)(length < sizeof g->vary ? length : 0), text);
    if (!*g->vary || text[length] != '=' || words_index(taken, g->vary) >= 0)
        return refuse(why, STATUS_INPUT,
                      "--%s '%.60s': must be NAME=A,B,C,..., NAME of letters, digits and _, and not "
                      "case, out or dx",
                      o->name, text);
    list->count = number_read_list(text + length + 1, list->value, NUMBERS_MAX);
    for (int i = 0; i < list->count; i++)
        if (!(list->value[i] > 0)) list->count = -1;
    if (list->count > 0) return STATUS_OK;
    return refuse(why, STATUS_INPUT, "--%s '%.60s': must be NAME=A,B,C,... with 1 to %d numbers > 0", o->name, text,
                  NUMBERS_MAX);
}

#define IN(member) offsetof(struct request, member)
#define POSITIVE ABOVE_ZERO, INFINITY
#define FINITE -INFINITY, INFINITY
const struct option options_table[] = {
    {"dx", "dx", "DX[,DX...]", "spacing, m; several for a ladder; fractions too (4/42)", read_numbers, IN(rungs.dx),
     NULL, POSITIVE, 0},
    {"dt", "dt", "DT[,DT...]", "time step, s; several for a ladder in time", read_numbers, IN(rungs.dt), NULL,
     POSITIVE, 0},
    {"fourier", "fourier", "F[,F...]", "time step as the mesh Fourier number dt max(kappa)/dx^2", read_numbers,
     IN(rungs.fourier), NULL, POSITIVE, 0},
    {"stepper", "stepper", "S", "time stepper; auto takes one whose error is under 1 % of the whole", read_word,
     IN(experiment.options.stepper), stepper_words, 0, 0, 1},
    {"kernel", "kernel", "K", "smoothing kernel", read_word, IN(experiment.options.kernel), kernel_words, 0, 0, 1},
    {"h", "h", "H",
     "smoothing length over dx, 0.55 times the order where not given; or iso: the ratio with an isotropic error",
     read_h, IN(experiment.options.h), NULL, POSITIVE, 1},
    {"dim", "dim", "D", "1 for a rod, 2 for a square", read_whole, IN(dim), NULL, 1, 2, 0},
    {"stages", "stages", "N", "stages of --stepper rkl2", read_whole, IN(stages), NULL, 3, 99, 0},
    {"ratio", "ratio", "R", "kappa_y/kappa_x of a square, up to 1 (default): F is of the larger one, along x",
     read_number, IN(ratio), NULL, ABOVE_ZERO, 1, 0},
    {"order", "order", "P", "Taylor order, 2 (default) to 4", read_whole, IN(experiment.options.order), NULL, 2, 4,
     1},
    {"layout", "layout", "L",
     "where the particles are: at cell centres, on the walls too, moved at random, settled after that, in hexagons, "
     "in cells that grow",
     read_word, IN(experiment.options.layout), layout_words, 0, 0, 1},
    {"jitter", "jitter", "A",
     "particles lie within +-A dx of the lattice's, 0 to 0.5; relaxed: at the start, 0.5 where not given",
     read_number, IN(experiment.options.jitter), NULL, 0, 0.5, 1},
    {"grading", "grading", "R",
     "graded: width of the last cell over the first's along each axis, 1 to 4, 4 where not given", read_number,
     IN(experiment.options.grading), NULL, 1, 4, 1},
    {"sweeps", "sweeps", "N", "relaxed: the most sweeps until particles have settled, 2000 where not given",
     read_whole, IN(experiment.options.sweeps), NULL, 1, 1000000, 1},
    {"redraw", "redraw", "N",
     "draw the cloud anew every N steps (--dt, --fourier), T carried over by SSPH of order 2", read_whole,
     IN(experiment.options.redraw), NULL, 1, 1000000000, 1},
    {"seed", "seed", "N", "seed of the jitter, 0 where not given", read_seed, IN(experiment.options.seed), NULL, 0, 0,
     1},
    {"sampling", "sampling", "S", "how the initial data are sampled", read_word, IN(experiment.options.sampling),
     sampling_words, 0, 0, 1},
    {"walls", "walls", "W", "what the ghosts beyond a wall hold", read_word, IN(experiment.options.walls),
     walls_words, 0, 0, 1},
    {"mean", "mean", "M", "mean of two conductivities", read_word, IN(experiment.options.mean), mean_words, 0, 0, 1},
    {"volume", "volume", "V", "volume of a particle", read_word, IN(experiment.options.volume), volume_words, 0, 0,
     1},
    {"xi", "xi", "XI", "Pamplona's xi for --volume tuned, m; 9 h^(1/3) where not given", read_number,
     IN(experiment.options.xi), NULL, POSITIVE, 1},
    {"domain", "domain", "D",
     "what is computed: of a scene with mirror planes the half or quarter that is needed, or all", read_word,
     IN(experiment.options.domain), domain_words, 0, 0, 0},
    {"threads", "threads", "N", "threads that one run may use, 1 where not given", read_whole,
     IN(experiment.options.threads), NULL, 1, THREADS_MOST, 0},
    {"t-end", "t-end", "T", "end time, s; the same as --set t_end=T", read_t_end, 0, NULL, FINITE, 2},
    {"set", "set", "NAME=VALUE", "override a parameter of the scene (see: heatladder list scenes)", read_set, 0, NULL,
     FINITE, 2},
    {"error", "error", "E", "the error (E1) to be reached", read_number, IN(error), NULL, POSITIVE, 0},
    {"scene", "scene", "SCENE", "that scene alone", read_text, IN(bench_scene), NULL, FINITE, 0},
    {"peers", "peers", NULL, "the codes of others beside ours (make setup-peers), from the root of the sources",
     read_flag, IN(peers), NULL, FINITE, 0},
    {"time-error", "time-error", "E", "take the longest time step whose error (E1) is E, by step doubling",
     read_number, IN(experiment.time_error), NULL, 1e-12, INFINITY, 0},
    {"solver", "solver", "'CMD'", "a program that stands in for METHOD; {case} and {out} in CMD become paths",
     read_text, IN(experiment.program.solver), NULL, FINITE, 0},
    {"results", "results", "DIR", "judge the answers that lie in DIR/SCENE/DX", read_text,
     IN(experiment.program.results), NULL, FINITE, 0},
    {"into", "into", "DIR", "write DIR/SCENE/DX/case, and DIR/cases.txt with a directory a line", read_text, IN(into),
     NULL, FINITE, 0},
    {"keep", "keep", "DIR", "keep case, answer and log of each run of --solver in DIR/SCENE/DX", read_text,
     IN(experiment.program.keep), NULL, FINITE, 0},
    {"timeout", "timeout", "S", "end what --solver runs after S seconds", read_number, IN(experiment.program.timeout),
     NULL, POSITIVE, 0},
    {"quantity", "quantity", "Q",
     "judge flux_x_lo, flux_x_hi, flux_y_lo, flux_y_hi, heat, or at:X[,Y], not the field", read_text,
     IN(experiment.derived), NULL, FINITE, 0},
    {"fine", "fine", "DT", "of a ladder in time: a finer step, s, whose run all are measured against", read_number,
     IN(rungs.fine), NULL, POSITIVE, 0},
    {"vary", "vary", "NAME=A,B,C", "a ladder in a parameter of the program: {NAME} in its command, NAME in its case",
     read_vary, 0, NULL, FINITE, 0},
    {"columns", "columns", "MAP", "what the columns of an answer are called: x=X,y=Y,T=temp,w=volume", read_columns,
     0, NULL, FINITE, 0},
    {"warm-up", "warm-up", NULL, "solve for 0.1 s beforehand, so that what is timed finds program and memory ready",
     read_flag, IN(warm_up), NULL, FINITE, 0},
    {"field", "field", "FILE", "write the points, the temperature and the exact one as CSV", read_text,
     IN(field_path), NULL, FINITE, 0},
    {"expect", "expect", "LO,HI", "the band that the slope's interval must lie in; 1 or 4 where it does not",
     read_numbers, IN(rungs.expect), NULL, FINITE, 0},
    {"ceiling", "ceiling", "E", "the most that the error at the finest rung may be; exit status 1 where it is more",
     read_number, IN(rungs.ceiling), NULL, POSITIVE, 0},
    {"norm", "norm", "N", "the norm that is fitted and judged: E1, L2, Linf, or E1 far from walls or near them",
     read_word, IN(rungs.norm), ladder_norm_words, 0, 0, 0},
    {"at", "at", "X[,Y]", "where, m; ladder without a scene: the temperature there is one of its quantities",
     read_numbers, IN(at), NULL, FINITE, 0},
    {"time", "time", "T[,T...]", "when, s; FROM:TO:COUNT: evenly, the ends too", read_times, IN(time), NULL, 0,
     INFINITY, 0},
    {"points", "points", "FILE", "CSV of points x or x,y, m; - for standard input", read_text, IN(points), NULL,
     FINITE, 0},
    {"what", "what", "LIST", "columns to tell at each point, with commas between; temperature if left out", read_text,
     IN(what), NULL, FINITE, 0},
    {"cell", "dx", "DX", "extent of the cell around each point, m, for initial_mean", read_numbers, IN(rungs.dx),
     NULL, POSITIVE, 0},
    {"only", "only", "GLOB", "only those whose name matches, such as '*gauss*'", read_text, IN(only), NULL, FINITE,
     0},
    {"skip", "skip", "GLOB", "leave out those whose name matches", read_text, IN(skip), NULL, FINITE, 0},
    {"gates", "gates", "FILE",
     "judge the rows of FILE, GATE(\"id\", QUICK, \"measure\", \"command\", lo, hi, ceiling, "
     "\"why\"), instead of those that are built in",
     read_text, IN(gates_path), NULL, FINITE, 0},
    {"battery", "battery", NULL, "the cases of the battery, all that verify --results DIR asks for", read_flag,
     IN(battery), NULL, FINITE, 0},
    {"order-of", "order", "P", "the order of the code in space: 1, 2 (default) or 4", read_order_of, IN(order), NULL,
     1, 4, 0},
    {"quick", "quick", NULL, "the quick tier alone", read_flag, IN(quick), NULL, FINITE, 0},
    {"verbose", "verbose", NULL,
     "every gate, not only how many of each group hold; of a ladder a diagnosis in any case; -v is the same",
     read_flag, IN(verbose), NULL, FINITE, 0},
    {"page", "page", "FILE", "write the verdict, its table and chart as one HTML page", read_text, IN(page_path),
     NULL, FINITE, 0},
    {"junit", "junit", "FILE", "write the verdicts as JUnit XML", read_text, IN(junit_path), NULL, FINITE, 0},
    {"json-file", "json", "FILE", "write the verdicts as JSON", read_text, IN(json_path), NULL, FINITE, 0},
    {"json", "json", NULL, "JSON instead of text", read_flag, IN(json), NULL, FINITE, 0},
    {0}};
_Static_assert(sizeof options_table / sizeof *options_table - 1 <= 64, "struct request has a bit for each row");

const struct option *option_find(const char *allowed, const char *name) {
    for (const struct option *o = options_table; o->key; o++)
        if (strcmp(o->name, name) == 0 && words_among(allowed, o->key)) return o;
    return NULL;
}
