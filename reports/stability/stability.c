/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pages about stability, and their common parts. */
#include "reports/stability/stability.h"

#include "reports/figure/figure.h"
#include "verification/text/output.h"

#include <stdarg.h>

static const struct figure_page pages[] = {
    {"stability_limits", stability_limits_page},
    {"stability_jitter", stability_jitter_page},
    {"stability_blowup", stability_blowup_page},
    {"stability_checkerboard", stability_checkerboard_page},
};

void stability_head(FILE *out, const char *title, const char *command) {
    fprintf(out, "# title: %s\n# made by: heatladder report stability DIR\n# command: heatladder %s\n", title,
            command);
}

void stability_block(FILE *out, const char *columns, const char *name, ...) {
    va_list arguments;
    va_start(arguments, name);
    fprintf(out, "\n\n# ");
    vfprintf(out, name, arguments);
    fprintf(out, "\n%s\n", columns);
    va_end(arguments);
}

struct model_problem stability_model(const char *method, int dim, enum kernel_name kernel, double h) {
    return (struct model_problem){.method = method_find(method), .dim = dim, .options = {.kernel = kernel, .h = h}};
}

int stability_write(const char *dir, struct failure *why) {
    if (output_directory(dir, "stability_limits.csv", why)) return why->status;
    return figure_pages(pages, sizeof pages / sizeof *pages, dir, why);
}
