/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cell_lists POINTS RADIUS: neighbours of all points of a cube, by this code.
 *
 * POINTS has x, y, z of each point as doubles.  Prints the number of pairs, each counted twice, and the processor
 * time, s, of cells and lists. */
#include "solver/space/neighbours.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { MOST = 400 };

static struct cloud read_points(const char *path) {
    FILE *file = fopen(path, "rb");
    double x[DIM_MAX];
    if (!file || fseek(file, 0, SEEK_END)) exit(2);
    struct cloud c = {.dim = DIM_MAX, .n = (size_t)ftell(file) / sizeof x};
    c.total = c.n;
    layout_cloud_alloc(&c, c.n);
    rewind(file);
    for (size_t i = 0; i < c.n; i++) {
        if (fread(x, sizeof x, 1, file) != 1) exit(2);
        layout_cloud_put(&c, i, x);
    }
    fclose(file);
    return c;
}

int main(int words, char **word) {
    if (words != 3) return 2;
    struct cloud c = read_points(word[1]);
    struct neighbours nb;
    size_t room = 64 * c.n + MOST, pairs = 0;
    const clock_t begin = clock();
    neighbours_create(&nb, &c, strtod(word[2], NULL));
    uint32_t *list = xcalloc(room, sizeof *list);
    for (size_t i = 0; i < c.n; i++) {
        size_t found = neighbours_find(&nb, i, list + pairs, MOST);
        if (found > MOST || pairs + found + MOST > room) return 2;
        pairs += found;
    }
    printf("%zu %g\n", pairs, (double)(clock() - begin) / CLOCKS_PER_SEC);
    neighbours_free(&nb);
    free(list);
    layout_cloud_free(&c);
    return 0;
}
