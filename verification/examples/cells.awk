# LC_ALL=C awk -f cells.awk CASE OUT: finite volumes on a grid of cells, explicit Euler.  All that the case does not
# tell, `heatladder reference` does, at the centres of cells and of faces on the sides; $HEATLADDER is that program.
function place(d, i) { return i < 1 ? lo[d] : i > n[d] ? hi[d] : lo[d] + (i - 0.5) * h[d] }
function position(c, d) { return d == 1 ? c % nx : int(c / nx) }
BEGIN {
    OFMT = CONVFMT = "%.17g"
    while ((getline line < ARGV[1]) > 0)
        { at = index(line, " = "); field[substr(line, 1, at - 1)] = substr(line, at + 3) }
    dim = field["dim"] + 0; t_end = field["t_end"] + 0; n[2] = 1
    split(field["lo"], lo, ", "); split(field["hi"], hi, ", "); split(field["cells"], n, ", ")
    for (d = 1; d <= dim; d++) h[d] = (hi[d] - lo[d]) / n[d]
    # Cells 1 to n along each axis, framed by the faces on the sides; a rod is one row, without a frame in y.
    nx = n[1] + 2; all = nx * (dim == 2 ? n[2] + 2 : 1); points = ARGV[2] ".points"
    print (dim == 2 ? "x,y,dx,dy" : "x,dx") > points
    for (c = 0; c < all; c++) {
        inside = 1; row = width = ""
        for (d = 1; d <= dim; d++) {
            i = position(c, d); inside = inside && i >= 1 && i <= n[d]
            row = row place(d, i) ","; width = width (d > 1 ? "," : "") h[d]
        }
        print row width > points; if (inside) { cell[++m] = c; where[c] = row }
    }
    close(points); program = "HEATLADDER" in ENVIRON ? ENVIRON["HEATLADDER"] : "heatladder"
    ask = program " reference " field["oracle"] " --points '" points "' --time 0"
    command = ask " --what initial_heat,source,rho_c,k_x,wall_x" (dim == 2 ? ",k_y,wall_y" : "")
    for (c = -1; (command | getline line) > 0; c++) {
        split(line, told, ",")
        T[c] = told[dim + 1]; source[c] = told[dim + 2]; rho_c[c] = told[dim + 3]
        for (d = 1; (at = dim + 4 * d) <= 5 * dim; d++) {
            k[c, d] = told[at]; kind[c, d] = told[at + 1]; value[c, d] = told[at + 2]; b[c, d] = told[at + 3]
        }
    }
    if (close(command) || c != all) exit 1
    # Conductances of the faces, over the cell's width: half cells in series, and at a side Robin's coefficient.
    for (a = 1; a <= m; a++) {
        c = cell[a]; speed = 0
        for (d = 1; d <= dim; d++) for (s = -1; s <= 1; s += 2) {
            e = c + s * (d == 1 ? 1 : nx); side = position(c, d) == (s < 0 ? 1 : n[d])
            beyond = !side ? h[d] / (2 * k[e, d]) : kind[e, d] == 3 ? 1 / b[e, d] : 0
            if (side) T[e] = value[e, d]
            if (side && kind[e, d] == 2) flux[c] += value[e, d] / h[d]
            else { g[a, ++faces[a]] = 1 / (h[d] / (2 * k[c, d]) + beyond) / h[d]; next_to[a, faces[a]] = e }
            speed += k[c, d] / (h[d] * h[d] * rho_c[c]) / 2; fastest = speed > fastest ? speed : fastest
        }
    }
    steps = t_end * fastest / 0.25; steps = int(steps) + (steps > int(steps)); dt = t_end / steps
    command = ask ":" t_end ":" steps + 1 " --what source | tail -n +2" # for all steps
    for (step = 1; step <= steps; step++) {
        for (c = 0; c < all && field["source"] == "changing" && (command | getline line) > 0; c++)
            source[c] = substr(line, match(line, /[^,]*$/)) + 0
        for (a = 1; a <= m; a++) {
            rate[a] = source[c = cell[a]] + flux[c]
            for (s = 1; s <= faces[a]; s++) rate[a] += g[a, s] * (T[next_to[a, s]] - T[c])
        }
        for (a = 1; a <= m; a++) T[cell[a]] += dt * rate[a] / rho_c[cell[a]]
    }
    print "# steps = " steps "\n" (dim == 2 ? "x,y,T" : "x,T") > ARGV[2]
    for (a = 1; a <= m; a++) print where[cell[a]] T[cell[a]] > ARGV[2]
}
