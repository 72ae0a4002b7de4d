/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One text in two languages. */
#include "reports/figure/document.h"

#include "verification/text/html.h"

#include <stdarg.h>
#include <string.h>

enum { TEXT = 4000 };

static void put_html(FILE *out, const char *text) {
    int code = 0;
    for (size_t n; *text; text += n) {
        n = strcspn(text, "`");
        html_bytes(out, text, n);
        if (text[n] != '`') continue;
        fprintf(out, code ? "</code>" : "<code>");
        code = !code, n++;
    }
}

/* A bar would end a cell; <, >, * and _ are Markdown's outside of code. */
static void put_markdown(FILE *out, const char *text) {
    int code = 0;
    for (; *text; text++) {
        code ^= *text == '`';
        if (strchr(code ? "|" : "|<>*_", *text)) fputc('\\', out);
        fputc(*text, out);
    }
}

static void put_both(struct document *d, const char *text) {
    put_markdown(d->md, text);
    put_html(d->html, text);
}

static void end_table(struct document *d) {
    if (d->columns) fputc('\n', d->md), fprintf(d->html, "</tr>\n</table></div>\n");
    d->columns = d->cells = d->heading = 0;
}

void document_open(struct document *d, const char *dir, const char *name, const char *title) {
    *d = (struct document){0};
    d->md = output_open(&d->page[0], "%s/%s.md", dir, name);
    d->html = output_open(&d->page[1], "%s/%s.html", dir, name);
    fprintf(d->md, "# %s\n", title);
    html_open(d->html, title);
}

int document_close(struct document *d, struct failure *why) {
    end_table(d);
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
    end_table(d);
    fprintf(d->md, "\n## %s\n", text);
    html_print(d->html, "<h4>%s</h4>\n", text);
}

void document_text(struct document *d, const char *format, ...) {
    TEXT_OF(format);
    end_table(d);
    fputc('\n', d->md);
    fprintf(d->html, "<p>");
    put_both(d, text);
    fputc('\n', d->md);
    fprintf(d->html, "</p>\n");
}

void document_command(struct document *d, const char *format, ...) {
    TEXT_OF(format);
    end_table(d);
    fprintf(d->md, "\n    heatladder %s\n", text);
    html_command(d->html, text);
}

void document_table(struct document *d, const char *headers) {
    end_table(d);
    d->heading = 1;
    fprintf(d->md, "\n|");
    fprintf(d->html, "<div class=\"scroll\"><table>\n<tr>");
    for (size_t n; *headers; headers += n + (headers[n] == '|')) {
        n = strcspn(headers, "|");
        document_header(d, "%.*s", (int)n, headers);
    }
}

void document_header(struct document *d, const char *format, ...) {
    TEXT_OF(format);
    d->columns++;
    fprintf(d->md, " %s |", text);
    html_print(d->html, "<th>%s</th>", text);
}

void document_cell(struct document *d, const char *format, ...) {
    TEXT_OF(format);
    if (d->heading) {
        fprintf(d->md, "\n|");
        for (int i = 0; i < d->columns; i++) fprintf(d->md, "---|");
    }
    if (d->cells == 0) {
        fprintf(d->md, "\n|");
        fprintf(d->html, "</tr>\n<tr>");
    }
    d->heading = 0;
    fputc(' ', d->md);
    put_markdown(d->md, text);
    fprintf(d->md, " |");
    if (strchr(text, '`')) {
        fprintf(d->html, "<td>");
        put_html(d->html, text);
        fprintf(d->html, "</td>");
    } else {
        html_cell(d->html, text);
    }
    d->cells = (d->cells + 1) % d->columns;
}
