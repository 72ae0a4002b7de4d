# A stand-in solver for the tests of --solver: FTCS on the cell-centred points of a rod between cold walls.
#   awk -f ftcs.awk [-v wrong=2] CASE > OUT       `wrong` spoils kappa, `bad` the answer
{ eq = index($0, " = "); value[substr($0, 1, eq - 1)] = substr($0, eq + 3) }
function start(x) {
    if (value["scene"] == "rod-gauss") return exp(-x * x / (2 * value["param_sigma0"] ^ 2))
    return x >= -value["param_a"] && x <= value["param_a"] ? value["param_T0"] : 0
}
END {
    dx = value["dx"]; lo = value["lo"]; kappa = value["k_x"] / value["rho_c"] * (wrong ? wrong : 1)
    n = int((value["hi"] - lo) / dx + 0.5)
    steps = int(value["t_end"] * value["k_x"] / value["rho_c"] / (value["fourier"] * dx * dx) + 1 - 1e-9)
    r = kappa * value["t_end"] / steps / (dx * dx)
    for (i = 1; i <= n; i++) T[i] = start(lo + (i - 0.5) * dx)
    for (s = 1; s <= steps; s++) {
        T[0] = -T[1]; T[n + 1] = -T[n]
        for (i = 1; i <= n; i++) new[i] = T[i] + r * (T[i - 1] - 2 * T[i] + T[i + 1])
        for (i = 1; i <= n; i++) T[i] = new[i]
    }
    print "# seconds = 0.25\n# steps = " steps
    print bad == "header" ? "x;T" : "x,T"
    for (i = n; i >= 1; i--) { # any order will do
        t = sprintf("%.17g", T[i])
        if (i == 3 && bad == "nan") t = "nan"
        if (i == 3 && bad == "word") t = "warm"
        print sprintf("%.17g", lo + (i - 0.5) * dx) "," t
    }
}
