/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ranges of RFC 3629, section 4. */
#include "verification/text/utf8.h"

static int is_more(unsigned char byte) {
    return (byte & 0xC0) == 0x80;
}

size_t utf8_length(const char *text) {
    const unsigned char *c = (const unsigned char *)text;
    if (c[0] < 0x80) return c[0] >= ' ' && c[0] != 0x7F;
    if (c[0] < 0xC2 || c[0] > 0xF4 || !is_more(c[1])) return 0;
    if (c[0] < 0xE0) return c[0] == 0xC2 && c[1] < 0xA0 ? 0 : 2; /* C1 */
    if (!is_more(c[2])) return 0;
    if (c[0] < 0xF0) {
        unsigned point = (c[0] & 0x0Fu) << 12 | (c[1] & 0x3Fu) << 6 | (c[2] & 0x3Fu);
        return point < 0x800 || (point >= 0xD800 && point < 0xE000) || point >= 0xFFFE ? 0 : 3;
    }
    if (!is_more(c[3]) || (c[0] == 0xF0 && c[1] < 0x90) || (c[0] == 0xF4 && c[1] >= 0x90)) return 0;
    return 4;
}

void utf8_clean(char *text) {
    while (*text) {
        size_t length = utf8_length(text);
        if (!length) *text = '?';
        text += length ? length : 1;
    }
}
