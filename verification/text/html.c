/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The frame of a page, its style, tables and images. */
#include "verification/text/html.h"

#include "solver/status.h"
#include "verification/text/utf8.h"
#include "verification/text/table.h"
#include "verification/text/whole_file.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static const char style[] =
    ":root{--ink:#1b1b1b;--paper:#fff;--faint:#666;--line:#d6d6d6;--pass:#005a3c;--fail:#a3200d;--other:#6b4a00}\n"
    "@media(prefers-color-scheme:dark){:root{--ink:#e6e6e6;--paper:#151515;--faint:#a5a5a5;--line:#3d3d3d;"
    "--pass:#5fd0a5;--fail:#ff8f7a;--other:#e7b85c}}\n"
    "*{box-sizing:border-box}html{color-scheme:light dark}a{color:inherit}\n"
    "body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,sans-serif}\n"
    "main{max-width:80rem;margin:0 auto;padding:1rem}\n"
    "h1{font-size:1.7rem;line-height:1.2;overflow-wrap:anywhere}h2{margin-top:2.5rem;border-bottom:1px solid "
    "var(--line)}\n"
    ".scroll{overflow:auto;max-height:36rem}table{border-collapse:collapse;font-size:.86rem;margin:.7rem 0}\n"
    "th,td{padding:.2rem .6rem;border-bottom:1px solid var(--line);text-align:left;vertical-align:top}\n"
    "th{position:sticky;top:0;background:var(--paper)}td:first-child{min-width:9rem}\n"
    "td.n,th.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}\n"
    "code,pre{font:.84rem/1.4 ui-monospace,monospace}code{overflow-wrap:anywhere}\n"
    "pre{overflow:auto;white-space:pre-wrap;max-height:36rem;padding:.6rem;border:1px solid var(--line)}\n"
    "pre span{display:inline-block;max-width:100%}\n"
    "figure{margin:1.2rem 0;overflow-x:auto}figure img{background:#fff;border:1px solid var(--line)}\n"
    "figcaption{position:sticky;left:0}figcaption,.faint{color:var(--faint);font-size:.86rem}\n"
    "@media(max-width:43rem){figure::before{content:\"scrolls sideways \\2192\"}}\n"
    "@media(max-width:76rem){figure.wide::before{content:\"scrolls sideways \\2192\"}}\n"
    "figure::before{position:sticky;left:0;display:block;color:var(--faint);font-size:.75rem}\n"
    "@media(min-width:78rem){figure{display:inline-block;width:49%;vertical-align:top;margin-right:.5%}\n"
    "figure.wide{display:block;width:100%}figure img{max-width:100%;height:auto}\n"
    "#scenes section{display:inline-block;width:49%;vertical-align:top;margin-right:.5%}\n"
    "#scenes figure{display:block;width:auto}}\n"
    ".pass{color:var(--pass)}.fail{color:var(--fail);font-weight:bold}.other{color:var(--other);font-weight:bold}\n"
    ".panels{display:flex;flex-wrap:wrap;gap:.5rem}.panel{flex:0 1 340px;min-width:0;height:auto}\n"
    "@media(min-width:78rem){.panel{flex-basis:300px}}\n"
    ".verdict{font-size:1.25rem;margin:.5rem 0}nav ul,.groups{columns:4 "
    "12rem;padding-left:1.2rem}summary{cursor:pointer}\n"
    "@media print{@page{margin:12mm}body{font-size:9pt;background:#fff;color:#000}main{padding:0}nav{display:none}\n"
    ".scroll,pre{overflow:visible;max-height:none}table{font-size:7pt}td,th{position:static}tr{break-inside:avoid}\n"
    "figure{overflow:visible;break-inside:avoid}figure img{max-width:100%;height:auto}}\n";

void html_open(FILE *out, const char *title) {
    fprintf(out,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<style>\n%s</style>\n",
            style);
    html_print(out, "<title>%s</title>\n</head>\n<body>\n<main>\n<h1>%s</h1>\n", title, title);
}

void html_close(FILE *out) {
    fprintf(out, "</main>\n</body>\n</html>\n");
}

/* XML allows neither invalid UTF-8, which becomes U+FFFD, nor other control characters than newlines, which become
 * blanks. */
static size_t put_letter(FILE *out, const char *text) {
    size_t length = utf8_length(text);
    if (length)
        fwrite(text, 1, length, out);
    else
        fputs(*text == '\n' ? "\n" : (unsigned char)*text < 0x80 ? " " : "\xEF\xBF\xBD", out);
    return length ? length : 1;
}

