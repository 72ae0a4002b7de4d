/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One text in two languages. */
#include "reports/figure/document.h"

#include "verification/text/html.h"

#include <stdarg.h>
#include <string.h>

enum { TEXT = 4000 };

/* A bar would end a cell; <, >, * and _ are Markdown's outside of code. */
static void put_markdown(FILE *out, const char *text) {
    int code = 0;
    for (; *text; text++) {
        code ^= *text == '`';
        if (strchr(code ? "|" : "|<>*_", *text)) fputc('\\', out);
        fputc(*text, out);
    }
}

void document_open(struct document *d, const char *dir, const char *name, const char *title) {
    *d = (struct document){0};
    d->md = output_open(&d->page[0], "%s/%s.md", dir, name);
    d->html = output_open(&d->page[1], "%s/%s.html", dir, name);
    fprintf(d->md, "# %s\n", title);
    html_open(d->html, title);
}

int document_close(struct document *d, struct failure *why) {
    html_close(d->html);
    return output_close(d->page, 2, why);
}

void document_drop(struct document *d) {
    output_drop(d->page, 2);
}

#define TEXT_OF(format)                                                                                              \
    char text[TEXT];                                                                                                 \
    va_list arguments;                                                                                               \
    va_start(arguments, format);                                                                                     \
    vsnprintf(text, sizeof text, format, arguments);                                                                 \
    va_end(arguments)

void document_heading(struct document *d, const char *format, ...) {
    TEXT_OF(format);
    fprintf(d->md, "\n## %s\n", text);
    html_print(d->html, "<h4>%s</h4>\n", text);
}

void document_text(struct document *d, const char *format, ...) {
    TEXT_OF(format);
    fputc('\n', d->md);
    put_markdown(d->md, text);
    fputc('\n', d->md);
    fprintf(d->html, "<p>");
    html_marked(d->html, text);
    fprintf(d->html, "</p>\n");
}

void document_command(struct document *d, const char *format, ...) {
    TEXT_OF(format);
    fprintf(d->md, "\n    heatladder %s\n", text);
    html_command(d->html, text);
}

void document_table(struct document *d, struct table *t) {
    for (int i = 0; i < t->cells; i++) {
        fputs(i % t->columns ? " " : "\n| ", d->md);
        put_markdown(d->md, t->cell[i]);
        fputs(" |", d->md);
        if (i == t->columns - 1) {
            fputs("\n|", d->md);
            for (int k = 0; k < t->columns; k++) fputs("---|", d->md);
        }
    }
    fputc('\n', d->md);
    html_table(d->html, t);
}
