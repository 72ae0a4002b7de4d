#!/usr/bin/env bats
# libheatladder as its users meet it: installed, found by pkg-config, linked, and from Python.
load common

built=$(dirname "$program")

installed() { # installs into ./usr, for pkg-config and the loader
    needs pkg-config
    env -u CC make -s -C "$tree" BUILD="$built" install PREFIX="$PWD/usr"
    export PKG_CONFIG_PATH=$PWD/usr/lib/pkgconfig:$PKG_CONFIG_PATH LD_LIBRARY_PATH=$PWD/usr/lib
    example=$PWD/usr/share/heatladder/examples/library
    read -ra flags <<<"$(pkg-config --cflags --libs heatladder)"
}

@test "a program finds the installed library by pkg-config, shared and static" {
    installed
    ${CC:-cc} -Werror -Wall -o shared "$example.c" "${flags[@]}" -lm
    expect 0 '^dx = 0.025 m: 160 particles, largest error 0.0019' ./shared
    rm usr/lib/libheatladder.so*
    # shellcheck disable=SC2046 # words
    ${CC:-cc} -o static "$example.c" $(pkg-config --cflags --libs --static heatladder)
    expect 0 '^dx = 0.025 m: 160 particles, largest error 0.0019' ./static
}

@test "Fortran calls the library: an explicit code verifies itself" {
    needs gfortran
    installed
    gfortran -std=f2008 -Wall -Wextra -Werror -o fortran usr/include/heatladder.f90 "$example.f90" "${flags[@]}"
    expect 0 '^cells: 80, largest error  *8.5E-04 K' ./fortran
    sed -i "s/'kappa'/'kapa'/; s/stop 'no problem'/stop hl_message(why)/" usr/share/heatladder/examples/library.f90
    gfortran -o fortran usr/include/heatladder.f90 "$example.f90" "${flags[@]}"
    expect 0 "did you mean 'kappa'" ./fortran
}

@test "C++ calls the library: start, walls and exact solution of a scene" {
    needs g++
    installed
    cat >plain.cc <<'END'
#include <heatladder.h>
#include <cstdio>
#include <vector>

int main() {
    hl_error why;
    hl_problem *problem = hl_problem_create("wall-composite", nullptr, &why);
    const char *what = "initial_mean,k_x,wall,temperature";
    const std::vector<double> x = {0, 0.55, 1}, dx(3, 0.2);
    hl_points points = {x.size(), x.data(), nullptr, nullptr, dx.data(), nullptr, nullptr};
    std::vector<double> value(points.n * hl_reference_values(problem, what, nullptr, 0, &why));
    if (hl_reference(problem, what, 1, &points, value.data(), &why)) return std::puts(why.text), 1;
    for (size_t i = 0; i < value.size(); i++) std::printf("%g%c", value[i], i % points.n == 2 ? '\n' : ' ');
    hl_problem_free(problem);
}
END
    g++ -std=c++11 -Wall -Wextra -Werror -pedantic -o cxx plain.cc "${flags[@]}"
    ./cxx >cxx.txt
    printf 'x,dx\n0,.2\n.55,.2\n1,.2\n' >points.csv
    heatladder reference wall-composite --points points.csv --time 1 --what initial_mean,k_x,wall,temperature |
        awk -F, 'NR > 1 { for (j = 2; j <= NF; j++) v[j] = v[j] (NR > 2 ? " " : "") sprintf("%g", $j) }
                 END { for (j = 2; j <= NF; j++) print v[j] }' >shell.txt
    cat cxx.txt
    cmp cxx.txt shell.txt
}

@test "messages have a decimal point in a locale of commas" {
    [ -f /usr/share/i18n/locales/de_DE ] || skip "the sources of locales are not here (Debian: locales)"
    localedef -i de_DE -f UTF-8 "$PWD/de_DE.UTF-8"
    installed
    cat >comma.c <<'END'
#include <heatladder.h>
#include <locale.h>
#include <stdio.h>

int main(void) {
    struct hl_error why;
    struct hl_setting settings[] = {{"kappa", -1.5}, {NULL, 0}};
    setlocale(LC_ALL, "de_DE.UTF-8");
    hl_problem_create("rod-step", settings, &why);
    return printf("%.1f|%s\n", 0.5, why.text) < 0;
}
END
    ${CC:-cc} -o comma comma.c "${flags[@]}"
    LOCPATH=$PWD expect 0 '^0,5|--set kappa=-1[.]5: ' ./comma
}

@test "each function of the header is called with bad arguments by the unit test" {
    grep -o 'hl_[a-z_]*(' "$tree/references/library/heatladder.h" | sort -u >names
    [ "$(wc -l <names)" -ge 12 ]
    while read -r name; do grep -qF "$name" "$tree/verification/unit/test_library.c" || { echo "$name"; false; }; done <names
    grep -vF 'hl_exact(' names | grep -v 'hl_parameter\|hl_scene\|hl_method\|hl_version\|hl_exact_at' | while read -r name; do
        grep -qi "$name" "$tree/references/library/heatladder.f90" || { echo "heatladder.f90 lacks $name"; false; }
    done
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

@test "Python calls the library" {
    python=$("$tree/scripts/interpreter" pytest)
    [ -n "$python" ] || skip "pytest is not here (Debian: python3-pytest)"
    "$python" -c 'import numpy' || skip "NumPy is not here (Debian: python3-numpy)"
    HEATLADDER=$program HEATLADDER_LIBRARY=$built/libheatladder.so PYTHONPATH=$tree/scripts/python \
        PYTHONDONTWRITEBYTECODE=1 "$python" -m pytest -q -p no:cacheprovider "$tree/scripts/python/tests/test_library.py"
}

@test "pip installs the package from a checkout" {
    python=$("$tree/scripts/interpreter" ensurepip)
    [ "$built" = "$tree/build" ] && [ -n "$python" ] && "$python" -m venv venv ||
        skip "no build in build/, or no venv (Debian: python3-venv)"
    export PYTHONDONTWRITEBYTECODE=1
    env -u HEATLADDER venv/bin/pip install -q --no-index "$tree/scripts/python"
    env -u HEATLADDER -u HEATLADDER_LIBRARY venv/bin/python -c 'import heatladder; print(len(heatladder.scenes()))' >count
    [ "$(cat count)" -ge 24 ]
}
