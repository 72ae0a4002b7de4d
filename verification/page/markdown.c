/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Markdown to HTML, line by line: as much of it as the reports write. */
#include "verification/page/page.h"

#include "solver/status.h"
#include "verification/page/html.h"

#include <stdlib.h>
#include <string.h>

enum { UPRIGHT = 10 }; /* columns, beyond which headers stand upright */
enum block { NONE, PARAGRAPH, LIST, TABLE, CODE };

/* `code`, **strong**, *emphasis* (a word, so that 2 * 3 stays a product), [text](address). */
static void put_inline(FILE *out, const char *text) {
    while (*text) {
        const char *close = NULL, *tag = NULL;
        size_t marks = 1;
        if (*text == '\\' && text[1] && strchr("_|*`<>", text[1])) {
            html_bytes(out, text + 1, 1);
            text += 2;
            continue;
        }
        if (*text == '`' && (close = strchr(text + 1, '`'))) tag = "code";
        if (*text == '*' && text[1] != ' ' && text[1] != '*' && (close = strchr(text + 1, '*'))) tag = "em";
        if (strncmp(text, "**", 2) == 0 && (close = strstr(text + 2, "**"))) tag = "strong", marks = 2;
        if (tag) {
            fprintf(out, "<%s>", tag);
            html_bytes(out, text + marks, (size_t)(close - text) - marks);
            fprintf(out, "</%s>", tag);
            text = close + marks;
            continue;
        }
        const char *middle = *text == '[' ? strstr(text, "](") : NULL, *end = middle ? strchr(middle, ')') : NULL;
        if (end) {
            fprintf(out, "<a href=\"");
            html_bytes(out, middle + 2, (size_t)(end - middle) - 2);
            fprintf(out, "\">");
            html_bytes(out, text + 1, (size_t)(middle - text) - 1);
            fprintf(out, "</a>");
            text = end + 1;
            continue;
        }
        size_t plain = 1 + strcspn(text + 1, "\\`*[");
        html_bytes(out, text, plain);
        text += plain;
    }
}

static void end_block(FILE *out, enum block *open) {
    static const char *const close[] = {"", "</p>\n", "</ul>\n", "</table></div>\n", "</code></pre>\n"};
    fputs(close[*open], out);
    *open = NONE;
}

static void begin_block(FILE *out, enum block wanted, enum block *open) {
    static const char *const first[] = {"", "<p>", "<ul>\n", "<div class=\"scroll\"><table>\n", "<pre><code>"};
    if (*open == wanted) return;
    end_block(out, open);
    fputs(first[wanted], out);
    *open = wanted;
}

/* The next bar that is none of the text; NULL where there is none. */
static char *next_bar(char *text) {
    char *bar = strchr(text, '|');
    while (bar && bar > text && bar[-1] == '\\') bar = strchr(bar + 1, '|');
    return bar;
}

/* In bold too. */
static int is_number(const char *cell) {
    char *end;
    cell += strspn(cell, "*");
    strtod(cell, &end);
    return end != cell && end[strspn(end, "*")] == '\0';
}

/* Of a table with many columns the headers stand upright. */
static void put_row(FILE *out, char *line, int header) {
    char *cell = line + 1;
    int columns = 0;
    for (char *bar = cell; (bar = next_bar(bar)); bar++) columns++;
    const char *upright = header && columns > UPRIGHT ? " class=\"up\"" : "";
    fprintf(out, "<tr>");
    for (char *bar; (bar = next_bar(cell)); cell = bar + 1) {
        *bar = '\0';
        cell += strspn(cell, " ");
        for (char *last = bar; last > cell && last[-1] == ' ';) *--last = '\0';
        fprintf(out, "<t%c%s>", header ? 'h' : 'd', is_number(cell) ? " class=\"n\"" : upright);
        put_inline(out, cell);
        fprintf(out, "</t%c>", header ? 'h' : 'd');
    }
    fprintf(out, "</tr>\n");
}

static void put_line(FILE *out, char *line, int deeper, enum block *open) {
    size_t marks = strspn(line, "#");
    if (*line == '\0') {
        if (*open != CODE) end_block(out, open);
    } else if (marks > 0 && line[marks] == ' ') {
        int level = (int)marks + deeper < 6 ? (int)marks + deeper : 6;
        end_block(out, open);
        fprintf(out, "<h%d>", level);
        put_inline(out, line + marks + 1);
        fprintf(out, "</h%d>\n", level);
    } else if (strncmp(line, "    ", 4) == 0 && *open != LIST) {
        begin_block(out, CODE, open);
        html_text(out, line + 4);
        fputc('\n', out);
    } else if (*line == '|') {
        int header = *open != TABLE;
        begin_block(out, TABLE, open);
        if (strspn(line, "|-: ") < strlen(line)) put_row(out, line, header);
    } else if (strncmp(line, "- ", 2) == 0) {
        begin_block(out, LIST, open);
        fprintf(out, "<li>");
        put_inline(out, line + 2);
    } else {
        if (*open != LIST) begin_block(out, PARAGRAPH, open);
        put_inline(out, line);
        fputc('\n', out);
    }
}

void markdown_write(FILE *out, FILE *in, int deeper) {
    char *line = NULL;
    size_t room = 0;
    enum block open = NONE;
    for (ssize_t n; (n = getline(&line, &room, in)) >= 0;) {
        if (n > 0 && line[n - 1] == '\n') line[n - 1] = '\0';
        put_line(out, line, deeper, &open);
    }
    if (!feof(in) && !ferror(in)) xcheck(NULL, room, 2); /* getline has no memory */
    end_block(out, &open);
    free(line);
}
