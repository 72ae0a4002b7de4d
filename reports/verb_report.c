/* heatladder report: the papers' tables and figures, measured again.  Progress and times go to standard output, not
 * into any file. */
#include "verification/command/verb.h"

#include "reports/matched/matched_figures.h"
#include "reports/pamplona/pamplona.h"
#include "reports/song/song.h"
#include "solver/method.h"
#include "verification/command/request.h"
#include "verification/text/output.h"

#include <omp.h>
#include <stdio.h>

/* The parts of the report, in the order that they are made. */
static const struct {
    const char *name;
    int (*write)(const char *dir, struct failure *why);
} parts[] = {
    {"Song 2018", song_write},
    {"Pamplona 2019", pamplona_write},
    {"the matched run", matched_figures_write},
};

static int write_parts(const char *dir, struct failure *why) {
    if (output_directory(dir, "song_table1.csv", why)) return why->status;
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        double start = omp_get_wtime();
        if (parts[i].write(dir, why)) return why->status;
        printf("%s: tables and data of figures in %s (%.2f s)\n", parts[i].name, dir, omp_get_wtime() - start);
    }
    return STATUS_OK;
}

int verb_report(const struct request *r, struct failure *why) {
    return write_parts(r->dir ? r->dir : "reports/out", why);
}
