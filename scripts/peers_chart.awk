# One chart's data from runs.csv: a block a program, n, E1 and the median solve.  -v scene=S -v threads=N; what was
# measured with one thread alone stands for itself among N.
function median(who, t, n,    k, i, j, v) {
    k = count[who, t, n]
    for (i = 1; i <= k; i++) v[i] = solve[who, t, n, i]
    for (i = 2; i <= k; i++) for (j = i; j > 1 && v[j] < v[j - 1]; j--) { x = v[j]; v[j] = v[j - 1]; v[j - 1] = x }
    return k % 2 ? v[(k + 1) / 2] : (v[k / 2] + v[k / 2 + 1]) / 2
}
$1 != scene || $7 == "" || ($3 != "ours" && $3 != "peer") || ($2 != 1 && $2 != threads) { next }
{
    if (!(($4) in sizes)) name[++names] = $4
    if (!(($4, $5) in seen)) { seen[$4, $5]; sizes[$4] = sizes[$4] " " $5 }
    solve[$4, $2, $5, ++count[$4, $2, $5]] = $8
    E[$4, $2, $5] = $7
    has[$4, $2]
}
END {
    printf "# title: %s: others beside ours, %s\n# command: make bench-peers\n", scene,
        threads == 1 ? "one thread" : "all " threads " threads (load " load " when it began)"
    for (p = 1; p <= names; p++) {
        who = name[p]
        t = ((who, threads) in has) ? threads : 1
        label = who (t == threads ? "" : " (one thread)")
        printf "%s# %s\nn,E1 [-],solve [s],%s\n", (p > 1 ? "\n\n" : ""), who, label
        m = split(sizes[who], n, " ")
        for (i = 1; i <= m; i++) if ((who, t, n[i]) in E)
            printf "%d,%s,%.6e,%s\n", n[i], E[who, t, n[i]], median(who, t, n[i]), label
    }
}
