# Stands in for a method on rod-cosine: the exact solution times 1 + e(dx), so that E1 is e.
#   awk -v error=floor|exponential|stall -f stand_in.awk CASE > OUT
#   awk -v error=second -v tolerance=E ... > OUT           (dx/m)^2 + E, solved, it says, in 2e-5/dx^2 s
{ value[$1] = $3 }
END {
    dx = value["dx"]; pi = atan2(0, -1)
    n = int((value["hi"] - value["lo"]) / dx + 0.5)
    q = value["param_mode"] * pi / value["param_L"]
    if (error == "floor") e = 0.01 * ((dx / 0.1) ^ 2 + 0.0003)
    if (error == "exponential") e = 0.01 * exp(20 * dx)
    if (error == "second") {
        e = dx ^ 2 + tolerance
        print "# seconds = " 2e-5 / dx ^ 2
    }
    if (error == "stall") {
        e = 0.01 * (dx / 0.1) ^ 2
        if (e < 3e-7) { e = 3e-7; print "# steps = 9.9e17" }
    }
    print "x,T"
    for (i = 0; i < n; i++) {
        x = value["lo"] + (i + 0.5) * (value["hi"] - value["lo"]) / n
        T = value["param_Tm"] + value["param_A"] * cos(q * x) * exp(-value["param_kappa"] * q * q * value["t_end"])
        printf "%.17g,%.17g\n", x, T * (1 + e)
    }
}
