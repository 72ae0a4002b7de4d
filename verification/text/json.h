/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_JSON_H
#define HEATLADDER_VERIFICATION_TEXT_JSON_H

/* Writes JSON (RFC 8259) as it goes.  Numbers carry 17 digits, so that they read back to the same bits; a number that
 * is not finite becomes null.  `key` is the member's name, or NULL within an array and for the outermost value; a
 * unit may follow it in brackets, "dx [m]", which is the header of the column in CSV and no part of the name in JSON.
 *
 * The same calls write a table as CSV: a row is an object at a given depth, a cell a member of it, `NAME_1`, `NAME_2`
 * ... the elements of an array of numbers in it; all else is left out, and null is an empty cell. */

#include "verification/text/csv.h"

#include <stdio.h>

enum { JSON_DEPTH = 16 };

struct json {
    FILE *out;
    int depth;
    int members[JSON_DEPTH]; /* written so far, per level */
    char closing[JSON_DEPTH];
    int row;        /* depth of the rows of a table; 0: JSON */
    struct csv csv; /* collected until the outermost object ends */
    char array[64]; /* name of the last array */
};

/* With the outermost object open, to be ended by json_end; out stays the caller's. */
struct json json_on(FILE *out);

/* The same as CSV: `row` is 1 where the outermost object is the row, 3 for objects in an array in it. */
struct json json_table(FILE *out, int row);

void json_object(struct json *j, const char *key); /* ends with json_end */
void json_array(struct json *j, const char *key);  /* ends with json_end */
void json_end(struct json *j);

/* A value, or with a key a member. */
void json_number(struct json *j, const char *key, double value);
void json_whole(struct json *j, const char *key, long long value);
void json_text(struct json *j, const char *key, const char *value); /* NULL becomes null */

/* An array of `count` numbers. */
void json_numbers(struct json *j, const char *key, const double *values, int count);

/* Several members: "scene %s|dx %g|steps %lld".  %s is a text, %g a number with all its digits; %d, %lld, %zu. */
void json_add(struct json *j, const char *members, ...) __attribute__((format(printf, 2, 3)));

#endif
