/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pages: what is escaped, what Markdown becomes, what a chart holds, and gates that are read back. */
#include "verification/page/chart.h"
#include "verification/page/html.h"
#include "verification/page/page.h"

#include "reports/index/index.h"
#include "solver/status.h"
#include "verification/command/arguments.h"
#include "verification/foreign/program.h"
#include "verification/gates/gates.h"
#include "verification/ladder/ladder.h"
#include "verification/text/table.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char text[20000];

static FILE *begin(void) {
    memset(text, 0, sizeof text);
    return fmemopen(text, sizeof text - 1, "w");
}

static const char *markdown(const char *from) {
    char copy[2000];
    snprintf(copy, sizeof copy, "%s", from);
    FILE *in = fmemopen(copy, strlen(copy), "r"), *out = begin();
    markdown_write(out, in, 1);
    fclose(in);
    fclose(out);
    return text;
}

static void markdown_becomes_html(void **state) {
    (void)state;
    assert_string_equal(markdown("# A < B\n"), "<h2>A &lt; B</h2>\n");
    assert_string_equal(markdown("one\ntwo\n\nthree\n"), "<p>one\ntwo\n</p>\n<p>three\n</p>\n");
    assert_string_equal(markdown("    x && y\n"), "<pre><code>x &amp;&amp; y\n</code></pre>\n");
    assert_string_equal(markdown("`a*b` and *much*, 2 * 3, so\\_ssph\n"),
                        "<p><code>a*b</code> and <em>much</em>, 2 * 3, so_ssph\n</p>\n");
    assert_string_equal(markdown("**bold**, **a*b** and ** 2\n"),
                        "<p><strong>bold</strong>, <strong>a*b</strong> and ** 2\n</p>\n");
    assert_string_equal(markdown("\\|G\\| \\<= 1, \\*not\\*\n"), "<p>|G| &lt;= 1, *not*\n</p>\n");
    assert_string_equal(markdown("- see [there](a.md)\n"), "<ul>\n<li>see <a href=\"a.md\">there</a></ul>\n");
    assert_string_equal(markdown("| a | \\|b\\| |\n|---|---:|\n| 1.5 | two |\n"),
                        "<div class=\"scroll\"><table>\n<tr><th>a</th><th>|b|</th></tr>\n"
                        "<tr><td class=\"n\">1.5</td><td>two</td></tr>\n</table></div>\n");
    assert_non_null(
        strstr(markdown("|a|b|c|d|e|f|g|h|i|j|k|\n|---|\n"), "<tr><th class=\"up\">a</th><th class=\"up\">b<"));
    assert_lacks(markdown("|a|b|c|d|e|f|g|h|i|j|\n|---|\n"), "up");
}

/* What begins a mark and does not end it, or has a blank where a word is due, stands as it is. */
static void marks_that_are_none_stay(void **state) {
    (void)state;
    static const char *const plain[] = {"a \\q b", "ends in \\", "a `tick",  "*one",     "** 2 * x * y", "[a] (b)",
                                        "[a](b",   "a ](b) c",   "#hashtag", "-1 and -", "x_y*2"};
    for (size_t i = 0; i < sizeof plain / sizeof *plain; i++) {
        char wanted[80];
        snprintf(wanted, sizeof wanted, "<p>%s\n</p>\n", plain[i]);
        assert_string_equal(markdown(plain[i]), wanted);
    }
    assert_string_equal(markdown("****x"), "<p><strong></strong>x\n</p>\n");
    assert_string_equal(markdown("``, *a*b**c** [x](y)z"),
                        "<p><code></code>, <em>a</em>b<strong>c</strong> <a href=\"y\">x</a>z\n</p>\n");
}

static void blocks_end_where_another_begins(void **state) {
    (void)state;
    assert_string_equal(markdown("### a\n##### b\n###### c\ntext\n# d\n"),
                        "<h4>a</h4>\n<h6>b</h6>\n<h6>c</h6>\n<p>text\n</p>\n<h2>d</h2>\n");
    assert_string_equal(markdown("#### a\n"), "<h5>a</h5>\n");
    assert_string_equal(markdown("    a\n\n      b\nc\n"), "<pre><code>a\n  b\n</code></pre>\n<p>c\n</p>\n");
    assert_string_equal(markdown("- a\n    b\n- c\n\nd\n   e"), "<ul>\n<li>a    b\n<li>c</ul>\n<p>d\n   e\n</p>\n");
    assert_string_equal(markdown("a\n|b|\n|:-:|\n\n|c|\n"),
                        "<p>a\n</p>\n<div class=\"scroll\"><table>\n<tr><th>b</th></tr>\n</table></div>\n"
                        "<div class=\"scroll\"><table>\n<tr><th>c</th></tr>\n</table></div>\n");
    assert_string_equal(markdown(""), "");
}

static void cells_are_trimmed_and_numbers_set_right(void **state) {
    (void)state;
    assert_string_equal(
        markdown("|a|\n|---|\n|   | **-2.5e3** | **1** m |**|2%|\\|||x\n"),
        "<div class=\"scroll\"><table>\n<tr><th>a</th></tr>\n<tr><td></td><td "
        "class=\"n\"><strong>-2.5e3</strong></td>"
        "<td><strong>1</strong> m</td><td>**</td><td>2%</td><td>|</td><td></td></tr>\n</table></div>\n");
    const char *page = markdown("|1|b|c|d|e|f|g|h|i|j|k|\n|1|b|c|d|e|f|g|h|i|j|k|\n");
    assert_has(page, "<tr><th class=\"n\">1</th><th class=\"up\">b<");
    assert_has(page, "<tr><td class=\"n\">1</td><td>b<");
}

