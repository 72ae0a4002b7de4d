#!/usr/bin/env bats
# The programs of verification/examples hold rows of the battery; peers.bats has those that need a public code, and
# `make codes` runs all rows.
load common

cells='smooth/gauss,contact/rod,plane/source'

# A python3 of PATH may be a script that looks for one: a tenth of a second in each of a hundred runs.
find_python() { # module: else the test is skipped
    python=$("$tree/scripts/interpreter" "$1")
    [ -n "$python" ] || skip "no Python with $1 is here (make setup-peers has SciPy)"
}

@test "cells.c" { judge "$examples/cells_c" --only "$cells,plane/changing,driven/*,nonlinear/blast*,melt/*"; }

@test "cells.c along a field, by fluxes at faces and at corners" {
    judge "$examples/cells_c" --only 'field/aligned,field/walls,field/oblique'
    expect 0 ' 0 failed, 0 inconclusive' heatladder verify --solver "$examples/cells_c {case} {out} corner" \
        --only 'field/aligned,field/walls,field/oblique'
}

@test "cells.f90" {
    [ -x "$examples/cells_f90" ] || skip "gfortran is not here"
    judge "$examples/cells_f90" --only "$cells,field/aligned,field/walls"
}

@test "cells.py, without walls too, and nodes.py at contacts" {
    find_python subprocess
    judge "$python $tree/verification/examples/cells.py" --only "$cells,periodic/wave,field/oblique"
    judge "$python $tree/verification/examples/nodes.py" --only 'contact/rod,contact/plane,contact/steady'
}

@test "rod.py, the code of README" {
    find_python subprocess
    judge "$python $tree/verification/examples/rod.py" --quick --only 'smooth/*,walls/*,jump/*'
}

@test "cells.m" {
    needs octave-cli
    judge "octave-cli -q -f $tree/verification/examples/cells.m" --only "$cells"
}

@test "cells.awk" { judge "awk -f $tree/verification/examples/cells.awk" --only "$cells"; }

@test "triangles.py at round walls, solid.py as a thin box, lines.py" {
    find_python scipy
    judge "$python $tree/verification/examples/triangles.py" --only 'round/c*'
    judge "$python $tree/verification/examples/solid.py" --only 'plane/source,contact/rod'
    judge "$python $tree/verification/examples/lines.py" --only 'smooth/gauss,contact/rod,nonlinear/smooth'
}

@test "cvode.c" {
    [ -x "$examples/cvode" ] || skip "SUNDIALS is not here (make setup-peers)"
    judge "$examples/cvode" --only 'smooth/gauss,contact/rod,walls/cooled,plane/source,driven/rod,nonlinear/*'
}

@test "make codes and setup-peers refuse a code that scripts/peers.txt does not have" {
    needs python3
    expect 1 'cubes: not in scripts/peers.txt, which has c fortran' python3 "$tree/scripts/codes" "$program" build out cubes
    expect 2 "'cubes' is none of: awk .* voro" "$tree/scripts/setup-peers" cubes
}

@test "setup-peers states sizes first, and goes on where a code cannot be installed" {
    mkdir -p copy/scripts
    cp "$tree/scripts/setup-peers" "$tree/scripts/interpreter" copy/scripts
    printf '%s\n' 'bad | Bad | no-such | false | - | -' "good | Good | few | test -e $PWD/few | - | -" >copy/scripts/peers.txt
    stand_in sudo 'exec "$@"'
    # shellcheck disable=SC2016 # of the stand-in
    stand_in apt-get 'case $* in *no-such*) exit 100 ;; *assume-no*few) echo "Need to get 5 kB of archives." ;; *few) >few ;; esac'
    sed -i "2i cd '$PWD'" bin/apt-get
    expect 0 '^setup-peers: good: few: 5 kB to load$' copy/scripts/setup-peers
    [[ $output == *'bad: no-such: no such package here'*' to load'*'bad (no-such) could not be installed; going on'* ]]
    [[ $output == *$'left out of make codes:\nbad no-such' ]]
    expect 0 'all are here' copy/scripts/setup-peers good
}

@test "setup-peers puts a package of PyPI into a virtual environment of its own, without apt-get and root" {
    mkdir -p copy/scripts
    cp "$tree/scripts/setup-peers" "$tree/scripts/interpreter" copy/scripts
    printf '%s\n' 'bad | Bad | pypi:no-such | import no_such | - | -' \
        'good | Good | pypi:few | import few | - | -' >copy/scripts/peers.txt
    local tool
    for tool in apt-get sudo; do stand_in "$tool" "echo $tool >>used; exit 1"; done
    stand_in python "case \$* in
        *' venv '*no*|*no-such) echo 'ERROR: none of that name'; exit 1 ;;
        *' venv '*) mkdir -p build/venv/good/bin && cp '$PWD/bin/python' build/venv/good/bin/python ;;
        *dry-run*few) echo 'Would install few-1.2' ;;
        *few) case \$1:\$0 in -m:*good/bin/python) echo here >build/venv/good/few ;; -c:build/venv/good/*) [ -s build/venv/good/few ] ;; *) exit 1 ;; esac ;;
        *no_such) exit 1 ;;
        esac"
    export PYTHON=$PWD/bin/python
    expect 0 '^setup-peers: good: few of PyPI, in build/venv/good: few-1.2$' copy/scripts/setup-peers
    [[ $output == *'bad: no-such of PyPI, in build/venv/bad: no such package here'*'few-1.2'*'bad (no-such) could not be installed: '*'; going on'* ]]
    [[ $output == *$'left out of make codes:\nbad pypi:no-such' ]]
    [ ! -e used ] && [ ! -e copy/build/venv/bad ]
    expect 0 'all are here' copy/scripts/setup-peers good
    expect 0 '^build/venv/good/bin/python$' env -C copy scripts/interpreter few
}

@test "lint_examples finds a slip in each language" {
    local suffix
    for suffix in awk c cc edp f90 js m R; do echo ')' >"slip.$suffix"; done
    expect 1 slip.awk: "$tree/scripts/lint_examples" "$PWD"
    for suffix in awk c cc edp f90 js m R; do
        grep -q "^lint: .*/slip.$suffix:\|: \*.$suffix not checked" <<<"$output" || { echo "no slip.$suffix"; return 1; }
    done
}
