/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pages: escapes, images, texts in two languages, verdicts, and the data of the gates' figures. */
#include "verification/text/html.h"
#include "verification/report/page.h"

#include "solver/field.h"
#include "verification/gates/gates.h"
#include "verification/report/picture.h"

#include "reports/figure/document.h"
#include "reports/index/index.h"
#include "solver/status.h"
#include "verification/case/command.h"
#include "verification/solve/program.h"
#include "verification/judge/ladder.h"
#include "verification/text/table.h"

#include "verification/unit/near.h"
#include "verification/unit/scratch_path.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char text[20000], folder[UNIT_PATH];

static FILE *begin(void) {
    memset(text, 0, sizeof text);
    return fmemopen(text, sizeof text - 1, "w");
}

static const char *path_of(const char *name) {
    static char path[2][UNIT_PATH + 64];
    static int which;
    which = !which;
    snprintf(path[which], sizeof path[which], "%s/%s", folder, name);
    return path[which];
}

/* The file in the scratch directory, which goes. */
static const char *take(const char *name) {
    static char content[100000];
    FILE *in = fopen(path_of(name), "r");
    assert_non_null(in);
    content[fread(content, 1, sizeof content - 1, in)] = '\0';
    fclose(in);
    unlink(path_of(name));
    return content;
}

static void put(const char *name, const char *content, size_t size) {
    FILE *out = fopen(path_of(name), "w");
    assert_non_null(out);
    fwrite(content, 1, size, out);
    fclose(out);
}

static void text_is_escaped(void **state) {
    (void)state;
    FILE *out = begin();
    html_bytes(out, "a<b&c", 4);
    html_text(out, "\x01\x7F\x80\xC3\xA9\">");
    html_command(out, "run 'a' <");
    fclose(out);
    assert_string_equal(text, "a&lt;b&amp;  \xEF\xBF\xBD\xC3\xA9&quot;&gt;<pre><code><span>heatladder</span> "
                              "<span>run</span> <span>'a'</span> <span>&lt;</span></code></pre>\n");
}

static void numbers_are_right_aligned(void **state) {
    (void)state;
    FILE *out = begin();
    struct table t = table_headed(0, "a|b & c");
    table_add(&t, "-1.5e-3|95 %%");
    table_add(&t, "2 m|%%");
    html_table(out, &t);
    fclose(out);
    assert_string_equal(text, "<div class=\"scroll\"><table>\n<tr><th>a</th><th>b &amp; c</th></tr>\n"
                              "<tr><td class=\"n\">-1.5e-3</td><td class=\"n\">95 %</td></tr>\n"
                              "<tr><td>2 m</td><td>%</td></tr>\n</table></div>\n");
}

