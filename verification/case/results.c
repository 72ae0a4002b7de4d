/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Directories of cases and answers. */
#include "verification/case/results.h"

#include "references/scene.h"
#include "solver/options.h"
#include "solver/status.h"
#include "solver/words.h"
#include "verification/case/case_file.h"
#include "verification/text/output.h"
#include "verification/text/whole_file.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

void results_number(double value, char text[40]) {
    if (value == floor(value) && fabs(value) < 1e6) { /* 100, whose shortest form is 1e+02 */
        snprintf(text, 40, "%.0f", value);
        return;
    }
    snprintf(text, 40, "%.*g", number_digits(value, 0, 17, text), value);
}

static int is_directory(const char *path) {
    struct stat is;
    return stat(path, &is) == 0 && S_ISDIR(is.st_mode);
}

int results_directory(const char *dir, double value, char path[RESULTS_PATH]) {
    char text[40];
    double read;
    results_number(value, text);
    if (snprintf(path, RESULTS_PATH, "%s/%s", dir, text) >= RESULTS_PATH) return -1;
    DIR *in = is_directory(path) ? NULL : opendir(dir);
    for (struct dirent *d; in && (d = readdir(in));)
        if (number_read(d->d_name, &read) == 0 && read == value &&
            snprintf(path, RESULTS_PATH, "%s/%s", dir, d->d_name) >= RESULTS_PATH)
            return closedir(in), -1;
    if (in) closedir(in);
    return 0;
}

static int append(char text[PROGRAM_SETTING], const char *name, const char *value) {
    return words_add(text, PROGRAM_SETTING, "%s%s=%s", *text ? "," : "", name, value);
}

int results_setting(const struct scene *s, const struct problem *p, unsigned long set, const struct mapping *map,
                    double aspect, char text[PROGRAM_SETTING]) {
    char value[40];
    text[0] = '\0';
    for (int i = 0; s->params[i].name; i++) {
        if (!(set & 1ul << i)) continue;
        results_number(p->param[i], value);
        if (append(text, s->params[i].name, s->params[i].choice ? s->params[i].choice[(int)p->param[i]] : value))
            return -1;
    }
    results_number(aspect, value);
    if (aspect > 0 && append(text, "aspect", value)) return -1;
    mapping_print(map, value);
    if (map->axes && append(text, "map", value)) return -1;
    results_number(map->scale, value);
    if (map->scale > 0 && append(text, "scale", value)) return -1;
    results_number(map->offset, value);
    return map->offset != 0 ? append(text, "offset", value) : 0;
}

int results_of_scene(const char *dir, const struct scene *s, const char *setting, char path[RESULTS_PATH]) {
    int n = snprintf(path, RESULTS_PATH, "%s/%s%s%s", dir, s->name, *setting ? "/" : "", setting);
    return n < 0 || n >= RESULTS_PATH - 200 ? -1 : 0;
}

int results_has(const char *dir, const struct scene *s, const char *setting) {
    char path[RESULTS_PATH];
    return results_of_scene(dir, s, setting, path) == 0 && is_directory(path);
}

int results_directory_check(const char *dir, struct failure *why) {
    DIR *in = opendir(dir);
    if (!in) return refuse(why, STATUS_INPUT, "--results '%.300s': %s", dir, strerror(errno));
    closedir(in);
    return STATUS_OK;
}

int results_list(const char *dir, struct numbers *found, struct failure *why) {
    int more = 0;
    double value;
    if (results_directory_check(dir, why)) return STATUS_INPUT;
    DIR *in = xcheck(opendir(dir), 1, BUFSIZ);
    found->count = 0;
    for (struct dirent *d; (d = readdir(in));) {
        if (number_read(d->d_name, &value) || !(value > 0)) continue;
        if (found->count == NUMBERS_MAX)
            more = 1;
        else
            found->value[found->count++] = value;
    }
    closedir(in);
    if (more)
        return refuse(why, STATUS_INPUT, "--results: more than %d spacings in '%.300s'; --dx A,B,C,... says which",
                      NUMBERS_MAX, dir);
    if (!found->count)
        return refuse(why, STATUS_INPUT,
                      "--results: no directory in '%.300s' is called by its spacing, as `heatladder case` makes them",
                      dir);
    return STATUS_OK;
}

/* ---- Parameters ---- */

static int read_param(const struct param *t, const char *text, double *value) {
    if (!t->choice) return number_read(text, value);
    int index = words_index(t->choice, text);
    *value = index;
    return index < 0 ? -1 : 0;
}

