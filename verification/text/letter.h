/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HEATLADDER_VERIFICATION_TEXT_LETTER_H
#define HEATLADDER_VERIFICATION_TEXT_LETTER_H

#include <stddef.h>

/* Letters of UTF-8 (RFC 3629) in text that others wrote. */

/* How many bytes the letter at `text` has (1 to 4), text ended by a NUL; 0 where the bytes there are no letter that a
 * terminal, a page and XML can take: control characters (C0, DEL, C1), surrogates, U+FFFE, U+FFFF, what is too long
 * or cut off, the end. */
size_t letter_length(const char *text);

/* Puts '?' in the place of each byte that belongs to no letter. */
void letter_clean(char *text);

/* How many of the `length` bytes at `text` are whole letters: less by the bytes of a last one that is cut off. */
size_t letter_whole(const char *text, size_t length);

#endif