static const char *cell_of(const char *content) {
    FILE *out = begin();
    html_cell(out, content);
    fclose(out);
    return text;
}

static void a_number_is_a_number_to_its_end(void **state) {
    (void)state;
    assert_string_equal(cell_of("-1.5e-3"), "<td class=\"n\">-1.5e-3</td>");
    assert_string_equal(cell_of("95 %"), "<td class=\"n\">95 %</td>");
    assert_string_equal(cell_of("95 % x"), "<td>95 % x</td>");
    assert_string_equal(cell_of("%"), "<td>%</td>");
    assert_string_equal(cell_of(""), "<td></td>");
    FILE *out = begin();
    struct table t = table_headed(0, "a|b & c");
    table_add(&t, "x|3");
    table_add(&t, "2|y");
    html_table(out, &t, 1);
    html_command(out, "run 'a  b' <");
    html_verdict(out, "skipped");
    fclose(out);
    assert_string_equal(
        text, "<div class=\"scroll\"><table class=\"narrow\">\n<tr><th class=\"n\">a</th><th>b &amp; c</th></tr>\n"
              "<tr><td>x</td><td class=\"n\">3</td></tr>\n<tr><td class=\"n\">2</td><td>y</td></tr>\n</table></div>\n"
              "<pre><code><span>heatladder</span> <span>run</span> <span>'a</span> <span></span> <span>b'</span> "
              "<span>&lt;</span></code></pre>\n<span class=\"other\">? skipped</span>");
}

/* Bytes past the size are not looked at; no letter is U+FFFD, a control character a blank. */
static void bytes_are_escaped(void **state) {
    (void)state;
    FILE *out = begin();
    html_bytes(out, "a<b&c", 4);
    html_text(out, "\x01\x7F\x80\xC3\xA9\">");
    fclose(out);
    assert_string_equal(text, "a&lt;b&amp;  \xEF\xBF\xBD\xC3\xA9&quot;&gt;");
}

/* In base 64 the last three bytes end in = where one is missing, == where two are; 3072 are read at a time. */
static void images_of_any_length(void **state) {
    (void)state;
    static const struct {
        int letters;
        const char *end;
    } row[] = {{3, "QUFB"}, {4, "QUFBQQ=="}, {5, "QUFBQUE="}, {3072, "QUFBQUFB"}, {3073, "QUFBQQ=="}};
    for (int i = 0; i < 5; i++) {
        char path[UNIT_PATH];
        FILE *image = fdopen(scratch_file(path, "heatladder_page"), "w");
        for (int k = 0; k < row[i].letters; k++) fputc('A', image);
        fclose(image);
        FILE *out = begin();
        assert_int_equal(html_image(out, path, ""), 0);
        fclose(out);
        unlink(path);
        const char *data = strstr(text, "base64,") + 7;
        const size_t length = strcspn(data, "\""), last = strlen(row[i].end);
        assert_int_equal(length, (row[i].letters + 2) / 3 * 4);
        assert_int_equal(strncmp(data + length - last, row[i].end, last), 0);
    }
}

static void images_are_part_of_the_page(void **state) {
    (void)state;
    char path[UNIT_PATH];
    FILE *image = fdopen(scratch_file(path, "heatladder_page"), "w");
    fputs("<svg/>!", image);
    fclose(image);
    FILE *out = begin();
    assert_int_equal(html_image(out, path, "a \"chart\""), 0);
    fclose(out);
    unlink(path);
    assert_string_equal(text, "<img alt=\"a &quot;chart&quot;\" src=\"data:image/svg+xml;base64,PHN2Zy8+IQ==\">");
    out = begin();
    assert_int_equal(html_image(out, path, "gone"), -1);
    fclose(out);
}

static void charts_hold_their_points(void **state) {
    (void)state;
    const double x[] = {0.4, 0.2, 0.1}, y[] = {1.6e-2, NAN, 1e-3};
    const struct chart_series series = {"so <ssph>", 3, x, y, NULL};
    const struct chart chart = {"error", "dx [m]", "E1", 1, &series, 2};
    FILE *out = begin();
    chart_write(&chart, out);
    fclose(out);
    int circles = 0;
    for (const char *at = text; (at = strstr(at, "<circle")); at++) circles++;
    assert_int_equal(circles, 3); /* two points and the legend's: NaN is left out */
    /* The drawing is 374 px wide and reaches 0.15 decades beyond 0.1 and 0.4, 288 px high from 1e-3 to 1e-1; its
     * lower left corner is at (66, 304): 0.4 lies log10(4) + 0.15 = 0.75206 decades of 0.90206 to the right of it,
     * 0.1 0.15, and 1.6e-2 1.20412 decades of 2 above it. */
    assert_has(text, "<circle cx=\"377.8\" cy=\"130.6\"");
    assert_has(text, "<circle cx=\"128.2\" cy=\"304.0\"");
    assert_has(
        text,
        "<path d=\"M128.2 16V304\" stroke=\"#ddd\"/>\n<text x=\"128.2\" y=\"322.0\" text-anchor=\"middle\">0.1<");
    assert_has(text,
               "<path d=\"M66 304.0H440\" stroke=\"#ddd\"/>\n<text x=\"58.0\" y=\"308.0\" text-anchor=\"end\">1e-3<");
    assert_has(text, "so &lt;ssph&gt;");
    assert_has(text, "slope 2");
    assert_lacks(text, "nan");
}

