# SPDX-License-Identifier: GPL-3.0-or-later
# LC_ALL=C awk -f cells.awk CASE OUT: finite volumes on a grid of cells, explicit Euler.
#
#     rho_c dT/dt = source + sum over the faces of a cell of conductance (T_beyond - T)
#
# The case file gives the grid and the end time.  `heatladder reference` gives all else (start,
# source, coefficients, walls) at the centres of the cells and of the faces on the sides.
# $HEATLADDER is the path of that program.

function stop(reason) {
    print "cells.awk: " reason >"/dev/stderr"
    failed = 1
    exit 1
}

function read_case(path,    line, equals, found, d) {
    while ((found = (getline line < path)) > 0) {
        equals = index(line, " = ")
        field[substr(line, 1, equals - 1)] = substr(line, equals + 3)
        if (line ~ /^shape|^walls|^k_law|^contact_r|^conductivity|^dim = 3|= periodic/) exit 77 # steady rectangles of one k
    }
    if (found < 0) stop("the case cannot be opened")
    dim = field["dim"] + 0
    t_end = field["t_end"] + 0
    n[2] = 1
    split(field["cells"], n, ", ")
    split(field["lo"], lo, ", ")
    split(field["hi"], hi, ", ")
    for (d = 1; d <= dim; d++) width[d] = (hi[d] - lo[d]) / n[d]
}

# The points: cells 1 to n along each axis, in a frame of the centres of the faces on the sides
# (drawn in cells.c).
function place(c, d) {
    return d == 1 ? c % stride[2] : dim == 1 ? 1 : int(c / stride[2])
}

function is_cell(c,    d) {
    for (d = 1; d <= dim; d++) if (place(c, d) < 1 || place(c, d) > n[d]) return 0
    return 1
}

function position(c, d,    i) {
    i = place(c, d)
    return i < 1 ? lo[d] : i > n[d] ? hi[d] : lo[d] + (i - 0.5) * width[d]
}

function make_points(path,    c) {
    stride[1] = 1
    stride[2] = n[1] + 2
    points = stride[2] * (dim == 2 ? n[2] + 2 : 1)
    print (dim == 2 ? "x,y,dx,dy" : "x,dx") >path
    for (c = 0; c < points; c++) {
        at[c] = position(c, 1) (dim == 2 ? "," position(c, 2) : "")
        print at[c] "," width[1] (dim == 2 ? "," width[2] : "") >path
        if (is_cell(c)) cell[++cells] = c
    }
    close(path)
}

# The command that asks `reference` at the points; its first line is a header.
function question(path, times, what) {
    return ("HEATLADDER" in ENVIRON ? ENVIRON["HEATLADDER"] : "heatladder") " reference " field["oracle"] \
        " --points '" path "' --time " times " --what " what
}

function ask_scene(path,    command, what, c, line, word, first, d) {
    what = "initial_mean,source,rho_c,k_x,wall_x" (dim == 2 ? ",k_y,wall_y" : "")
    command = question(path, "0", what)
    command | getline line
    for (c = 0; c < points; c++) {
        if ((command | getline line) <= 0) stop("no answer from heatladder reference")
        split(line, word, ",")
        T[c] = word[dim + 1]
        source[c] = word[dim + 2]
        rho_c[c] = word[dim + 3]
        for (d = 1; d <= dim; d++) {
            first = dim + 4 * d
            k[c, d] = word[first]
            kind[c, d] = word[first + 1] # 1: held, 2: a given flux, 3: cooled
            value[c, d] = word[first + 2]
            b[c, d] = word[first + 3]
        }
    }
    if (close(command)) stop("heatladder reference failed")
}

# The face of cell c towards e: half cells in series, or a half cell and what the wall resists.
function make_face(c, e, d,    is_wall, resistance) {
    is_wall = !is_cell(e)
    resistance = width[d] / (2 * k[c, d])
    if (is_wall) T[e] = value[e, d]
    if (is_wall && kind[e, d] == 2) {
        flux[c] += value[e, d] / width[d]
        return
    }
    if (!is_wall) resistance += width[d] / (2 * k[e, d])
    if (is_wall && kind[e, d] == 3) resistance += 1 / b[e, d]
    faces[c]++
    beyond[c, faces[c]] = e
    conductance[c, faces[c]] = 1 / (resistance * width[d])
}

# Makes the faces of all cells.  Returns the largest sum of kappa/dx^2 over the axes, s^-1.
function make_faces(    a, c, d, speed, fastest) {
    for (a = 1; a <= cells; a++) {
        c = cell[a]
        speed = 0
        for (d = 1; d <= dim; d++) {
            make_face(c, c - stride[d], d)
            make_face(c, c + stride[d], d)
            speed += k[c, d] / (width[d] * width[d] * rho_c[c])
        }
        if (speed > fastest) fastest = speed
    }
    return fastest
}

function step_by(dt,    a, c, face, rate) {
    for (a = 1; a <= cells; a++) {
        c = cell[a]
        rate[a] = source[c] + flux[c]
        for (face = 1; face <= faces[c]; face++)
            rate[a] += conductance[c, face] * (T[beyond[c, face]] - T[c])
    }
    for (a = 1; a <= cells; a++) T[cell[a]] += dt * rate[a] / rho_c[cell[a]]
}

# A source that changes in time is asked for at the start of every step.
function run(path,    changing, command, step, c, line, word) {
    changing = field["source"] == "changing"
    command = question(path, "0:" t_end ":" steps + 1, "source")
    if (changing) command | getline line
    for (step = 1; step <= steps; step++) {
        for (c = 0; changing && c < points; c++) {
            command | getline line
            source[c] = word[split(line, word, ",")] # the last column
        }
        step_by(t_end / steps)
    }
}

function write_answer(path,    a) {
    print "# steps = " steps >path
    print (dim == 2 ? "x,y,T" : "x,T") >path
    for (a = 1; a <= cells; a++) print at[cell[a]] "," T[cell[a]] >path
    close(path)
}

BEGIN {
    OFMT = CONVFMT = "%.17g"
    if (ARGC != 3) stop("two arguments are needed: CASE OUT")
    read_case(ARGV[1])
    make_points(ARGV[2] ".points")
    ask_scene(ARGV[2] ".points")
    steps = t_end * make_faces() / 0.25
    steps = int(steps) + (steps > int(steps))
    run(ARGV[2] ".points")
    write_answer(ARGV[2])
    exit failed
}
