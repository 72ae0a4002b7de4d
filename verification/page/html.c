/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The frame of a page, its style, and images that are part of it. */
#include "verification/page/html.h"

#include "solver/status.h"
#include "verification/text/letter.h"
#include "verification/text/table.h"
#include "verification/text/whole_file.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static const char style[] =
    ":root{--ink:#1b1b1b;--paper:#fff;--faint:#666;--line:#d6d6d6;--pass:#005a3c;--fail:#a3200d;--other:#6b4a00}\n"
    "@media(prefers-color-scheme:dark){:root{--ink:#e6e6e6;--paper:#151515;--faint:#a5a5a5;--line:#3d3d3d;"
    "--pass:#5fd0a5;--fail:#ff8f7a;--other:#e7b85c}}\n"
    "*{box-sizing:border-box}html{color-scheme:light dark}\n"
    "body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,sans-serif}\n"
    "main{max-width:70rem;margin:0 auto;padding:1rem}\n"
    "h1{font-size:1.7rem;line-height:1.2}h2{margin-top:2.5rem;border-bottom:1px solid var(--line)}\n"
    "h1,h2,h3,h4{break-after:avoid}a{color:inherit}\n"
    ".scroll{overflow:auto;max-height:36rem}table{border-collapse:collapse;font-size:.86rem;margin:.7rem 0}\n"
    "th,td{padding:.2rem .6rem;border-bottom:1px solid var(--line);text-align:left;vertical-align:top}\n"
    "th{position:sticky;top:0;background:var(--paper)}td:first-child{min-width:9rem}td code{overflow-wrap:normal}\n"
    "th.up{writing-mode:vertical-rl;vertical-align:bottom;padding:.3rem .1rem}\n"
    "td.n,th.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}\n"
    "code,pre{font:.84rem/1.4 "
    "ui-monospace,monospace}pre{overflow:auto;white-space:pre-wrap;overflow-wrap:anywhere;max-height:36rem;padding:."
    "6rem;border:1px solid var(--line)}\n"
    "code{overflow-wrap:anywhere}pre span{display:inline-block;max-width:100%}figure{margin:1.2rem "
    "0;break-inside:avoid}\n"
    "figure{overflow-x:auto}figure img,figure svg{height:auto;background:#fff;border:1px solid var(--line)}\n"
    "figure svg{max-width:100%}figure svg "
    "text{fill:#1b1b1b}td.n:first-child{min-width:0}table.narrow{min-width:0}figcaption{position:sticky;left:0}\n"
    "figcaption,.faint{color:var(--faint);font-size:.86rem}\n"
    ".pass{color:var(--pass)}.fail{color:var(--fail);font-weight:bold}.other{color:var(--other);font-weight:bold}\n"
    ".verdict{font-size:1.25rem}nav ul{columns:2 14rem;padding-left:1.2rem}\n"
    ".groups{columns:4 11.2rem;column-gap:.5rem;list-style:none;padding:0;font-size:.8rem}.groups "
    "li{white-space:nowrap}\n"
    "@media screen and (max-width:44rem){.wide,.scroll{overflow:auto}.scroll{max-height:80vh}\n"
    "table:has(th:nth-child(6)){min-width:64rem}table:has(tr:first-child>th.up){min-width:0}}\n"
    "@media print{@page{margin:12mm}html{font-size:9pt}body{font-size:1rem;line-height:1.35;background:#fff;"
    "color:#000}\n"
    "main{padding:0}nav{display:none}h2{margin-top:1rem}.scroll{overflow:visible;max-height:none}\n"
    "pre{white-space:pre-wrap;max-height:none;font-size:6.5pt}table{font-size:7pt;line-height:1.25}code{font-size:."
    "9em}\n"
    "td,th{position:static;white-space:normal;overflow-wrap:break-word;min-width:0}th,td{padding:.1rem .3rem}\n"
    "td:first-child{min-width:4rem}th.up{font-size:6pt}tr{break-inside:avoid}\n"
    "figure{display:inline-block;width:49%;margin:.3rem 0;padding:0 .2rem;vertical-align:top}\n"
    "figure{overflow:visible}figure img,figure svg{max-width:100%}figure "
    "img{max-height:10cm}figure.wide{display:block;width:auto}.wide img{max-height:20cm}\n"
    "section>p{break-after:avoid}figure svg{max-height:17cm}}\n";

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

/* What is no letter of UTF-8 becomes U+FFFD, a control character a blank: XML takes neither. */
static size_t put_letter(FILE *out, const char *text) {
    size_t length = letter_length(text);
    if (length)
        fwrite(text, 1, length, out);
    else
        fputs((unsigned char)*text < 0x80 ? " " : "\xEF\xBF\xBD", out);
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
    html_print(out, "%s</td>", text);
}

void html_table(FILE *out, struct table *t, int narrow) {
    int columns = t->columns, last = t->cells - columns;
    fprintf(out, "<div class=\"scroll\"><table%s>\n<tr>", narrow ? " class=\"narrow\"" : "");
    for (int i = 0; i < columns; i++) {
        fputs(is_number(t->cell[last + i]) ? "<th class=\"n\">" : "<th>", out);
        html_print(out, "%s</th>", t->cell[i]);
    }
    for (int i = columns; i < t->cells; i++) {
        fputs(i % columns ? "" : "</tr>\n<tr>", out);
        html_cell(out, t->cell[i]);
    }
    fputs("</tr>\n</table></div>\n", out);
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
