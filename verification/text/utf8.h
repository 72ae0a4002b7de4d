/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_UTF8_H
#define HEATLADDER_VERIFICATION_TEXT_UTF8_H

#include <stddef.h>

/* Characters of UTF-8 (RFC 3629) in text from elsewhere, ended by a NUL. */

/* Bytes of the character at `text`, 1 to 4; 0 for bytes that a terminal, a page or XML cannot take: control
 * characters (C0, DEL, C1), surrogates, U+FFFE, U+FFFF, overlong or incomplete sequences, the end. */
size_t utf8_length(const char *text);

/* Replaces each byte that belongs to no character by '?'. */
void utf8_clean(char *text);

#endif
