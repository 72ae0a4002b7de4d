#!/usr/bin/env bats
# The programs of verification/examples hold rows of the battery; `make codes` runs all rows.
load common

judge() { # command, words of verify
    local command=$1
    shift
    export HEATLADDER=$program PYTHONPATH=$tree/scripts/python PYTHONDONTWRITEBYTECODE=1
    expect 0 ' 0 failed, 0 inconclusive' heatladder verify --solver "$command {case} {out}" "$@"
}
cells='smooth/gauss,contact/rod,plane/source'

@test "cells.c" { judge "$examples/cells_c" --only "$cells,plane/changing,driven/*,nonlinear/blast*,melt/*"; }

@test "cells.f90" {
    [ -x "$examples/cells_f90" ] || skip "gfortran is not here"
    judge "$examples/cells_f90" --only "$cells"
}

@test "cells.py, without walls too, and nodes.py at contacts" {
    needs python3
    judge "python3 $tree/verification/examples/cells.py" --only "$cells,periodic/wave"
    judge "python3 $tree/verification/examples/nodes.py" --only 'contact/rod,contact/plane,contact/steady'
}

@test "rod.py, the code of README" {
    needs python3
    judge "python3 $tree/verification/examples/rod.py" --quick --only 'smooth/*,walls/*,jump/*'
}

@test "cells.m" {
    needs octave-cli
    judge "octave-cli -q -f $tree/verification/examples/cells.m" --only "$cells"
}

@test "cells.awk" { judge "awk -f $tree/verification/examples/cells.awk" --only "$cells"; }

@test "triangles.py at round walls, solid.py as a thin box, lines.py" {
    python=$("$tree/scripts/interpreter" scipy)
    [ -n "$python" ] || skip "SciPy is not here (make setup-peers)"
    judge "$python $tree/verification/examples/triangles.py" --only 'round/c*'
    judge "$python $tree/verification/examples/solid.py" --only 'plane/source,contact/rod'
    judge "$python $tree/verification/examples/lines.py" --only 'smooth/gauss,contact/rod,nonlinear/smooth'
}

@test "cvode.c" {
    [ -x "$examples/cvode" ] || skip "SUNDIALS is not here (make setup-peers)"
    judge "$examples/cvode" --only 'smooth/gauss,contact/rod,walls/cooled,plane/source,driven/rod,nonlinear/*'
}

few='contact/plane,plane/cooled'
with_module() { # module, example
    python=$("$tree/scripts/interpreter" "$1")
    [ -n "$python" ] || skip "$1 is not here (make setup-peers)"
    judge "$python $tree/verification/examples/$2" --only "$few"
}

@test "heat_getfem.py" { with_module getfem heat_getfem.py; }
@test "heat_petsc.py" { with_module petsc4py heat_petsc.py; }
@test "heat_sfepy.py" { few=contact/steady with_module sfepy heat_sfepy.py; } # its runs take seconds

@test "heat_calculix.py" {
    needs ccx
    with_module numpy heat_calculix.py
}

@test "heat_escript.py" {
    needs run-escript
    judge "run-escript $tree/verification/examples/heat_escript.py" --only "$few"
}

@test "heat_bim.m" {
    octave-cli -q --eval 'pkg load bim' 2>/dev/null || skip "Octave's package bim is not here (make setup-peers)"
    judge "octave-cli -q $tree/verification/examples/heat_bim.m" --only "$few"
}

@test "heat_desolve.R" {
    Rscript -e 'library(deSolve)' 2>/dev/null || skip "R's package deSolve is not here (make setup-peers)"
    judge "Rscript $tree/verification/examples/heat_desolve.R" --only "$few"
}

@test "make codes and setup-peers refuse a code that scripts/peers.txt does not have" {
    needs python3
    expect 1 'cubes: not in scripts/peers.txt, which has c fortran' python3 "$tree/scripts/codes" "$program" build out cubes
    expect 2 "'cubes' is none of: awk .* voro" "$tree/scripts/setup-peers" cubes
}
