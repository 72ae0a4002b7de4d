# shellcheck shell=sh disable=SC2154
# For the scripts that run kept commands, after check_kit.sh: the program is `heatladder` and the example in C is `cells`
# for them, in a folder of their own.
examples=${EXAMPLES:-build/examples}
case $examples in /*) ;; *) examples=$PWD/$examples ;; esac
[ -x "$examples/cells_c" ] || { echo "$name: $examples/cells_c is not built" >&2; exit 1; }
mkdir "$scratch/bin"
ln -s "$program" "$scratch/bin/heatladder"
ln -s "$examples/cells_c" "$scratch/bin/cells"
PATH=$scratch/bin:$PATH
export PATH COLUMNS=100 NO_COLOR=1

# Seconds: a column under its head; `(0.01 s)` at the end of a verdict; the cost of a run; a member of JSON or XML.
without_seconds() {
    awk '
        { text = $0 }
        match(text, / seconds/) { from = RSTART; upto = RSTART + RLENGTH }
        text == "" { from = 0 }
        from && substr(text, upto - 5, 5) ~ /[0-9]$/ {
            text = substr(text, 1, from - 2) sprintf("%" (upto - from + 2) "s", "T") substr(text, upto)
        }
        {
            sub(/[0-9.e+-]+ s\)/, "T s)", text)
            if (text ~ /^[0-9]+ of [0-9]+  /) sub(/[0-9.]+ s$/, "T s", text)
            sub(/^  cost +[0-9.e+-]+ s/, "  cost T s", text)
            gsub(/"(step_)?seconds": *[0-9.e+-]+/, "\"seconds\": T", text)
            gsub(/"made": *"[^"]*"/, "\"made\": T", text)
            gsub(/ time(stamp)?="[^"]*"/, " time=T", text)
            print text
        }'
}