void html_bytes(FILE *out, const char *text, size_t size) {
    static const char special[] = "&<>\"";
    static const char *const name[] = {"&amp;", "&lt;", "&gt;", "&quot;"};
    for (const char *end = text + size; text < end && *text;) {
        const char *at = strchr(special, *text);
        if (at) fputs(name[at - special], out);
        text += at ? 1 : put_letter(out, text);
    }
}

void html_text(FILE *out, const char *text) {
    html_bytes(out, text, strlen(text));
}

void html_marked(FILE *out, const char *text) {
    int code = 0;
    for (size_t n; *text; text += n) {
        n = strcspn(text, "`");
        html_bytes(out, text, n);
        if (text[n] != '`') continue;
        fprintf(out, code ? "</code>" : "<code>");
        code = !code, n++;
    }
}

void html_print(FILE *out, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    for (const char *at; (at = strstr(format, "%s")); format = at + 2) {
        fwrite(format, 1, (size_t)(at - format), out);
        html_text(out, va_arg(arguments, const char *));
    }
    va_end(arguments);
    fputs(format, out);
}

void html_command(FILE *out, const char *command) {
    fprintf(out, "<pre><code><span>heatladder</span> ");
    for (size_t n; *command; command += n) {
        n = strcspn(command, " ");
        fprintf(out, "<span>");
        html_bytes(out, command, n);
        fprintf(out, "</span>");
        if (command[n]) fputc(' ', out), n++;
    }
    fprintf(out, "</code></pre>\n");
}

static int is_number(const char *text) {
    char *end;
    strtod(text, &end);
    return end != text && strspn(end, " %") == strlen(end);
}

void html_cell(FILE *out, const char *text) {
    fputs(is_number(text) ? "<td class=\"n\">" : "<td>", out);
    html_marked(out, text);
    fprintf(out, "</td>");
}

void html_table(FILE *out, struct table *t) {
    fprintf(out, "<div class=\"scroll\"><table>\n<tr>");
    for (int i = 0; i < t->columns; i++) html_print(out, "<th>%s</th>", t->cell[i]);
    for (int i = t->columns; i < t->cells; i++) {
        fputs(i % t->columns ? "" : "</tr>\n<tr>", out);
        html_cell(out, t->cell[i]);
    }
    fprintf(out, "</tr>\n</table></div>\n");
    table_free(t);
}

void html_verdict(FILE *out, const char *word) {
    int good = strcmp(word, "pass") == 0, bad = strcmp(word, "fail") == 0;
    fprintf(out, "<span class=\"%s\">%s ", good ? "pass" : bad ? "fail" : "other", good ? "✓" : bad ? "✗" : "?");
    html_print(out, "%s</span>", word);
}

/* Base 64 (RFC 4648). */
static void put_base64(FILE *out, const unsigned char *data, size_t n) {
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < n; i += 3) {
        unsigned long v = (unsigned long)data[i] << 16;
        if (i + 1 < n) v |= (unsigned long)data[i + 1] << 8;
        if (i + 2 < n) v |= data[i + 2];
        fputc(digit[v >> 18 & 63], out);
        fputc(digit[v >> 12 & 63], out);
        fputc(i + 1 < n ? digit[v >> 6 & 63] : '=', out);
        fputc(i + 2 < n ? digit[v & 63] : '=', out);
    }
}

int html_image(FILE *out, const char *path, const char *alternative) {
    FILE *in = whole_file_open(path);
    unsigned char block[3 * 1024];
    if (!in) return -1;
    html_print(out, "<img alt=\"%s\" src=\"data:image/svg+xml;base64,", alternative);
    for (size_t n; (n = fread(block, 1, sizeof block, in)) > 0;) put_base64(out, block, n);
    fprintf(out, "\">");
    fclose(in);
    return 0;
}

int html_include(FILE *out, const char *path) {
    static const char begin[] = "</h1>\n", end[] = "</main>\n";
    char *text = whole_file_at(path, NULL), *from = text ? strstr(text, begin) : NULL;
    char *to = from ? strstr(from, end) : NULL;
    if (to) fwrite(from + strlen(begin), 1, (size_t)(to - from) - strlen(begin), out);
    free(text);
    return to ? 0 : -1;
}
