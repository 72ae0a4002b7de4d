#!/usr/bin/env bats
# libheatladder as its users meet it: installed, found by pkg-config, linked, and from Python.
load common

built=$(dirname "$program")

@test "a program finds the installed library by pkg-config, shared and static" {
    needs pkg-config
    env -u CC make -s -C "$tree" BUILD="$built" install PREFIX="$PWD/usr"
    export PKG_CONFIG_PATH=$PWD/usr/lib/pkgconfig:$PKG_CONFIG_PATH LD_LIBRARY_PATH=$PWD/usr/lib
    example=$PWD/usr/share/heatladder/examples/library.c
    # shellcheck disable=SC2046 # words
    ${CC:-cc} -Werror -Wall -o shared "$example" $(pkg-config --cflags --libs heatladder) -lm
    expect 0 '^dx = 0.025 m: 160 particles, largest error 0.0019' ./shared
    rm usr/lib/libheatladder.so*
    # shellcheck disable=SC2046 # words
    ${CC:-cc} -o static "$example" $(pkg-config --cflags --libs --static heatladder)
    expect 0 '^dx = 0.025 m: 160 particles, largest error 0.0019' ./static
}

@test "only hl_ symbols are visible, and nothing ends the process, prints or reads the environment" {
    needs nm
    for symbols in -D -g; do
        nm "$symbols" --defined-only "$built/libheatladder.$([ "$symbols" = -D ] && echo so || echo a)" >names
        awk 'NF == 3 && $3 !~ /^hl_/ { print "visible: " $3; bad = 1 } NF == 3 { all++ } END { exit bad || !all }' names
    done
    nm -D -u "$built/libheatladder.so" >names
    ! grep -w 'getenv\|exit\|_exit\|_Exit\|abort\|printf\|puts\|stdout\|stderr' names
}

@test "the header is C++ too" {
    needs g++
    echo '#include <heatladder.h>' >header.cc
    g++ -Wall -Wextra -Werror -pedantic -fsyntax-only -I "$tree/references/library" header.cc
}

@test "Python calls the library" {
    python=$("$tree/scripts/interpreter" pytest)
    [ -n "$python" ] || skip "pytest is not here (Debian: python3-pytest)"
    "$python" -c 'import numpy' || skip "NumPy is not here (Debian: python3-numpy)"
    HEATLADDER=$program HEATLADDER_LIBRARY=$built/libheatladder.so PYTHONPATH=$tree/scripts/python \
        PYTHONDONTWRITEBYTECODE=1 "$python" -m pytest -q -p no:cacheprovider "$tree/scripts/python/tests/test_library.py"
}
