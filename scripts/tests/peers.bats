#!/usr/bin/env bats
# The adapters of public codes (make setup-peers) hold rows of the battery; `make codes` runs all rows.
load common

few='contact/plane,plane/cooled'
with_module() { # module, example
    python=$("$tree/scripts/interpreter" "$1")
    [ -n "$python" ] || skip "$1 is not here (make setup-peers)"
    judge "$python $tree/verification/examples/$2" --only "$few"
}

@test "heat_getfem.py" { with_module getfem heat_getfem.py; }
@test "heat_petsc.py" { with_module petsc4py heat_petsc.py; }
@test "heat_sfepy.py" { few=contact/steady with_module sfepy heat_sfepy.py; } # its runs take seconds
@test "heat_pypde.py" { few=walls/cooled,plane/corners with_module pde heat_pypde.py; } # materials: reports/README.md
@test "heat_nutils.py" { few=contact/rod,periodic/wave with_module nutils heat_nutils.py; }

@test "heat_skfem.py" { with_module skfem heat_skfem.py; }
@test "heat_fipy.py" { few=walls/cooled with_module fipy heat_fipy.py; } # its runs take seconds

@test "heat_dealii.cc, which skips a field" {
    [ -x "$examples/heat_dealii" ] || skip "deal.II is not here (make setup-peers)"
    judge "$examples/heat_dealii" --only "$few"
    expect 77 'field/patch: skipped' heatladder verify --solver "$examples/heat_dealii {case} {out}" --only field/patch
}

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

@test "elements.py, of FEniCSx" { few=contact/plane with_module dolfinx elements.py; }
@test "particles.py, of PySPH" { few=whole/overshoot with_module pysph particles.py; } # of no order at this h/dx

@test "elements.edp and tetrahedra.edp, of FreeFem++" {
    needs FreeFem++
    judge "FreeFem++ -nw -v 0 $tree/verification/examples/elements.edp {case} {out} P2" --only "$few"
    judge "FreeFem++ -nw -v 0 $tree/verification/examples/tetrahedra.edp {case} {out} P1" --only space/walls
}

@test "cubic.edp, of FreeFem++" {
    [ -e /usr/lib/freefem++/Element_P3.so ] || skip "FreeFem++'s P3 is not here (make setup-peers)"
    export FF_LOADPATH='/usr/lib/freefem++;;'
    judge "FreeFem++ -nw -v 0 $tree/verification/examples/cubic.edp {case} {out} P3" --order 4 --only smooth/gauss
}

@test "laplacianfoam.py" {
    needs laplacianFoam
    few=smooth/gauss,jump/faces with_module subprocess laplacianfoam.py
}

@test "shells.js" {
    needs node
    judge "node $tree/verification/examples/shells.js" --only space/ball
}