static const char *drawing(const struct chart *c) {
    FILE *out = begin();
    chart_write(c, out);
    fclose(out);
    return text;
}

/* Three decades of x and twelve of y: of x only powers of ten have numbers, of y every second.  From the left end,
 * 66, 374 px hold log10(0.8/1e-3) + 0.3 = 3.20309 decades, from the lower end, 304, 288 px hold 12. */
static void wide_axes_have_fewer_numbers(void **state) {
    (void)state;
    const double x[] = {0.05, 1e-3, 0.8}, y[] = {3e-7, 2e-12, 4e-3}, x2[] = {0.8, 0.05}, y2[] = {0.5, 0.2};
    const int counts[] = {1, 1, 0};
    const struct chart_series series[] = {{"one", 3, x, y, counts}, {"two", 2, x2, y2, NULL}};
    struct chart chart = {"t", "dx", "E1", 2, series, 1.5};
    const char *page = drawing(&chart);
    assert_has(page, "viewBox=\"0 0 460 404\" width=\"460\"");
    assert_has(page, "stroke-width=\"2.6\" stroke-dasharray=\"none\" d=\"M281.9 172.5L83.5 296.8L422.5 73.6\"");
    assert_has(page, "stroke-width=\"1.4\" stroke-dasharray=\"7 4\" d=\"M422.5 23.2L281.9 32.8\"");
    assert_has(page, "<circle cx=\"422.5\" cy=\"73.6\" r=\"4.5\" fill=\"#fff\" stroke=\"#0072B2\"");
    assert_has(page, "<circle cx=\"83.5\" cy=\"296.8\" r=\"4.5\" fill=\"#0072B2\"");
    assert_has(page, "<rect x=\"277.7\" y=\"28.6\" width=\"8.4\" height=\"8.4\" fill=\"#D55E00\"");
    assert_has(page, "<circle cx=\"74.0\" cy=\"360.0\"");
    assert_has(page, "<rect x=\"69.8\" y=\"377.8\"");
    assert_has(page, "<text x=\"88.0\" y=\"365.0\" >one<");
    assert_has(page, "<text x=\"88.0\" y=\"387.0\" >two<");
    assert_has(page, "<rect x=\"66\" y=\"16\" width=\"374\" height=\"288\" fill=\"none\"");
    assert_has(page, "<text x=\"230.0\" y=\"342.0\" text-anchor=\"middle\">dx<");
    assert_has(page, "<path d=\"M118.7 16V304\" stroke=\"#ddd\"/>\n<path d=\"M165.1 16V304\" stroke=\"#ddd\"/>\n"
                     "<path d=\"M200.3 16V304\" stroke=\"#ddd\"/>\n<text x=\"200.3\" y=\"322.0\" "
                     "text-anchor=\"middle\">0.01<");
    assert_has(page, "M433.8 16V304");
    assert_lacks(page, ">0.02<");
    assert_has(page, "y=\"260.0\" text-anchor=\"end\">1e-10<");
    assert_has(page, "y=\"20.0\" text-anchor=\"end\">1e0<");
    assert_lacks(page, ">1e-11<");
    /* From a third of the first series' finest error, 2e-12/3, which is below the lower end, to 0.1 decades before
     * the right end; or, where that is above the upper end, to where it meets that. */
    assert_has(page, "d=\"M83.5 304.0L428.3 197.7\"/>\n<text x=\"263.9\" y=\"264.8\" fill=\"#555\">slope 1.5<");
    chart.slope = 5;
    assert_has(drawing(&chart),
               "d=\"M83.5 304.0L363.7 16.0\"/>\n<text x=\"231.6\" y=\"174.0\" fill=\"#555\">slope 5<");
    chart.slope = NAN;
    assert_lacks(drawing(&chart), "slope");
}

static void narrow_axes_have_a_decade(void **state) {
    (void)state;
    const double x[] = {0.2, 0.1}, y[] = {1e-3, 1e-3}, none[] = {0, NAN}, below[] = {-1, INFINITY};
    const struct chart_series flat = {"flat", 2, x, y, NULL}, nothing = {"nothing", 2, x, none, NULL},
                              beside = {"beside", 2, below, y, NULL};
    struct chart chart = {"t", "dx", "E1", 1, &flat, 1};
    const char *page = drawing(&chart);
    assert_has(page, "d=\"M346.7 304.0L159.3 304.0\"");
    assert_has(page, "d=\"M159.3 304.0L377.8 202.9\"/>\n<text x=\"276.6\" y=\"267.5\" fill=\"#555\">slope 1<");
    assert_has(page, "y=\"20.0\" text-anchor=\"end\">1e-2<");
    for (int i = 0; i < 2; i++) {
        chart.series = i ? &beside : &nothing;
        page = drawing(&chart);
        assert_has(page, "<text x=\"109.2\" y=\"322.0\" text-anchor=\"middle\">0.1<");
        assert_has(page, "<text x=\"310.2\" y=\"322.0\" text-anchor=\"middle\">0.5<");
        assert_has(page, "<text x=\"58.0\" y=\"20.0\" text-anchor=\"end\">1e0<");
        assert_lacks(page, "slope");
        assert_lacks(page, "nan");
        assert_lacks(page, "inf");
    }
}

