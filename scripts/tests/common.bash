# Loaded by each file of tests.  $PROGRAM is the program under test, $EXAMPLES has the compiled examples.
bats_require_minimum_version 1.5.0
tree=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)
program=$(realpath "${PROGRAM:-$tree/build/heatladder}")
examples=$(realpath "${EXAMPLES:-$tree/build/examples}")
unset MAKEFLAGS MAKELEVEL MFLAGS CPPFLAGS CFLAGS LDFLAGS LDLIBS BUILD PREFIX DESTDIR WERROR GITHUB_ACTIONS

setup() {
    cd "$BATS_TEST_TMPDIR" || return
    mkdir bin
    ln -s "$program" bin/heatladder
    PATH=$PWD/bin:$PATH
}

# `expect STATUS PATTERN COMMAND...`: the command ends so, and a line that it prints matches.
expect() {
    local status_due=$1 pattern=$2
    shift 2
    run "$@"
    echo "$output"
    [ "$status" -eq "$status_due" ] || { echo "exit status $status, due: $status_due"; return 1; }
    grep -qe "$pattern" <<<"$output" || { echo "no line matches: $pattern"; return 1; }
}

judge() { # command of a program, which takes {case} {out} unless it has them, words of verify: its rows hold
    local command=$1
    [[ $command == *{case}* ]] || command+=' {case} {out}'
    shift
    export HEATLADDER=$program PYTHONPATH=$tree/scripts/python PYTHONDONTWRITEBYTECODE=1
    expect 0 ' 0 failed, 0 inconclusive' heatladder verify --solver "$command" "$@"
}

# `stand_in NAME SCRIPT`: a command of that name, for this test alone.
stand_in() {
    printf '#!/bin/sh\n%s\n' "$2" >"bin/$1"
    chmod +x "bin/$1"
}

needs() { # command: else the test is skipped
    command -v "$1" >/dev/null || skip "$1 is not here"
}

keys() { # file of JSON, keys that it must have, one an argument
    local file=$1 key
    shift
    for key; do grep -q "^ *\"$key\": " "$file" || { echo "$file has no $key"; return 1; }; done
}
