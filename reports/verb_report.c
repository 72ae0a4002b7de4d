/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heatladder report: the studies of reports/, measured again.  Progress and times go to standard output, not into any
 * file.  A study is a row of the table. */
#include "verification/cli/verb.h"

#include "reports/field/field_study.h"
#include "reports/front/front_study.h"
#include "reports/index/index.h"
#include "reports/ledger/claims.h"
#include "reports/matched/matched_figures.h"
#include "reports/operators/operators.h"
#include "reports/pamplona/pamplona.h"
#include "reports/papers.h"
#include "reports/song/song.h"
#include "reports/space/space_study.h"
#include "reports/stability/stability.h"
#include "reports/walls/walls_study.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/text/output.h"

#include <omp.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static int write_page(const char *dir, struct failure *why) {
    if (index_write(dir, why)) return why->status;
    printf("page: %s/index.html\n", dir);
    return STATUS_OK;
}

/* By default: the papers' tables and figures, the matched run and the jump in space. */
static const struct study {
    const char *name;
    int (*write)(const char *dir, struct failure *why);
    const char *title; /* printed at the end, for a study that is written by default; NULL: only by its name */
    const char *first; /* one of its files, opened before anything is measured; NULL: the study opens it */
} studies[] = {
    {"song", song_write, "Song 2018", "song_table1.md"},
    {"pamplona", pamplona_write, "Pamplona 2019", "pamplona_table1.md"},
    {"matched", matched_figures_write, "the matched run", "matched_fig1.csv"},
    {"space", space_study_write, "the jump in space", "space_fig1.csv"},
    {"operators", operators_write, NULL, NULL},
    {"stability", stability_write, NULL, NULL},
    {"walls", walls_study_write, NULL, NULL},
    {"front", front_study_write, NULL, NULL},
    {"field", field_study_write, NULL, NULL},
    {"page", write_page, NULL, NULL},
};
static const char *const names[] = {"song",  "pamplona", "matched", "space",  "operators", "stability",
                                    "walls", "front",    "field",   "claims", "page",      NULL};

static int write_study(const struct study *s, const char *dir, struct failure *why) {
    double start = omp_get_wtime();
    if (s->first && output_directory(dir, s->first, why)) return why->status;
    if (s->write(dir, why)) return why->status;
    if (s->title) printf("%s: tables and data of figures in %s (%.2f s)\n", s->title, dir, omp_get_wtime() - start);
    return STATUS_OK;
}

static int write_studies(const char *name, const char *dir, struct failure *why) {
    for (size_t i = 0; i < sizeof studies / sizeof *studies; i++) {
        const struct study *s = &studies[i];
        if (name ? strcmp(s->name, name) != 0 : !s->title) continue;
        if (write_study(s, dir, why)) return why->status;
    }
    return STATUS_OK;
}

struct report_options {
    struct command command;
    char *only;            /* owned: globs of claims; NULL: all */
    const char *json_path; /* NULL for none */
};

static int measure_claims(const struct report_options *r, const char *dir, struct claims *c, struct failure *why) {
    if (dir && output_directory(dir, "claims.md", why)) return why->status;
    if (output_check(r->json_path, why)) return why->status;
    if (claims_collect(papers_claims, r->only, c, why)) return why->status;
    claims_run(c);
    (dir ? claims_write_changed : claims_write_text)(c, stdout);
    if (r->json_path) {
        struct output page;
        claims_write_json(c, output_open(&page, "%s", r->json_path));
        if (output_close(&page, 1, why)) return why->status;
    }
    return dir ? claims_write_files(c, dir, why) : STATUS_OK;
}

/* The ledger: the statements of the papers, whole on standard output where there is no directory. */
static int report_claims(const struct report_options *r, const char *dir, struct failure *why) {
    struct claims claims = {0};
    int status = measure_claims(r, dir, &claims, why);
    if (!status && !claims_hold(&claims)) status = STATUS_GATE;
    claims_free(&claims);
    return status;
}

/* The first word is a study or a directory (one that exists, or a path with a slash); after a study the second is a
 * directory. */
static int act(const void *options, struct failure *why) {
    const struct report_options *r = options;
    const char *const *word = r->command.word, *study = word[0], *dir = word[1];
    if (study && words_index(names, study) < 0) {
        int is_path = strchr(study, '/') || access(study, F_OK) == 0;
        if (dir || !is_path) {
            words_unknown(names, "study", study, why);
            words_add(why->text, sizeof why->text, "; a new directory is ./%.60s", study);
            return why->status;
        }
        dir = study, study = NULL;
    }
    if (study && strcmp(study, "claims") == 0) return report_claims(r, dir, why);
    if (r->only || r->json_path)
        return refuse(why, STATUS_INPUT, "--%s has a meaning for report claims alone", r->only ? "only" : "json");
    return write_studies(study, dir ? dir : "reports/out", why);
}

#define PLACE(member) OPTION_PLACE(report_options, member)
static const struct option own[] = {{"only", "GLOB[,GLOB...]", "claims: only names that match; may be repeated",
                                     option_globs, PLACE(only), .repeats = 1},
                                    JSON_OPTION(PLACE(json_path), "the claims"),
                                    {0}};

static const struct command_syntax syntax = {"report", "[STUDY] [DIR]", "", "", NULL};

const struct verb verb_report = {
    &syntax, own, sizeof(struct report_options),
    "measure a study and write it into DIR: song, pamplona, matched, space (by default these four), operators, "
    "stability, walls, front, field, claims; page: one page of all in DIR",
    act};