/* Seven series: the last has no style of its own, and is left out. */
static void six_series_are_drawn(void **state) {
    (void)state;
    const double x[] = {1}, y[] = {1};
    struct chart_series series[7];
    for (int k = 0; k < 7; k++) series[k] = (struct chart_series){&"abcdefg"[k], 1, x, y, NULL};
    const char *page = drawing(&(struct chart){"t", "dx", "E1", 7, series, NAN});
    assert_has(page, ">fg</text>");
    assert_lacks(page, ">g</text>");
    /* 1 lies in the middle of 0.3 decades, 253, and at the lower end of a decade, 304. */
    static const char *const marker[] = {"<circle cx=\"253.0\" cy=\"304.0\"",
                                         "<rect x=\"248.8\" y=\"299.8\"",
                                         "\"M253.0 298.5l5 9",
                                         "\"M253.0 298.5l5 5.5",
                                         "\"M253.0 309.5l5 -9",
                                         "\"M250.5 299.5v9"};
    for (int k = 0; k < 6; k++) assert_has(page, marker[k]);
    assert_true(strstr(page, marker[5]) < strstr(page, marker[0])); /* the first is on top */
}

static void gates_are_read_back(void **state) {
    (void)state;
    char path[UNIT_PATH];
    FILE *file = fdopen(scratch_file(path, "heatladder_page"), "w");
    fputs(
        "{\n\"made\": \"today \\\"here\\\"\",\n\"declared\": 2,\n\"gates\": [\n{ \"id\": \"rod/a\", \"command\": "
        "\"run \\\"x\\\"\", \"expected\": 2,\n"
        "\"tolerance\": 0.125, \"measured\": 2.0625, \"interval95\": [ 1, 2 ], \"error\": 3e-4, \"ceiling\": null,\n"
        "\"verdict\": \"pass\", \"reason\": \"r\", \"why\": \"w\", \"axis\": \"dx [m]\", \"norm\": \"L2\",\n"
        "\"rungs\": [ 0.5, 0.25, 0.125 ], \"errors\": [ 4e-2, null, 3e-4 ], \"counted\": [ 0, 1, 1 ], \"seconds\": 1 "
        "},\n"
        "{ \"id\": \"b\", \"expected\": 0, \"tolerance\": 7, \"ceiling\": 0.5, \"verdict\": \"fail\", \"diagnosis\": "
        "\"1 step late\" "
        "}\n]\n}\n",
        file);
    fclose(file);
    struct gates g;
    const char *made;
    assert_int_equal(gates_json_read(path, &g, &made), 0);
    assert_int_equal(g.declared, 2);
    assert_string_equal(g.result[0].typed, "run \"x\"");
    assert_string_equal(g.result[0].gate.id, "rod/a");
    assert_string_equal(g.result[0].gate.why, "w");
    assert_string_equal(g.result[0].measured.reason, "r");
    assert_string_equal(g.result[0].measured.diagnosis, "");
    assert_string_equal(g.result[1].measured.diagnosis, "1 step late");
    assert_near(g.result[0].measured.value, 2.0625, 0);
    assert_near(g.result[1].gate.ceiling, 0.5, 0);
    assert_near(g.result[0].gate.lo, 1.875, 0);
    assert_near(g.result[0].gate.hi, 2.125, 0);
    assert_near(g.result[0].measured.error, 3e-4, 0);
    assert_nan(g.result[0].gate.ceiling);
    assert_nan(g.result[1].measured.value);
    assert_near(g.result[1].gate.lo, 0, 0);
    assert_near(g.result[1].gate.hi, 7, 0);
    assert_near(g.result[0].measured.ci[1], 2, 0);
    const struct rungs *l = &g.result[0].measured.rungs;
    assert_true(l->n == 3 && l->x[1] == 0.25 && l->error[2] == 3e-4 && isnan(l->error[1]));
    assert_true(!l->counts[0] && l->counts[1] && g.result[1].measured.rungs.n == 0);
    FILE *out = begin();
    page_put_gates(&g, made, out);
    page_put_ladders(&g, out);
    fclose(out);
    assert_has(text, "<th class=\"n\">dx [m]</th><th class=\"n\">L2</th>");
    assert_has(text, "<td class=\"n\">0.5</td><td class=\"n\">4.0000e-02</td><td>left out</td>");
    assert_has(text, "<td class=\"n\">0.25</td><td>-</td><td>counts</td>");
    assert_has(text, "slope 2</text>");
    assert_has(text, "<td>1.875 to 2.125</td><td class=\"n\">2.062</td>");
    assert_has(text, "<td>at most 7</td>");
    const char *finest = strstr(strstr(text, "<circle") + 1, "<circle"); /* the rung between them failed */
    assert_has(strstr(text, "<circle"), "fill=\"#fff\"");
    assert_true(strstr(finest, "fill=\"#0072B2\"") < strchr(finest, '\n'));
    assert_has(text, "1 of 2 gates hold");
    assert_has(text, "The gates were run today &quot;here&quot;.");
    assert_has(text, "<h4>b: ");
    assert_has(text, "<p>Diagnosis: 1 step late.</p>");
    assert_has(text, "<p class=\"verdict\">Diagnosis: 1 step late (1 of 1 gates that do not hold).</p>");
    gates_free(&g);
    file = fopen(path, "w");
    fputs("{\"gates\": [\n{ \"id\": \"rod", file);
    fclose(file);
    assert_int_equal(gates_json_read(path, &g, &made), -1);
    unlink(path);
}

