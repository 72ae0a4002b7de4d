# league.md and league.csv in the directory `to`, from codes (name, version or -), rows (code, row, verdict, measured,
# error, diagnosis) and rungs (code, row, E1, seconds), all with tabs between.

# Seconds at the error E on the straight line (log-log) between the rungs on either side; what E is beyond is said.
function at(code, row, E,    i, n, e, s, x) {
    n = count[code, row]
    if (!n) return "-"
    if (error[code, row, 1] <= E) return sprintf("< %.2g", seconds[code, row, 1])
    for (i = 2; i <= n; i++) if (error[code, row, i] <= E) {
        x = log(E / error[code, row, i - 1]) / log(error[code, row, i] / error[code, row, i - 1])
        s = seconds[code, row, i - 1]
        return sprintf("%.2g", s * exp(x * log(seconds[code, row, i] / s)))
    }
    return "-"
}

FNR == 1 { file++ }
file == 1 { code[++codes] = $1; version[$1] = $2; next }
file == 2 {
    key = $1 SUBSEP $2
    verdict[key] = $3; order[key] = $4; finest[key] = $5
    tally[$1, $3]++
    if ($3 == "fail" || $3 == "inconclusive") {
        names = failed[$1]
        failed[$1] = names (names == "" ? "" : ", ") $2 ($3 == "inconclusive" ? " (inconclusive)" : "") ($6 ~ /^as if/ ? " (" $6 ")" : "")
        sub(/ \([0-9]+ % of the error\)/, "", failed[$1])
    }
    next
}
$3 > 0 && $4 > 0 { n = ++count[$1, $2]; error[$1, $2, n] = $3; seconds[$1, $2, n] = $4 }
END {
    md = to "/league.md"; csv = to "/league.csv"
    print "# Other codes\n" >md
    print "Each code runs by its example in verification/examples.  A row of the battery that needs what code or" >md
    print "glue has not is skipped.\n" >md
    print "| code | version | rows held | failed | inconclusive | skipped | what did not hold |" >md
    print "|---|---|---:|---:|---:|---:|---|" >md
    for (c = 1; c <= codes; c++) {
        who = code[c]
        if (version[who] == "-") print "| " who " | not here (make setup-peers) | | | | | |" >md
        else printf "| %s | %s | %d | %d | %d | %d | %s |\n", who, version[who], tally[who, "pass"],
            tally[who, "fail"], tally[who, "inconclusive"], tally[who, "skipped"], failed[who] >md
    }
    rows = split("smooth/gauss jump/faces contact/rod plane/square plane/source", row, " ")
    split("rod-gauss rod-step rod-contact square-step rect-manufactured", scene, " ")
    print "\nOrder, E1 at the finest of the row's spacings, verdict, and the seconds of the whole command with" >md
    print "its start-up at E1 = 1e-3 on the machine that this ran on (<: the coarsest rung is below that).\n" >md
    print "| code | scene | order | E1 | verdict | s at 1e-3 |\n|---|---|---:|---:|---|---:|" >md
    for (c = 1; c <= codes; c++) for (r = 1; r <= rows; r++) {
        key = code[c] SUBSEP row[r]
        if (!(key in verdict)) continue
        if (verdict[key] == "skipped") printf "| %s | %s | | | skipped | |\n", code[c], scene[r] >md
        else printf "| %s | %s | %.2f | %.1e | %s | %s |\n", code[c], scene[r], order[key], finest[key], verdict[key],
            at(code[c], row[r], 1e-3) >md
    }
    print "# title: square-step: error against time, other codes\n# command: make league" >csv
    for (c = 1; c <= codes; c++) {
        who = code[c]; k = count[who, "plane/square"]
        if (!k) continue
        printf "%s# %s\nE1 [-],seconds [s],%s\n", (blocks++ ? "\n\n" : ""), who, who >csv
        for (i = 1; i <= k; i++)
            printf "%s,%s,%s\n", error[who, "plane/square", i], seconds[who, "plane/square", i], who >csv
    }
}
