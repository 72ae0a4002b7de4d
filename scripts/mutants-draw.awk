# SPDX-License-Identifier: GPL-3.0-or-later
# Every change of a single token of the C files named, a line each, in an order that `seed` decides (tabs between):
# name | file | line | the line changed | what is changed.  Left out are comments, directives and texts in quotes.

function change(at, size, other,    name) {
    name = FILENAME
    sub(/.*\//, "", name)
    name = name ":" FNR ":" at (seen[name, FNR, at]++ ? "b" : "")
    candidate[++count] = name "\t" FILENAME "\t" $0 "\t" substr($0, 1, at - 1) other substr($0, at + size) "\t" \
        substr($0, at, size) " becomes " (other == "" ? "nothing" : other)
}

# At each place of the line that is code: what `pattern` matches there, without the blanks about it.
function each(pattern, others,    from, rest, at, size, n, k, list) {
    n = split(others, list, " ")
    for (from = 1; match(rest = substr(code, from), pattern); from += RSTART + (RLENGTH > 2 ? RLENGTH - 2 : 0)) {
        at = from + RSTART - 1; size = RLENGTH
        while (substr(code, at, 1) ~ /[ (,[]/ && size > 1) { at++; size-- }
        while (substr(code, at + size - 1, 1) ~ /[ ),;\]]/ && size > 1) size--
        for (k = 1; k <= n; k++) change(at, size, list[k])
        if (!n) change(at, size, "")
    }
}

BEGIN {
    srand(seed)
    tokens = split("+ - * / < <= > >= == != && || += -= *=", token, " ")
    split("- + / * <= < >= > != == || && -= += /=", other, " ")
}
/^ *(#|\/\/|\/\*)/ || /\t/ { inside = /\/\*/ && !/\*\//; next }
inside { inside = !/\*\//; next }
{
    code = $0
    while (match(code, /"([^"\\]|\\.)*"|'([^'\\]|\\.)*'|\/\/.*|\/\*.*/))
        code = substr(code, 1, RSTART - 1) sprintf("%" RLENGTH "s", "") substr(code, RSTART + RLENGTH)
    code = code " "
    for (t = 1; t <= tokens; t++) {
        pattern = token[t]
        gsub(/[+*|]/, "[&]", pattern)
        each(" " pattern " ", other[t])
    }
    each("[ ([,]0[]),; ]", "1")
    each("[ ([,]1[]),; ]", "0 2")
    each("[ ([,]2[]),; ]", "1 3")
    each(" [-+] [a-z_0-9.]+[]),;]", "")
    each("fmin", "fmax")
    each("fmax", "fmin")
    gsub(/!=/, "  ", code)
    each("[ (]!", "")
}
END {
    for (k = 1; k <= count; k++) printf "%.12f\t%s\n", rand(), candidate[k] | "sort -n | cut -f 2-"
}