/* What fails, what is not decided, and what was left to the program. */
static void the_worst_gate_is_the_verdict(void **state) {
    (void)state;
    static const enum verdict verdicts[] = {VERDICT_PASS, VERDICT_SKIPPED, VERDICT_INCONCLUSIVE, VERDICT_FAIL};
    const char *const whole[] = {": 1 of 1 gates hold<", ": 1 of 1 gates hold, 1 skipped<",
                                 ": 1 of 2 gates hold, 1 skipped<", ": 1 of 3 gates hold, 1 skipped<"};
    const char *const word[] = {"pass", "pass", "inconclusive", "fail"};
    struct gates g = {.result = xcalloc(4, sizeof *g.result)};
    for (int n = 1; n <= 4; n++) {
        char head[160];
        struct gate_result *r = &g.result[n - 1];
        r->gate = (struct gate){.id = verdict_words[verdicts[n - 1]], .why = "w", .ceiling = NAN};
        r->measured = (struct measured){.verdict = verdicts[n - 1], .reason = "r"};
        g.declared = n;
        FILE *out = begin();
        page_put_gates(&g, "now", out);
        fclose(out);
        snprintf(head, sizeof head, "%s</span>%s", word[n - 1], whole[n - 1]);
        assert_has(text, head);
    }
    assert_has(text, "<li>inconclusive 0/1 <span class=\"other\">");
    FILE *out = begin();
    page_put_gates(&(struct gates){.declared = 1, .result = g.result + 1}, "now", out);
    fclose(out);
    gates_free(&g);
    assert_has(text, "inconclusive</span>: 0 of 0 gates hold, 1 skipped");
    assert_has(text, "<li>skipped <span class=\"other\">? skipped</span>");
}

static char *whole(const char *path) {
    static char page[200000];
    FILE *in = fopen(path, "r");
    assert_non_null(in);
    page[fread(page, 1, sizeof page - 1, in)] = '\0';
    fclose(in);
    return page;
}

/* The page of a ladder of two rungs. */
static const char *page_of(const char *line) {
    char path[UNIT_PATH];
    struct ladder *l = xcalloc(1, sizeof *l);
    struct request r;
    struct failure why;
    close(scratch_file(path, "heatladder_page"));
    assert_int_equal(arguments_parse_line(line, &r, &why), 0);
    assert_int_equal(ladder_run(&r.experiment, &r.rungs, l, &why), 0);
    assert_int_equal(page_ladder_write(l, &r.rungs, r.typed, path, &why), 0);
    arguments_free(&r);
    free(l);
    const char *page = whole(path);
    unlink(path);
    return page;
}

static void a_ladder_says_what_made_it(void **state) {
    (void)state;
    assert_has(page_of("ladder rod-gauss ftcs --dx 1,0.5 --set 'kappa=1.1' --norm l2"),
               "<code><span>heatladder</span> <span>ladder</span> <span>rod-gauss</span> <span>ftcs</span> "
               "<span>--dx</span> "
               "<span>1,0.5</span> <span>--set</span> <span>kappa=1.1</span> <span>--norm</span> <span>l2</span><");
}

/* Chart and name are of the norm that is judged, and a quantity stands in the table. */
static void a_ladder_shows_what_is_judged(void **state) {
    (void)state;
    char first[200];
    const char *page = page_of("ladder rod-gauss ftcs --dx 1,0.5"), *point = strstr(page, "<circle");
    assert_has(page, "E1 (hollow: left out of the fit)</text>");
    snprintf(first, sizeof first, "%.*s", (int)strcspn(point, ">"), point);
    page = page_of("ladder rod-gauss ftcs --dx 1,0.5 --norm l2");
    assert_has(page, "L2 (hollow: left out of the fit)</text>");
    assert_true(strncmp(strstr(page, "<circle"), first, strlen(first)) != 0);
    page = page_of("ladder rod-gauss ftcs --dx 1,0.5 --quantity at:0.31");
    assert_has(page, "the quantity's error (hollow");
    assert_has(page, "<th class=\"n\">quantity</th><th class=\"n\">its error</th>");
}

/* The battery's page has a ladder's chart and table, and names the program. */
static void a_battery_shows_its_ladders(void **state) {
    (void)state;
    char path[UNIT_PATH];
    struct failure why;
    struct program program = {.solver = "mine {case} <{out}>"};
    struct gate_result result = {.gate = {.id = "rod/order", .lo = 1.9, .hi = 2.1, .ceiling = NAN, .why = "w"},
                                 .typed = "verify --only rod/order",
                                 .executed = 1};
    result.measured = (struct measured){.value = 1, .error = NAN, .verdict = VERDICT_FAIL, .reason = "r"};
    result.measured.rungs = (struct rungs){
        .n = 2, .axis = "dx [m]", .norm = "E1", .x = {0.5, 0.25}, .error = {0.25, 0.125}, .counts = {1, 1}};
    struct gates g = {.declared = 1, .executed = 1, .result = &result, .program = &program};
    close(scratch_file(path, "page"));
    assert_int_equal(page_gates_write(&g, "t", "verify", path, &why), 0);
    const char *page = whole(path);
    unlink(path);
    assert_has(page, "<p>Program: <code>mine {case} &lt;{out}&gt;</code></p>");
    assert_has(page, "<circle");
    assert_has(page, ">rod/order</text>");
    assert_has(page, "<td class=\"n\">0.25</td><td class=\"n\">1.2500e-01</td><td>counts</td>");
}

