#!/usr/bin/env bats
# Memory, disk, stack and permissions that run out, and interrupts: a result in full, or a reason and nothing left.
load common

@test "standard output on a full disk is a failure" {
    [ -w /dev/full ] || skip "no /dev/full"
    expect 2 '' sh -c 'heatladder list scenes >/dev/full'
}

@test "a file that does not fit leaves the one before" {
    echo before >field.csv
    expect 2 'field.csv' sh -c 'ulimit -f 1; exec heatladder run square-step ftcs --dx 0.05 --field field.csv'
    [ "$(cat field.csv)" = before ]
    mkdir ledger
    expect 2 'cannot write' sh -c 'ulimit -f 1; exec heatladder report claims --only song/eq34 ledger'
    [ -z "$(ls ledger)" ]
    [ -z "$(find . -name '*part*')" ]
}

@test "a directory that may not be written, a file in it that may" {
    mkdir closed
    touch closed/junit.xml
    chmod 666 closed/junit.xml
    chmod 555 closed
    chmod a+rx "$BATS_RUN_TMPDIR" "$BATS_RUN_TMPDIR"/* "$BATS_TEST_TMPDIR"
    cp "$program" here
    user=
    if [ "$(id -u)" -eq 0 ]; then
        needs setpriv
        user='setpriv --reuid 65534 --clear-groups'
        $user ./here --version || skip "another user cannot reach this folder"
    fi
    expect 0 '' $user ./here verify --only rod-step/so_ssph/midway --junit closed/junit.xml
    grep -q '</testsuite' closed/junit.xml
    expect 2 'Permission denied' $user ./here report claims --only song/eq34 closed/new
}

@test "an interrupt leaves earlier results whole" {
    mkdir out
    echo before >out/claims.md
    for signal in INT TERM; do
        env --default-signal=INT heatladder report claims out >/dev/null 2>&1 &
        sleep 0.5
        kill -$signal $!
        run wait $!
        [ "$(ls out) $(cat out/claims.md)" = 'claims.md before' ]
    done
}

@test "each failing allocation: a full result, or status 3 with a reason and nothing left" {
    run ! grep -q __asan_init "$program"
    [ "$status" -ne 0 ] || skip "the sanitizer has its own allocator"
    ${CC:-cc} -shared -fPIC -o failing.so "$tree/verification/unit/failing_malloc.c" || skip "no shared object"
    mkdir out
    for line in 'run square-step so_ssph --dx 0.1 --stepper matched --h iso --field field.csv' \
        'verify --only rod-step/so_ssph/* --json gates.json --junit junit.xml --page page.html' \
        'run plate ftcs --dx 0.01 --field field.csv' 'limit so_ssph --dim 1'; do
        for at in 0 1 2 3 5 8 12 14 16 20 24 35 60 90 150 300 600; do
            status=0
            (cd out && FAIL_AT=$at LD_PRELOAD=../failing.so OMP_NUM_THREADS=1 "$program" $line) >log 2>&1 || status=$?
            case $status in
            0) [ -z "$(find out -size 0)" ] ;;
            3) grep -q 'out of memory' log && [ -z "$(ls out)" ] ;;
            *) false ;;
            esac || { echo "allocation $at of $line: status $status, left: $(ls out)"; cat log; return 1; }
            rm -f out/*
        done
    done
}
