/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Words of a command line: globs, and words quoted for a shell. */
#include "verification/text/shell.h"

#include "solver/status.h"

#include <fnmatch.h>
#include <stdio.h>
#include <string.h>

int shell_is_plain(const char *word) {
    static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789/._-+=,@%";
    return *word && word[strspn(word, plain)] == '\0';
}

const char *shell_literal(const char *word, char *pattern, size_t size) {
    size_t n = 0;
    for (; *word && n + 2 < size; word++) {
        if (strchr("\\*?[,", *word)) pattern[n++] = '\\';
        pattern[n++] = *word;
    }
    pattern[n] = '\0';
    return pattern;
}

const char *shell_glob(const char *globs, char *glob, size_t size) {
    size_t n = 0;
    for (; *globs && *globs != ','; globs++) {
        if (n + 1 < size) glob[n++] = *globs;
        if (*globs != '\\' || !globs[1]) continue;
        globs++;
        if (n + 1 < size) glob[n++] = *globs;
    }
    glob[n] = '\0';
    return *globs ? globs + 1 : NULL;
}

int shell_match(const char *globs, const char *name) {
    char glob[1024];
    while (globs) {
        globs = shell_glob(globs, glob, sizeof glob);
        if (fnmatch(glob, name, 0) == 0) return 1;
    }
    return 0;
}

/* '...' holds all but a quote, which becomes '\'' (POSIX, shell command language, 2.2.2). */
char *shell_line(int count, const char *const *words) {
    size_t room = 1;
    for (int i = 0; i < count; i++) room += 4 * strlen(words[i]) + 3;
    char *line = xcalloc(room, 1), *to = line;
    for (int i = 0; i < count; i++) {
        const char *from = words[i];
        int quoted = !shell_is_plain(from);
        if (i > 0) *to++ = ' ';
        if (quoted) *to++ = '\'';
        for (; *from; from++) to += sprintf(to, *from == '\'' ? "'\\''" : "%c", *from);
        if (quoted) *to++ = '\'';
    }
    return line;
}
