# faults.md from the rows of faults.txt (tabs between) and faults.tsv: fault by row of the battery, and what the
# diagnosis makes of each fault and example.

# The sentence without its number and what is in parentheses; the number is left in `size`.
function name_of(text) {
    sub(/ \([^()]*\)$/, "", text)
    size = match(text, /[0-9][0-9.]*(e[-+]?[0-9]+)?/) ? substr(text, RSTART, RLENGTH) + 0 : 0
    sub(/ [0-9][0-9.]*(e[-+]?[0-9]+)? /, " # ", text)
    return text
}

function right(fault, text,    wanted, wanted_size) {
    wanted = name_of(want[fault]); wanted_size = size
    text = name_of(text)
    if (want[fault] == "-" || !index(text, wanted)) return 0
    return !wanted_size || (size >= 0.8 * wanted_size && size <= 1.2 * wanted_size)
}

FNR == NR {
    if (!($1 in want)) { order[++faults] = $1; want[$1] = $5 }
    next
}
{
    code = $1 SUBSEP $2
    if (!(code in seen)) { seen[code] = 0; codes[++all] = code; fault_of[code] = $1; example_of[code] = $2 }
    if ($3 == "*") { told[code] = $5 == "null" ? "" : $5; next }
    if (!($3 in known)) { known[$3]; row[++rows] = $3 }
    if ($4 == "fail" || $4 == "inconclusive") { caught[$1, $3]++; seen[code]++ }
}
END {
    print "# Faults seeded in the examples, and the rows of the battery that see them\n"
    print "Each cell: in how many of the examples that have the fault the row fails.  Empty: in none.\n"
    line = "| fault | examples | seen in |"; rule = "|---|---:|---:|"
    for (r = 1; r <= rows; r++) {
        any = 0
        for (f = 1; f <= faults; f++) any += caught[order[f], row[r]]
        if (any) { line = line " " row[r] " |"; rule = rule "---:|"; shown[r] }
    }
    print line "\n" rule
    for (f = 0; f <= faults; f++) {
        name = f ? order[f] : "correct"; examples = hits = 0
        for (c = 1; c <= all; c++) if (fault_of[codes[c]] == name) { examples++; hits += seen[codes[c]] > 0 }
        if (!examples) continue
        line = "| " (f ? name : "none") " | " examples " | " hits " |"
        for (r = 1; r <= rows; r++) if (r in shown) line = line " " caught[name, row[r]] " |"
        print line
        if (f) { had += examples; found += hits }
    }
    printf "\n%d of %d faults are seen by at least one row.\n", found, had
    print "\n# What the diagnosis says\n"
    print "| fault | examples | named rightly | wrongly | silent | what it says |\n|---|---:|---:|---:|---:|---|"
    for (f = 0; f <= faults; f++) {
        name = f ? order[f] : "correct"; examples = good = bad = silent = 0; says = ""
        for (c = 1; c <= all; c++) {
            if (fault_of[codes[c]] != name) continue
            examples++
            t = told[codes[c]]
            if (t == "") silent++
            else if (f && right(name, t)) good++
            else bad++
            if (t != "" && (says == "" || (f && right(name, t)))) says = t
        }
        if (!examples) continue
        printf "| %s | %d | %d | %d | %d | %s |\n", f ? name : "none", examples, good, bad, silent, says
        if (f) { cases += examples; goods += good; bads += bad; silents += silent }
        else { correct = examples; correct_bad = bad }
    }
    printf "\nOf %d cases %d are named rightly (%.0f %%), %d wrongly, %d not at all; ", cases, goods,
        100 * goods / (cases ? cases : 1), bads, silents
    printf "of %d correct codes %d have a fault named.\n", correct, correct_bad
    print "\nA case is named by what most of its failing rows say, with the middle one of their sizes: rightly where"
    print "that is the fault and the size within 20 %."
    missed = ""
    for (c = 1; c <= all; c++) if (fault_of[codes[c]] != "correct" && !seen[codes[c]])
        missed = missed "\n- " fault_of[codes[c]] ", " example_of[codes[c]]
    if (missed != "") print "\nNot seen:\n" missed
}
