#!/usr/bin/env bats
# A packager's ways: a path with a blank, a read-only tree, DESTDIR, the tarball, flags that are refused, no gnuplot.
load common

# The tree of the last commit with what has changed since, once, in a path with a blank; built elsewhere.
setup_file() {
    copied="$BATS_FILE_TMPDIR/a tree"
    mkdir "$copied"
    (cd "$tree" && git ls-files -z | xargs -0 tar -cf -) | tar -xf - -C "$copied"
    git -C "$copied" init -q
    git -C "$copied" add -A
    git -C "$copied" -c user.name=a -c user.email=a@b -c commit.gpgsign=false commit -q -m a
    make -C "$copied" -s BUILD="$BATS_FILE_TMPDIR/built" CFLAGS=-O0 all "$BATS_FILE_TMPDIR/built/unit/test_number" >/dev/null
}

copy() { # the rest of the test is there
    copied="$BATS_FILE_TMPDIR/a tree" built=$BATS_FILE_TMPDIR/built
    cd "$copied" || return
}

@test "a tree in a path with a blank, built elsewhere: the tree stays as it was, and nothing is left to do" {
    copy
    [ -z "$(git status --porcelain)" ]
    expect 0 "^heatladder .*($(git describe --always))" "$built/heatladder" --version
    expect 0 '' make -q BUILD="$built" CFLAGS=-O0 all
    expect 0 '  CC    solver' make -n BUILD="$built" CFLAGS=-O1 all
    expect 0 '-DSEEN.* -c .*' make -n BUILD="$BATS_TEST_TMPDIR/no" CPPFLAGS=-DSEEN V=1 all
}

@test "flags under which NaN would not be seen, and folders that make cannot have, are refused" {
    copy
    for flags in 'CFLAGS=-O2 -ffast-math' LDFLAGS=-ffast-math CPPFLAGS=-Ofast 'CC=cc -Ofast'; do
        expect 2 'leave it out' make -n "$flags" all
    done
    for bad in 'two words' . /; do expect 2 "BUILD='$bad'" make -n BUILD="$bad" all; done
}

@test "a read-only tree: unit tests run, and another user installs under DESTDIR and removes it" {
    copy
    needs setpriv
    [ "$(id -u)" -eq 0 ] || skip "only root can become another user"
    other='setpriv --reuid 65534 --regid 65534 --clear-groups'
    chmod a+rx "$BATS_RUN_TMPDIR" "$BATS_RUN_TMPDIR"/* "$BATS_FILE_TMPDIR"
    chmod -R a-w,a+rX . "$built"
    mkdir "$BATS_FILE_TMPDIR/place"
    chown 65534:65534 "$BATS_FILE_TMPDIR/place"
    root="$BATS_FILE_TMPDIR/place/a root"
    (umask 077 && HOME=$BATS_FILE_TMPDIR/place $other make BUILD="$built" PREFIX=/usr DESTDIR="$root" install)
    [ "$(stat -c %a "$root/usr/bin/heatladder" "$root/usr/share/man/man1/heatladder.1" | tr '\n' ' ')" = '755 644 ' ]
    [ -s "$root/usr/share/heatladder/examples/cells.c" ]
    "$root/usr/bin/heatladder" --version
    HOME=$BATS_FILE_TMPDIR/place $other "$built/unit/test_number"
    HOME=$BATS_FILE_TMPDIR/place $other make BUILD="$built" PREFIX=/usr DESTDIR="$root" uninstall
    [ -z "$(find "$root" ! -type d)" ]
    chmod -R u+w . "$built"
}

@test "the tarball has every file and its commit, and builds" {
    copy
    make -s BUILD="$built" dist
    tar -xf "$built"/heatladder-*.tar.gz -C "$BATS_TEST_TMPDIR"
    cd "$BATS_TEST_TMPDIR"/heatladder-*
    [ "$(find . ! -type d | wc -l)" -eq "$(git -C "$copied" ls-files | wc -l)" ]
    expect 0 "VERSION_TEXT \"[0-9.]* ($(git -C "$copied" describe --always))\"" make -n BUILD="$BATS_TEST_TMPDIR/b" V=1 all
    make -s BUILD="$BATS_TEST_TMPDIR/b" CFLAGS=-O0 "$BATS_TEST_TMPDIR/b/references/scene_plate.o"
    make -s BUILD="$BATS_TEST_TMPDIR/b" clean
    [ ! -e "$BATS_TEST_TMPDIR/b" ]
}

@test "without gnuplot a study writes its data and says what is not drawn" {
    mkdir tools
    for folder in /usr/bin /bin; do ln -sf "$folder"/* tools/; done
    rm -f tools/gnuplot*
    PATH=$PWD/tools expect 0 'gnuplot is not here' make -C "$tree" BUILD="$(dirname "$program")" -o "$program" OUT="$PWD/out" report
    [ -s out/song_table1.md ]
}

@test "an interrupt while a figure is drawn leaves the figures from before" {
    needs setsid
    mkdir figures
    echo before >figures/song_fig1b.svg
    touch -t 200001010000 figures/song_fig1b.svg
    touch figures/report.stamp
    stand_in gnuplot 'kill -TERM 0; sleep 9'
    run setsid -w make -s -C "$tree" BUILD="$(dirname "$program")" OUT="$PWD/figures" -o "$program" \
        -o "$PWD/figures/report.stamp" "$PWD/figures/song_fig1b.svg"
    [ "$status" -ne 0 ]
    [ "$(cat figures/song_fig1b.*)" = before ]
}

@test "setup asks each package manager for what is missing" {
    rm bin/heatladder
    for tool in sh env cat sed sort tr printf dirname ln true grep rm; do ln -sf "$(type -P $tool)" bin/; done
    stand_in id 'echo 0'
    for manager in apt-get dnf zypper pacman apk; do
        rm -f bin/cc bin/pkg-config bin/gnuplot bin/bats called
        stand_in $manager "echo \"\$*\" >>'$PWD/called'
            for tool in cc pkg-config gnuplot bats; do ln -sf true '$PWD/bin/'\$tool; done"
        (PATH=$PWD/bin CC='' expect 0 'setup: done' sh "$tree/scripts/setup")
        grep -q 'gnuplot.*bats' called
        rm bin/$manager
    done
    (PATH=$PWD/bin; rm bin/bats; expect 0 'install by hand' sh "$tree/scripts/setup")
}

@test "the static binary needs no library, and the wheel has it" {
    needs readelf
    echo 'int main(void) { return 0; }' | cc -x c -fPIC -c -o tiny.o -
    mkdir -p b/static b/whole
    make -s -C "$tree" BUILD="$PWD/b" OBJECTS="$PWD/tiny.o" static
    run ! grep -q INTERP <(readelf -l b/static/heatladder)
    python=$("$tree/scripts/interpreter" zipfile)
    [ -n "$python" ] || skip "python3 is not here"
    make -s -C "$tree" BUILD="$PWD/b" STATIC="$program" LIB_OBJECTS="$PWD/tiny.o" PYTHON3="$python" -o static wheel
    for file in bin/heatladder lib/libheatladder.so; do "$python" -m zipfile -l b/wheel/dist/*.whl | grep -q "heatladder/$file"; done
}
