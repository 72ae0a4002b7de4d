# shellcheck shell=sh disable=SC2034
# For the scripts that count what holds, to be sourced: PROGRAM (build/heatladder) as $program, but where that is empty
# since they try no program; a folder for what they write, gone at the end; $show, head or tail of the log of what does
# not hold.  What cannot be tried here is skipped by name.
cd "$(dirname "$0")/.." || exit 1
name=${0##*/}
program=${program-${PROGRAM:-build/heatladder}} show=${show:-head}
case $program in '' | /*) ;; *) program=$PWD/$program ;; esac
[ -z "$program" ] || [ -x "$program" ] || { echo "$name: $program is not built" >&2; exit 1; }
scratch=$(mktemp -d "${TMPDIR:-/tmp}/heatladder-check.XXXXXX") || exit 1
trap 'chmod -R u+w "$scratch"; rm -rf "$scratch"' EXIT
trap 'exit 130' INT TERM HUP
: >"$scratch/log"
passed=0 failed=0

verdict() { # what holds? (0: yes) what
    if [ "$1" -eq 0 ]; then passed=$((passed + 1)); else
        failed=$((failed + 1))
        echo "$name: $2"
        "$show" -n 5 "$scratch/log"
    fi
}

holds() { # what, words of a command that ends well where it does
    what=$1
    shift
    "$@"
    verdict $? "$what"
}

empty() { # what is wrong, the names that it is of
    [ -z "$2" ]
    verdict $? "$1:$2"
}

gives() { # status, pattern of the output (both streams), what holds, words of a command...
    due=$1 pattern=$2 what=$3
    shift 3
    "$@" >"$scratch/log" 2>&1
    got=$?
    [ "$got" -eq "$due" ] && grep -qe "$pattern" "$scratch/log"
    verdict $? "$what: exit status $got, $due is due, with '$pattern'"
}

expect() { # status, pattern of the output, words of the program's command line...
    due=$1 pattern=$2
    shift 2
    gives "$due" "$pattern" "'$*'" "$program" "$@"
}

# For awk: the unit of the last digit that is printed.
LAST='function last(text,    e, mantissa) {
    e = index(text, "e") ? substr(text, index(text, "e") + 1) : 0
    mantissa = index(text, "e") ? substr(text, 1, index(text, "e") - 1) : text
    return 10 ^ (e - (index(mantissa, ".") ? length(mantissa) - index(mantissa, ".") : 0))
}'

stand_in() { # path, or a name in $scratch/bin; the lines of a script that it is to be
    case $1 in */*) path=$1 ;; *) path=$scratch/bin/$1 ;; esac
    rm -f "$path"
    printf '#!/bin/sh\n%s\n' "$2" >"$path"
    chmod +x "$path"
}

limited() { # option of ulimit, its value, words of a command...
    (ulimit "$1" "$2" && shift 2 && exec "$@")
}

has() { # command, what cannot be tried without it
    command -v "$1" >/dev/null && return
    skip "$2: $1 is not here"
    false
}

skip() { # what, and why
    echo "$name: skipped: $1"
    echo "$1" >>"$scratch/skipped"
}

finish() { # with CI_STRICT=1 what was skipped is a failure; run_tests, which counts for all, leaves that to itself
    skipped=$(cat "$scratch/skipped" 2>/dev/null | wc -l)
    [ "$skipped" -eq 0 ] || echo "$name: $((skipped)) skipped"
    echo "$name: $passed passed, $failed failed"
    [ "$failed" -eq 0 ] && { [ "$skipped" -eq 0 ] || [ "${CI_STRICT:-}" != 1 ]; }
}