static int refuse_value(const struct rows *r, const char *key, const char *valid, struct failure *why) {
    long line = 0;
    const char *value = case_file_value(r, key, &line);
    return refuse(why, STATUS_INPUT, "%.200s, line %ld: %s = %.40s is not %s", r->name, line, key, value ? value : "",
                  valid);
}

static int read_mapping(const struct rows *r, struct results_known *known, struct failure *why) {
    struct mapping map = {0};
    const char *axes = case_file_value(r, "map", NULL), *scale = case_file_value(r, "scale", NULL),
               *offset = case_file_value(r, "offset", NULL);
    if (axes && mapping_read(axes, &map)) return refuse_value(r, "map", "axes such as y,-x", why);
    if (scale && (number_read(scale, &map.scale) || !(map.scale > 0)))
        return refuse_value(r, "scale", "a number > 0", why);
    if (offset && number_read(offset, &map.offset)) return refuse_value(r, "offset", "a number", why);
    if (known->mapped && !mapping_same(&map, known->map))
        return refuse(why, STATUS_INPUT,
                      "%.300s: map, scale or offset differ in other cases, or from --map, --scale, --offset",
                      r->name);
    known->mapped = 1;
    *known->map = map;
    return STATUS_OK;
}

static int read_aspect(const struct rows *r, struct results_known *known, struct failure *why) {
    const char *spacing[] = {"dx", "dy"};
    double d[2];
    if (!case_file_value(r, "dy", NULL)) return STATUS_OK;
    for (int k = 0; k < 2; k++) {
        const char *value = case_file_value(r, spacing[k], NULL);
        if (!value || number_read(value, &d[k]) || !(d[k] > 0))
            return refuse_value(r, spacing[k], "a number > 0", why);
    }
    double aspect = d[1] / d[0];
    if (*known->aspect > 0 && !(fabs(aspect / *known->aspect - 1) < 1e-9))
        return refuse(why, STATUS_INPUT, "%.300s: dy is %g dx, but %g dx in other cases or by --aspect", r->name,
                      aspect, *known->aspect);
    *known->aspect = aspect;
    return STATUS_OK;
}

int results_case_params(const struct rows *r, const struct scene *s, struct results_known *known,
                        struct failure *why) {
    const char *scene = case_file_value(r, "scene", NULL);
    if (!scene || strcmp(scene, s->name) != 0)
        return refuse(why, STATUS_INPUT, "%.300s: not a case of %s", r->name, s->name);
    for (int i = 0; s->params[i].name; i++) {
        char key[80];
        double read;
        snprintf(key, sizeof key, "param_%s", s->params[i].name);
        const char *value = case_file_value(r, key, NULL);
        if (!value) continue;
        if (read_param(&s->params[i], value, &read)) return refuse_value(r, key, "a value of this parameter", why);
        if (known->set & 1ul << i && read != known->p->param[i])
            return refuse(why, STATUS_INPUT, "%.300s: %s = %.40s, but %.17g in other cases or by --set", r->name, key,
                          value, known->p->param[i]);
        known->p->param[i] = read;
        known->set |= 1ul << i;
    }
    int status = read_mapping(r, known, why);
    return status ? status : read_aspect(r, known, why);
}

int results_params(const char *dir, const struct scene *s, const char *setting, const struct numbers *dx,
                   struct results_known *known, struct failure *why) {
    char of_scene[RESULTS_PATH], path[RESULTS_PATH], file[RESULTS_PATH + 16];
    if (results_of_scene(dir, s, setting, of_scene)) return STATUS_OK; /* refused when the answer is read */
    for (int i = 0; i < dx->count; i++) {
        if (results_directory(of_scene, dx->value[i], path)) continue;
        snprintf(file, sizeof file, "%s/case", path);
        if (access(file, F_OK)) snprintf(file, sizeof file, "%s/seed=1/case", path);
        if (access(file, F_OK)) continue;
        struct rows r;
        int status = case_file_read(file, &r, why);
        if (!status) status = results_case_params(&r, s, known, why);
        rows_free(&r);
        if (status) return status;
    }
    return STATUS_OK;
}

/* ---- Writing ---- */

static int write_one(const char *dir, const struct mapping *map, int seed, const struct scene *s,
                     const struct problem *p, const struct options *o, struct failure *why) {
    struct output page;
    case_file_write(s, p, o, &(struct case_extra){.label = "results", .map = map, .seed = seed},
                    output_open(&page, "%s/case", dir));
    output_end(&page);
    char *old = whole_file_at(page.path, NULL), answer[RESULTS_PATH + 16];
    int same = old && page.text && strcmp(old, page.text) == 0, status = STATUS_OK;
    if (old && !same && results_answer(dir, answer, sizeof answer))
        status = refuse(why, STATUS_INPUT,
                        "%.300s: an answer to another case is there; remove it, or take another --into", dir);
    if (!same && !status) status = output_folders(page.path, why);
    if (!same && !status) status = output_close(&page, 1, why);
    output_drop(&page, 1);
    free(old);
    return status;
}