/* The page of a directory that has mutants.txt alone. */
static const char *page_of_listing(const char *listing) {
    char dir[UNIT_PATH], path[UNIT_PATH + 64];
    struct failure why;
    assert_non_null(scratch_directory(dir, "heatladder_page"));
    snprintf(path, sizeof path, "%s/mutants.txt", dir);
    FILE *out = fopen(path, "w");
    fputs(listing, out);
    fclose(out);
    assert_int_equal(index_write(dir, &why), 0);
    unlink(path);
    snprintf(path, sizeof path, "%s/summary.md", dir);
    unlink(path);
    snprintf(path, sizeof path, "%s/index.html", dir);
    const char *page = whole(path);
    unlink(path);
    assert_int_equal(rmdir(dir), 0);
    return page;
}

/* A short paragraph first, a long one that is folded away, a line that closes. */
static void a_long_listing_is_folded(void **state) {
    (void)state;
    char listing[800], *to = listing + sprintf(listing, "head\n\n");
    for (int i = 0; i < 60; i++) to += sprintf(to, "row %d\n", i);
    sprintf(to, "\n60 seen\n");
    const char *page = page_of_listing(listing);
    assert_has(page, "<pre><code>head\n\n</code></pre>\n<details><summary>mutants.txt: 61 lines "
                     "more</summary>\n<pre><code>row 0\nrow 1\n");
    assert_has(page, "row 59\n\n</code></pre>\n</details>\n<pre><code>60 seen\n</code></pre>\n"
                     "<p class=\"faint\"><code>make mutants</code></p>\n");
}

/* `rows` lines and a blank one. */
static char *paragraph(char *to, char letter, int rows) {
    for (int i = 0; i < rows; i++) to += sprintf(to, "%c%d\n", letter, i);
    return to + sprintf(to, "\n");
}

/* What fits into 45 lines is never folded, a last line never, two last lines always. */
static void a_listing_is_folded_at_its_paragraphs(void **state) {
    (void)state;
    char listing[800];
    sprintf(paragraph(paragraph(listing, 'a', 44), 'b', 3), "c0\nc1\n");
    const char *page = page_of_listing(listing);
    assert_has(
        page, "a43\n\n</code></pre>\n<details><summary>mutants.txt: 6 lines more</summary>\n<pre><code>b0\nb1\nb2\n\n"
              "c0\nc1\n</code></pre>\n</details>\n<p class=\"faint\">");
    sprintf(paragraph(listing, 'a', 44), "last\n");
    page = page_of_listing(listing);
    assert_has(page, "a43\n\n</code></pre>\n<pre><code>last\n</code></pre>\n<p class=\"faint\">");
    sprintf(paragraph(listing, 'a', 45), "last\n");
    page = page_of_listing(listing);
    assert_has(page,
               "<h2>Seeded faults</h2>\n<details><summary>mutants.txt: 46 lines more</summary>\n<pre><code>a0\n");
    assert_has(page, "a44\n\n</code></pre>\n</details>\n<pre><code>last\n</code></pre>\n<p class=\"faint\">");
    page = page_of_listing("a\n\nb\n\nno end");
    assert_has(page, "<h2>Seeded faults</h2>\n<pre><code>a\n\nb\n\nno end</code></pre>\n<p class=\"faint\">");
}

/* Files of older versions do not say when they were made; what stands behind the gates is not theirs. */
static void gates_without_a_date(void **state) {
    (void)state;
    static const char *const json[] = {"{\"gates\": [\n{ \"id\": \"a\" }]}",
                                       "{\"made\": null,\n\"gates\": [\n{ \"id\": \"a\" }]}",
                                       "{\"gates\": [\n{ \"id\": \"a\" }],\n\"made\": \"today\"}"};
    for (int i = 0; i < 3; i++) {
        char path[UNIT_PATH];
        struct gates g;
        const char *made;
        FILE *file = fdopen(scratch_file(path, "heatladder_page"), "w");
        fputs(json[i], file);
        fclose(file);
        assert_int_equal(gates_json_read(path, &g, &made), 0);
        unlink(path);
        assert_int_equal(g.declared, 1);
        assert_string_equal(made, "from an existing file; date and machine not recorded");
        assert_true(isnan(g.result[0].measured.error) && isnan(g.result[0].gate.hi));
        gates_free(&g);
    }
}

static void the_order_of_a_band_is_whole(void **state) {
    (void)state;
    assert_near(page_order(1.5, 2.9), 2, 0);
    assert_near(page_order(0.9, 1.1), 1, 0);
    assert_near(page_order(1.6, 1.8), 1.7, 1e-15);
    assert_near(page_order(2.1, 2.9), 2.5, 1e-15);
    assert_near(page_order(2, 2.5), 2, 0);
    assert_near(page_order(1.5, 2), 2, 0);
}

