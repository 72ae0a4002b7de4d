/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_REPORTS_INDEX_GATES_JSON_H
#define HEATLADDER_REPORTS_INDEX_GATES_JSON_H

/* The gates that `verify --json` has written, read back. */

#include "verification/page/page.h"

struct gates_json {
    int count;
    const char *made;       /* when, where and by which version they were run; into `text` */
    struct page_gate *gate; /* owned; its texts point into `text` */
    char *text;             /* owned */
};

/* 0, or -1 where there is no such file or it is none of verify's. */
int gates_json_read(const char *path, struct gates_json *g);
void gates_json_free(struct gates_json *g);

#endif