static int has_line(const char *list, const char *line) {
    size_t length = strlen(line);
    for (const char *at = list; (at = strstr(at, line)); at += length)
        if ((at == list || at[-1] == '\n') && (at[length] == '\n' || at[length] == '\0')) return 1;
    return 0;
}

/* Reads the next of the numbers separated by commas, as typed; a fraction contains a slash, which a name cannot. */
static const char *next_name(const char *dx, double *value, char name[64]) {
    size_t length = strcspn(dx, ",");
    snprintf(name, 64, "%.*s", (int)(length < 64 ? length : 63), dx);
    if (number_read(name, value)) *value = 0;
    if (strchr(name, '/')) results_number(*value, name);
    return dx[length] ? dx + length + 1 : NULL;
}

static int check_all(const struct results_place *at, const struct scene *s, const struct problem *p,
                     const struct options *o, const char *dx, struct failure *why) {
    static const struct mapping none = {0};
    struct options with = *o;
    struct image image;
    char path[RESULTS_PATH], name[64];
    mapping_image(at->map ? at->map : &none, p, &image); /* dx and dy refer to the axes of the case */
    if (results_of_scene(at->dir, s, at->setting, path))
        return refuse(why, STATUS_INPUT, "--into '%.300s': too long a path", at->dir);
    while (dx) {
        dx = next_name(dx, &with.dx, name);
        if (case_file_check(&image.problem, &with, why)) return why->status;
    }
    return STATUS_OK;
}

/* Writes the case of one spacing, once per draw, below `path`, which has room for one more name. */
static int write_draws(const struct results_place *at, char path[RESULTS_PATH], const struct scene *s,
                       const struct problem *p, const struct options *o, const char *known, FILE *list, int *written,
                       struct failure *why) {
    size_t used = strlen(path);
    for (int seed = at->seeds > 0; seed <= at->seeds; seed++, ++*written) {
        if (seed) snprintf(path + used, RESULTS_PATH - used, "/seed=%d", seed);
        if (write_one(path, at->map, seed, s, p, o, why)) return why->status;
        if (!has_line(known, path)) fprintf(list, "%s\n", path);
    }
    return STATUS_OK;
}

static int write_all(const struct results_place *at, const struct scene *s, const struct problem *p,
                     const struct options *o, const char *dx, const char *known, FILE *list, int *written,
                     struct failure *why) {
    char of_scene[RESULTS_PATH], path[RESULTS_PATH], name[64];
    struct options with = *o;
    results_of_scene(at->dir, s, at->setting, of_scene);
    *written = 0;
    while (dx) {
        dx = next_name(dx, &with.dx, name);
        snprintf(path, sizeof path, "%.850s/%s", of_scene, name);
        if (*at->rung) words_add(path, sizeof path, "/%.80s", at->rung);
        if (write_draws(at, path, s, p, &with, known, list, written, why)) return why->status;
    }
    return STATUS_OK;
}

int results_write(const struct results_place *at, const struct scene *s, const struct problem *p,
                  const struct options *o, const char *dx, int *written, struct failure *why) {
    struct output page;
    char file[RESULTS_PATH + 16];
    snprintf(file, sizeof file, "%s/cases.txt", at->dir);
    if (check_all(at, s, p, o, dx, why) || output_folders(file, why)) return why->status;
    int lock = open(at->dir, O_RDONLY | O_CLOEXEC); /* other processes may write the same list */
    if (lock >= 0) flock(lock, LOCK_EX);
    FILE *list = output_open(&page, "%.1000s/cases.txt", at->dir);
    char *old = whole_file_at(page.path, NULL);
    if (old) fputs(old, list);
    int status = write_all(at, s, p, o, dx, old ? old : "", list, written, why);
    if (!status) status = output_close(&page, 1, why);
    if (lock >= 0) close(lock);
    output_drop(&page, 1);
    free(old);
    return status;
}

const char *const results_answers[] = {"out.csv", "out.npy", "out.dat", NULL};

int results_answer(const char *dir, char *path, unsigned long size) {
    for (int i = 0; results_answers[i]; i++) {
        snprintf(path, size, "%s/%s", dir, results_answers[i]);
        if (access(path, F_OK) == 0) return 1;
    }
    snprintf(path, size, "%s/%s", dir, results_answers[0]);
    return 0;
}