/* Each ladder once, on its band; a curve a method and the second-order particles first. */
static void ladders_are_drawn_by_scene(void **state) {
    (void)state;
    const char *const scene[] = {"rod-gauss", "rod-step", NULL};
    static const char *const typed[] = {"ladder rod-gauss ftcs --dx 1,2", "ladder rod-gauss so_ssph --dx 1,2",
                                        "ladder rod-gauss ftcs --dx 1,4", "run rod-gauss ftcs"};
    static const char *const ids[] = {"a", "b", "c", "d"};
    struct gates g = {.declared = 4, .result = xcalloc(4, sizeof *g.result)};
    for (int i = 0; i < 4; i++) {
        struct gate_result *r = &g.result[i];
        snprintf(r->typed, sizeof r->typed, "%s", typed[i]);
        r->gate = (struct gate){.id = ids[i], .lo = 1.5, .hi = 2.5};
        r->measured = (struct measured){.verdict = i < 2 ? VERDICT_PASS : VERDICT_FAIL, .value = 2};
        if (i < 3)
            r->measured.rungs = (struct rungs){
                .n = 2, .axis = "dx [m]", .norm = "E1", .x = {0.5, 0.25}, .error = {0.25, 0.125}, .counts = {1, 1}};
    }
    FILE *out = begin();
    orders_put(&g, scene, "make verify", out);
    fclose(out);
    int dots = 0;
    for (const char *at = text; (at = strstr(at, "<circle")); at++) dots++;
    assert_int_equal(dots, 2);
    assert_has(text, "a: 2, expected 1.5 to 2.5</title>");
    assert_has(text, "stroke=\"#a3200d\"");
    assert_has(text, "3 ladders.");
    assert_lacks(text, ">rod-step<");
    g.result[0].gate.hi = 1.8; /* not of the first ladder that is drawn, which is b's */
    out = begin();
    orders_put_scene(&g, "rod-gauss", out);
    fclose(out);
    gates_free(&g);
    assert_has(text, "slope 2<");
    assert_true(strstr(text, ">b</text>") < strstr(text, ">a</text>"));
    assert_lacks(text, ">c</text>");
}

/* Seven ladders of one scene, 3 px apart in 14 + 21 px, and one of another, alone in 14 + 14; 298 px from 146 on hold
 * the orders from -1 to 3. */
static void ladders_have_their_places(void **state) {
    (void)state;
    const char *const scene[] = {"rod-gauss", "wave", "rod-step", NULL};
    static const char *const names[] = {"ftcs",      "brookshaw", "so_ssph",       "fo_ssph", "cspm",
                                        "conjugate", "positive",  "kernel_second", "ftcs"};
    struct gates g = {.declared = 9, .result = xcalloc(9, sizeof *g.result)};
    for (int i = 0; i < 9; i++) {
        struct gate_result *r = &g.result[i];
        snprintf(r->typed, sizeof r->typed, "ladder %s %s --dx 1,2", i == 7 ? "rod-step" : "rod-gauss", names[i]);
        r->gate = (struct gate){.id = names[i], .lo = 1.5, .hi = 2.5, .ceiling = NAN, .why = "w"};
        r->measured = (struct measured){.verdict = i == 3 ? VERDICT_INCONCLUSIVE : VERDICT_PASS, .value = 2};
        r->measured.rungs = (struct rungs){
            .n = 2, .axis = "dx [m]", .norm = "E1", .x = {0.5, 0.25}, .error = {0.25, 0.125}, .counts = {1, 1}};
    }
    g.result[3].measured.value = -0.4;
    g.result[8].measured.value = NAN; /* no order, no place */
    FILE *out = begin();
    orders_put(&g, scene, NULL, out);
    fclose(out);
    assert_has(text, "viewBox=\"0 0 460 117\"");
    assert_has(text, "<text x=\"136\" y=\"31.5\" text-anchor=\"end\">rod-gauss<");
    assert_has(text, "<text x=\"136\" y=\"63.0\" text-anchor=\"end\">rod-step<");
    assert_has(text, "<title>ftcs: 2, expected 1.5 to 2.5</title><path d=\"M332.2 18.5H406.8\" stroke=\"#b8b8b8\" "
                     "stroke-width=\"2\"/><circle cx=\"369.5\" cy=\"18.5\" r=\"1.9\"");
    assert_has(text, "<circle cx=\"369.5\" cy=\"36.5\" r=\"1.9\"");
    assert_has(text, "<path d=\"M186.7 23.5l8 8m0 -8l-8 8\"");
    assert_has(text, "stroke-width=\"8\"/><circle cx=\"369.5\" cy=\"59.0\" r=\"4.0\"");
    assert_has(text, "<path d=\"M146.0 10V73\" stroke=\"#ddd\"/>\n<text x=\"146.0\" y=\"91\" "
                     "text-anchor=\"middle\">-1<");
    assert_has(text, "<text x=\"444.0\" y=\"91\" text-anchor=\"middle\">3<");
    assert_has(text, "<text x=\"295\" y=\"109\" text-anchor=\"middle\">order<");
    assert_has(text, " 8 ladders.");
    assert_lacks(text, "<code>");
    strcpy(g.result[0].measured.rungs.axis, "dt [s]");
    g.result[1].measured.rungs.norm = "L2";
    out = begin();
    orders_put_scene(&g, "rod-gauss", out);
    fclose(out);
    assert_true(strstr(text, ">so_ssph<") && strstr(text, ">fo_ssph<") && strstr(text, ">positive<"));
    assert_lacks(text, ">ftcs<");
    assert_lacks(text, ">brookshaw<");
    assert_has(text, "slope 2<");
    assert_has(text, "<title>Error against spacing on rod-gauss<");
    strcpy(g.result[0].measured.rungs.axis, "dx [m]");
    g.result[1].measured.rungs.norm = "E1";
    out = begin();
    orders_put_scene(&g, "rod-gauss", out);
    fclose(out);
    assert_true(strstr(text, ">so_ssph<") < strstr(text, ">ftcs<") && strstr(text, ">conjugate<")); /* six */
    assert_lacks(text, ">positive<");
    out = begin();
    orders_put_scene(&g, "wave", out);
    orders_put_scene(&(struct gates){0}, "wave", out);
    fclose(out);
    assert_string_equal(text, "<p class=\"faint\">No gate has a ladder in space here.</p>\n");
    gates_free(&g);
}

