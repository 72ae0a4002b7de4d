/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strict numbers: the whole text counts, the value is finite; no blanks, no hexadecimal, no trailing unit. */
#include "verification/text/number.h"

#include <errno.h>
#include <gsl/gsl_sort_double.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* strtod also takes leading blanks, hexadecimal, "inf" and "nan": only the letters of a decimal may reach it. */
static int read_decimal(const char *text, size_t length, double *value) {
    char digits[64], *end;
    if (length == 0 || length >= sizeof digits || strspn(text, "0123456789+-.eE") < length) return -1;
    memcpy(digits, text, length);
    digits[length] = '\0';
    *value = strtod(digits, &end);
    return *end == '\0' && isfinite(*value) ? 0 : -1;
}

static int read_fraction(const char *text, size_t length, double *value) {
    const char *slash = memchr(text, '/', length);
    if (!slash) return read_decimal(text, length, value);
    double above, below;
    size_t left = (size_t)(slash - text);
    if (read_decimal(text, left, &above) || read_decimal(slash + 1, length - left - 1, &below)) return -1;
    *value = above / below;
    return isfinite(*value) ? 0 : -1;
}

int number_read(const char *text, double *value) {
    return read_fraction(text, strlen(text), value);
}

int number_read_list(const char *text, double *values, int max) {
    int n = 0;
    for (const char *at = text;; at++) {
        size_t length = strcspn(at, ",");
        if (n == max || read_fraction(at, length, &values[n])) return -1;
        n++;
        at += length;
        if (*at == '\0') return n;
    }
}

int number_read_whole(const char *text, long max, long *value) {
    if (*text == '\0' || strspn(text, "0123456789") < strlen(text)) return -1;
    errno = 0;
    *value = strtol(text, NULL, 10);
    return errno == 0 && *value <= max ? 0 : -1;
}

static int is_not_finite(const char *text, size_t length) {
    static const char *const words[] = {"nan", "inf", "infinity", NULL};
    size_t sign = length > 0 && (*text == '+' || *text == '-');
    if (length >= sign + 5 && strncasecmp(text + sign, "nan(", 4) == 0) return 1; /* nan(0x8000000000000) */
    if (length >= sign + 5 && strncmp(text + sign, "1.#", 3) == 0) return 1;      /* -1.#IND, 1.#INF00, 1.#QNAN */
    for (int i = 0; words[i]; i++)
        if (strlen(words[i]) == length - sign && strncasecmp(text + sign, words[i], length - sign) == 0) return 1;
    return 0;
}

int number_read_printed(const char *text, size_t length, double *value) {
    char digits[64], *end;
    size_t n = 0;
    *value = NAN;
    if (length == 0) return -1;
    for (size_t i = 0; i < length; i++) {
        char c = text[i];
        if (n + 3 > sizeof digits) return -1; /* an e, c and the NUL */
        int exponent = c == 'e' || c == 'E' || c == 'd' || c == 'D', sign = c == '+' || c == '-';
        if (!exponent && !sign && c != '.' && (c < '0' || c > '9')) return is_not_finite(text, length) ? 1 : -1;
        if (sign && n > 0 && digits[n - 1] != 'e') digits[n++] = 'e';
        digits[n++] = exponent ? 'e' : c;
    }
    digits[n] = '\0';
    double read = strtod(digits, &end);
    if (*end != '\0' || end == digits) return -1;
    if (!isfinite(read)) return 1;
    *value = read;
    return 0;
}

int number_digits(double value, double off, int most, char text[NUMBER_PRINTED]) {
    for (int digits = 1; digits <= most; digits++) {
        snprintf(text, NUMBER_PRINTED, "%.*e", digits - 1, value);
        if (fabs(strtod(text, NULL) - value) <= off * fabs(value)) return digits;
    }
    return most + 1;
}

double number_units(const double *value, size_t n, double off, int *digits) {
    int decimals = 400;
    char text[NUMBER_PRINTED];
    double sum = 0;
    *digits = 0;
    for (size_t i = 0; i < n; i++) {
        double size = fabs(value[i]);
        if (size <= off) continue;
        int of = number_digits(value[i], off / size, 17, text), last = atoi(strchr(text, 'e') + 1) - of + 1;
        if (of > *digits) *digits = of;
        if (last < decimals) decimals = last; /* the power of ten of the last digit */
    }
    for (size_t i = 0; i < n; i++)
        if (fabs(value[i]) > off) sum += pow(10, fmax(floor(log10(fabs(value[i]))) + 1 - *digits, decimals));
    return sum;
}

void number_sort_falling(double *values, int count) {
    double typed[NUMBERS_MAX];
    memcpy(typed, values, (size_t)count * sizeof *values);
    gsl_sort_largest(values, (size_t)count, typed, 1, (size_t)count);
}