/* RFC 4648, section 10. */
static void images_of_any_length(void **state) {
    (void)state;
    static const char *const base64[] = {"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
    for (size_t n = 0; n < 7; n++) {
        char due[120];
        put("a.svg", "foobar", n);
        FILE *out = begin();
        assert_int_equal(html_image(out, path_of("a.svg"), "a < b"), 0);
        fclose(out);
        snprintf(due, sizeof due, "<img alt=\"a &lt; b\" src=\"data:image/svg+xml;base64,%s\">", base64[n]);
        assert_string_equal(text, due);
    }
    unlink(path_of("a.svg"));
    assert_int_equal(html_image(stdout, path_of("a.svg"), ""), -1);
}

static void html_and_markdown_have_the_same_text(void **state) {
    (void)state;
    struct document d;
    struct failure why;
    document_open(&d, folder, "doc", "A < B");
    document_text(&d, "`a*b` and |G| <= %d", 1);
    struct table t = table_headed(1, "name|value|more");
    for (int i = 0; i < 2; i++) {
        table_add(&t, "`x_%d`|%d", i, i);
        table_add(&t, "%s", "a|b");
    }
    document_table(&d, &t);
    document_heading(&d, "next");
    document_command(&d, "run %s", "x");
    assert_int_equal(document_close(&d, &why), STATUS_OK);
    assert_string_equal(take("doc.md"),
                        "# A < B\n\n`a*b` and \\|G\\| \\<= 1\n\n| name | value | more |\n|---|---|---|\n"
                        "| `x_0` | 0 | a\\|b |\n| `x_1` | 1 | a\\|b |\n\n## next\n\n    heatladder run x\n");
    FILE *out = begin();
    assert_int_equal(html_include(out, path_of("doc.html")), 0);
    fclose(out);
    assert_string_equal(
        text,
        "<p><code>a*b</code> and |G| &lt;= 1</p>\n<div class=\"scroll\"><table>\n<tr><th>name</th><th>value</th>"
        "<th>more</th></tr>\n<tr><td><code>x_0</code></td><td class=\"n\">0</td><td>a|b</td></tr>\n"
        "<tr><td><code>x_1</code></td><td class=\"n\">1</td><td>a|b</td></tr>\n</table></div>\n<h4>next</h4>\n"
        "<pre><code><span>heatladder</span> <span>run</span> <span>x</span></code></pre>\n");
    assert_has(take("doc.html"), "<h1>A &lt; B</h1>");
    put("doc.html", "<h1>x</h1>\n", 10);
    assert_int_equal(html_include(stdout, path_of("doc.html")), -1);
    unlink(path_of("doc.html"));
}

static const char *page_of(const struct gates *g) {
    struct failure why;
    assert_int_equal(page_gates_write(g, "title", "verify -v", path_of("v.html"), &why), STATUS_OK);
    return take("v.html");
}

static void page_verdict_is_the_worst_gate(void **state) {
    (void)state;
    static const enum verdict verdicts[] = {VERDICT_PASS, VERDICT_SKIPPED, VERDICT_INCONCLUSIVE, VERDICT_FAIL};
    static const char *const head[] = {
        "pass</span>: 1 of 1 gates hold<", "pass</span>: 1 of 1 gates hold, 1 skipped<",
        "inconclusive</span>: 1 of 2 gates hold, 1 skipped<", "fail</span>: 1 of 3 gates hold, 1 skipped<"};
    struct gate_result *result = xcalloc(4, sizeof *result);
    for (int n = 0; n < 4; n++) {
        result[n].gate = (struct gate){.id = verdict_words[verdicts[n]], .why = "w", .ceiling = NAN};
        result[n].measured = (struct measured){.verdict = verdicts[n], .reason = "r"};
        assert_has(page_of(&(struct gates){.declared = n + 1, .result = result}), head[n]);
    }
    assert_has(page_of(&(struct gates){.declared = 1, .result = result + 1}),
               "inconclusive</span>: 0 of 0 gates hold, 1 skipped");
    unlink(path_of("v.csv"));
    free(result);
}

static struct gate_result failed_ladder(void) {
    struct gate_result r = {.gate = {.id = "rod/order", .lo = 1.875, .hi = 2.125, .ceiling = 0.5, .why = "w"},
                            .typed = "ladder rod-step so_ssph --dx 0.5,0.25",
                            .executed = 1};
    r.measured = (struct measured){.value = 1.5, .error = 3e-4, .verdict = VERDICT_FAIL, .reason = "too <low>"};
    snprintf(r.measured.diagnosis, sizeof r.measured.diagnosis, "1 step late");
    r.measured.found = (struct diagnosis){.named = 1, .fault = {FAULT_SWAP, 0}, .unit = ""};
    r.measured.rungs = (struct rungs){3, "dx [m]", "E1", {0.5, 0.25, 0.125}, {4e-2, NAN, 3e-4}, {0, 1, 1}};
    return r;
}

static void failures_have_cause_and_command(void **state) {
    (void)state;
    static const char *const due[] = {"<p>The program <code>mine {case} &lt;{out}&gt;</code> ran",
                                      "<p>too &lt;low&gt;</p>",
                                      "Diagnosis: 1 step late.</p>",
                                      "<p class=\"verdict\">Diagnosis: perhaps 1 step late (1 of 1).</p>",
                                      "<span>rod-step</span>",
                                      "<td class=\"n\">0.5</td><td class=\"n\">4.0000e-02</td><td>left out</td>",
                                      "<td class=\"n\">0.25</td><td>-</td><td>counts</td>",
                                      "<td>1.875 to 2.125</td><td class=\"n\">1.5</td>",
                                      "<td>0.0003, at most 0.5</td>",
                                      "<span>verify</span> <span>-v</span>"};
    struct program program = {.solver = "mine {case} <{out}>"};
    struct gate_result r = failed_ladder();
    const char *page = page_of(&(struct gates){
        .declared = 1, .result = &r, .program = &program, .diagnosis = "perhaps 1 step late (1 of 1)"});
    for (size_t i = 0; i < sizeof due / sizeof *due; i++) assert_has(page, due[i]);
    page = take("v.csv");
    assert_has(page, "\n0,1.875,2.125,1.5,1.5,1.5,0,rod/order\n");
    assert_has(page, "# groups\nrow,scene\n0,rod-step\n");
    assert_has(page, "# rod-step 1\ndx [m],so_ssph,counts,expected order\n0.5,4.000000e-02,0,2\n");
}

/* One curve a method and one more of order 4, the subject's first; curves on top of each other are named together. */
static void plots_have_one_curve_per_method(void **state) {
    (void)state;
    static const char *const method[] = {"ftcs", "so_ssph", "ftcs", "fo_ssph", "ftcs", "cspm"};
    struct gate_result r[6];
    for (int i = 0; i < 6; i++) {
        r[i] = failed_ladder();
        if (i < 5) r[i].measured.rungs.error[2] *= 1 + 0.1 * i; /* cspm as the first ftcs */
        snprintf(r[i].typed, sizeof r[i].typed, "ladder rod-step %s --dx 1", method[i]);
        r[i].gate.id = method[i];
    }
    r[3].measured.rungs.norm = "L2";
    r[4].gate.lo = 3.8, r[4].gate.hi = 4.2;
    FILE *out = begin();
    page_data_write(&(struct gates){.declared = 6, .result = r}, "verify", out);
    fclose(out);
    assert_has(text, "# rod-step 1\ndx [m],so_ssph,");
    assert_has(text, "# rod-step 2\ndx [m],ftcs = cspm,");
    assert_has(text, "# rod-step 3\ndx [m],ftcs of order 4,");
    assert_lacks(text, "# rod-step 4");
    assert_has(text, "\n0.072,1.875,2.125,1.5,1.5,1.5,0,fo_ssph\n");
    assert_has(text, "\n0.125,3.000000e-04,1,2\n");
    r[0].gate.lo = 1.2, r[0].gate.hi = 1.5; /* no whole number */
    out = begin();
    page_data_write(&(struct gates){.declared = 1, .result = r}, "verify", out);
    fclose(out);
    assert_has(text, "\n0.125,3.000000e-04,1,1.35\n");
}

static const char *ladder_page(const char *line) {
    struct ladder *l = xcalloc(1, sizeof *l);
    struct command r;
    struct failure why;
    assert_int_equal(command_read(line, &r, &why), 0);
    assert_int_equal(ladder_run(&r.experiment, &r.rungs, l, &why), 0);
    assert_int_equal(page_ladder_write(l, &(struct diagnosis){0}, r.typed, path_of("l.html"), &why), 0);
    command_free(&r);
    ladder_free(l);
    free(l);
    return take("l.html");
}

static void ladder_page_has_table_and_command(void **state) {
    (void)state;
    const char *page = ladder_page("ladder rod-gauss ftcs --dx 1,0.5 --set 'kappa=1.1' --quantity at:0.31");
    assert_has(page, "<span>--dx</span> <span>1,0.5</span> <span>--set</span> <span>kappa=1.1</span>");
    assert_has(page, "<th>quantity</th><th>its error</th>");
}

static void index_lists_existing_parts(void **state) {
    (void)state;
    struct failure why;
    static const char table[] = "<main>\n<h1>x</h1>\n<p>in it</p>\n</main>\n";
    put("song_table1.html", table, strlen(table));
    assert_int_equal(index_write(folder, &why), STATUS_OK);
    const char *page = take("index.html");
    assert_has(page, "No verdict: the gates were not run. <code>make verify</code> runs them.");
    assert_has(page, "<h3>Table 1: the rod, a jump</h3>\n<p>in it</p>\n<p class=");
    assert_has(page, "; Statements of the papers (<code>make claims</code>).</p>");
    assert_lacks(page, "<h2>Walls</h2>");
    assert_true(strstr(page, "<h2>rod-gauss</h2>") < strstr(page, "<h2>rod-step</h2>"));
    put("scene_wave.svg", "<svg/>", 6); /* a scene with a figure comes before those without */
    assert_int_equal(index_write(folder, &why), STATUS_OK);
    page = take("index.html");
    assert_true(strstr(page, "<h2>wave</h2>") < strstr(page, "<h2>rod-gauss</h2>"));
    unlink(path_of("scene_wave.svg"));
    unlink(path_of("song_table1.html"));
}

static int times(const char *needle) {
    int n = 0;
    for (const char *at = text; (at = strstr(at, needle)); at++) n++;
    return n;
}

/* Points without a temperature or an exact value are left out; no coordinate is NaN. */
static void pictures_have_one_mark_a_point(void **state) {
    (void)state;
    for (int dim = 1; dim <= 3; dim++) {
        struct field f = {0};
        double exact[18];
        field_alloc(&f, dim, 18);
        for (size_t i = 0; i < 18; i++) { /* 3 x 3 x 2 points; both layers are as near the middle, one is drawn */
            const double x[DIM_MAX] = {(double)(i % 3), (double)(i / 3 % 3) + (dim < 3 ? 0.1 * (double)i : 0),
                                       i < 9 ? 0 : 1.5};
            field_put(&f, i, x);
            f.T[i] = 1 + (double)i;
            exact[i] = 1.5 + (double)i;
        }
        f.T[4] = NAN, exact[5] = NAN;
        FILE *out = begin();
        picture_field(out, &(struct measured){.field = f, .due = exact, .due_is = "exact"});
        fclose(out);
        assert_int_equal(times("<svg"), dim == 1 ? 2 : 3);
        assert_int_equal(dim == 1 ? times("<circle") + times("<path") : times("fill=\"#"), dim == 1   ? 50
                                                                                           : dim == 2 ? 3 * 18 - 4
                                                                                                      : 3 * 9 - 4);
        for (const char *at = text; (at = strstr(at, "<rect x=\"")); at++) /* within the frame, which begins at 66 */
            assert_order(atof(at + 9), >, 65.9);
        assert_lacks(text, "nan");
        field_free(&f);
    }
}

/* The titles name what T is compared with; the difference has room for a scale that it does not reach. */
static void pictures_name_what_they_compare(void **state) {
    (void)state;
    for (int dim = 1; dim <= 2; dim++) {
        struct gate_result r = failed_ladder();
        struct measured *m = &r.measured;
        double same[4] = {1, 2, 3, 4};
        field_alloc(&m->field, dim, 4);
        for (size_t i = 0; i < 4; i++)
            field_put(&m->field, i, (double[DIM_MAX]){(double)(i % 2) + (dim == 1 ? (double)i : 0), (double)(i / 2)}),
                m->field.T[i] = same[i];
        m->due = same, m->due_scale = 5e-7;
        snprintf(m->due_is, sizeof m->due_is, "T to 7 digits");
        const char *page = page_of(&(struct gates){.declared = 1, .result = &r});
        unlink(path_of("v.csv"));
        assert_has(page, dim == 1 ? ">T (dots), T to 7 digits (crosses)<" : ">T to 7 digits: 1 to 4 K<");
        assert_has(page, dim == 1 ? ">T less T to 7 digits<" : ">T less T to 7 digits: -5e-07 to 5e-07 K<");
        assert_has(page, "the difference would scatter over 5e-07 K either way.</p>");
        if (dim == 1) assert_has(page, ">5.6e-07<");
        field_free(&m->field);
    }
}

static void ladder_picture_has_band_and_ceiling(void **state) {
    (void)state;
    struct rungs l = {4, "dx [m]", "E1", {0.4, 0.2, 0.1, 0.05}, {8e-3, 2e-3, NAN, 0}, {1, 1, 0, 0}};
    struct gate g = {.lo = 1.9, .hi = 2.1, .ceiling = 1e-4};
    FILE *out = begin();
    picture_ladder(out, &l, &g);
    fclose(out);
    assert_int_equal(times("<circle"), 2);
    assert_int_equal(times("<polygon"), 1);
    assert_int_equal(times("ceiling"), 1);
    assert_lacks(text, "nan");
    out = begin();
    g = (struct gate){.lo = 0, .hi = 1e-3, .ceiling = NAN};
    picture_ladder(out, &l, &g);
    fclose(out);
    assert_int_equal(times("<polygon"), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(text_is_escaped),
        cmocka_unit_test(numbers_are_right_aligned),
        cmocka_unit_test(images_of_any_length),
        cmocka_unit_test(html_and_markdown_have_the_same_text),
        cmocka_unit_test(page_verdict_is_the_worst_gate),
        cmocka_unit_test(failures_have_cause_and_command),
        cmocka_unit_test(plots_have_one_curve_per_method),
        cmocka_unit_test(ladder_page_has_table_and_command),
        cmocka_unit_test(index_lists_existing_parts),
        cmocka_unit_test(pictures_have_one_mark_a_point),
        cmocka_unit_test(pictures_name_what_they_compare),
        cmocka_unit_test(ladder_picture_has_band_and_ceiling),
    };
    assert_non_null(scratch_directory(folder, "heatladder_page"));
    int failed = cmocka_run_group_tests_name("page", tests, NULL, NULL);
    return failed + (rmdir(folder) != 0); /* nothing is left there */
}
