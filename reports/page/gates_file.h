#ifndef HEATLADDER_REPORTS_PAGE_GATES_FILE_H
#define HEATLADDER_REPORTS_PAGE_GATES_FILE_H

/* The gates that `verify --json` has written, read back. */

#include "verification/page/page.h"

struct gates_file {
    int count;
    struct page_gate *gate; /* owned; its texts point into `text` */
    char *text;             /* owned */
};

/* 0, or -1 where there is no such file or it is none of verify's. */
int gates_file_read(const char *path, struct gates_file *g);
void gates_file_free(struct gates_file *g);

#endif
