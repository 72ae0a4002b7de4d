/* Memory of a field. */
#include "solver/field.h"

#include "solver/status.h"

#include <stdlib.h>

void field_alloc(struct field *f, int dim, size_t n) {
    *f = (struct field){.dim = dim, .n = n};
    f->x = xcalloc(n, sizeof *f->x);
    f->y = dim == 2 ? xcalloc(n, sizeof *f->y) : NULL;
    f->T = xcalloc(n, sizeof *f->T);
}

void field_free(struct field *f) {
    free(f->x);
    free(f->y);
    free(f->T);
    free(f->weight);
    *f = (struct field){0};
}