/* Those that are not judged are listed and not counted. */
static void the_gates_of_a_scene(void **state) {
    (void)state;
    static const enum verdict verdicts[] = {VERDICT_PASS, VERDICT_SKIPPED, VERDICT_INCONCLUSIVE, VERDICT_FAIL};
    static const char *const ids[] = {"a", "b", "c", "d"};
    struct gates g = {.declared = 4, .result = xcalloc(4, sizeof *g.result)};
    for (int i = 0; i < 4; i++) {
        struct gate_result *r = &g.result[i];
        snprintf(r->typed, sizeof r->typed, "run %s ftcs", i == 3 ? "wave" : "rod-gauss");
        r->gate = (struct gate){.id = ids[i], .hi = 1, .ceiling = i ? NAN : 0.01, .why = "w"};
        r->measured = (struct measured){.verdict = verdicts[i], .reason = "r", .value = 0.25, .error = 0.005};
    }
    g.result[1].gate.ceiling = 0.02; /* of what was not run there is no value */
    g.result[1].measured.value = g.result[1].measured.error = NAN;
    FILE *out = begin();
    page_put_scene(&g, "rod-gauss", out);
    fclose(out);
    assert_has(text, "<details><summary>1 of 2 gates hold</summary>");
    assert_true(strstr(text, "<td>a</td>") && strstr(text, "<td>b</td>") && strstr(text, "<td>c</td>"));
    assert_has(text, "<td class=\"n\">0.25</td><td>0.005, at most 0.01</td><td>w</td></tr>");
    assert_has(text, "<td>-</td><td>-, at most 0.02</td><td>r</td></tr>");
    assert_has(text, "<td class=\"n\">0.25</td><td></td><td>r</td></tr>");
    assert_lacks(text, "<td>d</td>");
    out = begin();
    page_put_scene(&g, "rod", out);
    fclose(out);
    assert_string_equal(text, "");
    gates_free(&g);
}

/* Few ladders have their own names beside them, many those of their scenes. */
static void ladders_have_names(void **state) {
    (void)state;
    char id[61][8];
    struct gates g = {.declared = 61, .result = xcalloc(61, sizeof *g.result)};
    for (int i = 0; i < 61; i++) {
        struct gate_result *r = &g.result[i];
        snprintf(id[i], sizeof id[i], "a%d", i);
        snprintf(r->typed, sizeof r->typed, "ladder rod-step ftcs --dx 1,2");
        r->gate = (struct gate){.id = id[i], .lo = 1.5, .hi = 2.5};
        r->measured = (struct measured){.value = 2, .rungs = {.n = 2}};
    }
    FILE *out = begin();
    orders_put_all(&g, out);
    fclose(out);
    assert_has(text, ">rod-step</text>");
    assert_has(text, " 61 ladders.");
    assert_lacks(text, ">a7</text>");
    g.declared = 60;
    out = begin();
    orders_put_all(&g, out);
    fclose(out);
    gates_free(&g);
    assert_has(text, ">a7</text>");
    assert_has(text, " 60 ladders.");
    assert_lacks(text, ">rod-step</text>");
}

/* Of a directory with a listing alone: the rest is named with the command that makes it. */
static void a_page_of_what_there_is(void **state) {
    (void)state;
    const char *page = page_of_listing("first < 2\n  second\n");
    assert_has(page, "No verdict: the gates were not run. <code>make verify</code> runs them.");
    assert_has(page, "<pre><code>first &lt; 2\n  second\n</code></pre>");
    assert_has(page, ", <code>make claims</code>.</p>");
    assert_lacks(page, ", <code>make mutants</code>");
    assert_lacks(page, "<h2>Walls</h2>");
    assert_true(strstr(page, "<h2>rod-gauss</h2>") < strstr(page, "<h2>rod-step</h2>"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(markdown_becomes_html),
        cmocka_unit_test(images_are_part_of_the_page),
        cmocka_unit_test(charts_hold_their_points),
        cmocka_unit_test(gates_are_read_back),
        cmocka_unit_test(the_worst_gate_is_the_verdict),
        cmocka_unit_test(a_ladder_says_what_made_it),
        cmocka_unit_test(a_ladder_shows_what_is_judged),
        cmocka_unit_test(a_long_listing_is_folded),
        cmocka_unit_test(a_listing_is_folded_at_its_paragraphs),
        cmocka_unit_test(gates_without_a_date),
        cmocka_unit_test(a_page_of_what_there_is),
        cmocka_unit_test(a_battery_shows_its_ladders),
        cmocka_unit_test(ladders_are_drawn_by_scene),
        cmocka_unit_test(ladders_have_names),
        cmocka_unit_test(the_order_of_a_band_is_whole),
        cmocka_unit_test(marks_that_are_none_stay),
        cmocka_unit_test(blocks_end_where_another_begins),
        cmocka_unit_test(cells_are_trimmed_and_numbers_set_right),
        cmocka_unit_test(a_number_is_a_number_to_its_end),
        cmocka_unit_test(bytes_are_escaped),
        cmocka_unit_test(images_of_any_length),
        cmocka_unit_test(wide_axes_have_fewer_numbers),
        cmocka_unit_test(narrow_axes_have_a_decade),
        cmocka_unit_test(six_series_are_drawn),
        cmocka_unit_test(ladders_have_their_places),
        cmocka_unit_test(the_gates_of_a_scene),
    };
    return cmocka_run_group_tests_name("page", tests, NULL, NULL);
}
