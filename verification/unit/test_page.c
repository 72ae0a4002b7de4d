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
    static const char *const text[] = {"{\"gates\": [\n{ \"id\": \"a\" }]}",
                                       "{\"made\": null,\n\"gates\": [\n{ \"id\": \"a\" }]}",
                                       "{\"gates\": [\n{ \"id\": \"a\" }],\n\"made\": \"today\"}"};
    for (int i = 0; i < 3; i++) {
        char path[UNIT_PATH];
        struct gates g;
        const char *made;
        FILE *file = fdopen(scratch_file(path, "heatladder_page"), "w");
        fputs(text[i], file);
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
    out = begin();
    orders_put_scene(&g, "rod-gauss", out);
    fclose(out);
    gates_free(&g);
    assert_true(strstr(text, ">b</text>") < strstr(text, ">a</text>"));
    assert_lacks(text, ">c</text>");
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
    };
    return cmocka_run_group_tests_name("page", tests, NULL, NULL);
}
