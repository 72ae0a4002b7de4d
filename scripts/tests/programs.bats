#!/usr/bin/env bats
# Programs of --solver as their user meets them: judged, kept, side by side, hanging, interrupted.
load common

code='heatladder run rod-gauss ftcs --dx $(sed -n "s/^dx = //p" {case}) --field {out}'

rows() { # words of verify: three rows of five runs
    cat >rows <<'ROWS'
GATE("a/order", QUICK, "order", "ladder rod-gauss mine --dx 1,0.5,0.25,0.125", 1.5, 2.9, 1e-4, "second order")
GATE("b/shared", QUICK, "error", "run rod-gauss mine --dx 0.5", 0, 1e-2, NAN, "a rung of the first row")
GATE("b/again", QUICK, "repeat", "run rod-gauss mine --dx 1", 0, 0, NAN, "the same bits")
ROWS
    heatladder verify --gates rows "$@"
}

@test "a program is refused: no paths, not there, no --solver where one is needed" {
    expect 2 'must contain {case} and {out}' heatladder verify --solver ./mine
    expect 2 'exit status 127' rows --solver './nowhere {case} {out}'
    expect 2 'order needs --solver' heatladder verify --order 2
    expect 2 'No such file' heatladder verify --results nowhere
    expect 2 'jobs needs --solver' heatladder verify --jobs 2
}

@test "a program finds heatladder by its path, also if that was found by PATH" {
    # shellcheck disable=SC2016 # for the program's shell
    expect 77 'path: /.*heatladder' env -u HEATLADDER heatladder verify --only smooth/gauss \
        --solver 'echo "path: $HEATLADDER"; exit 77; : {case} {out}'
}

@test "--quick runs the rods of the battery alone" {
    run heatladder verify --quick --verbose --solver 'exit 77; : {case} {out}'
    grep -q 'smooth/gauss' <<<"$output"
    run ! grep -q 'plane/' <<<"$output"
}

@test "the statuses of a program" {
    expect 3 'exit status 9' heatladder run rod-gauss mine --dx 1 --solver 'exit 9; : {case} {out}'
    expect 77 'not applicable' heatladder verify --only 'smooth/*' --solver 'exit 77; : {case} {out}'
    expect 3 'smooth/clock: fail' heatladder verify --only smooth/clock --solver 'exit 9; : {case} {out}'
    expect 1 'too large\|too small' heatladder verify --only smooth/gauss --seed 0 \
        --solver "sed 's/^k_x = 0.01/k_x = 0.011/; s/kappa=0.01/kappa=0.011/' {case} >{out}.case && '$examples/cells_c' {out}.case {out}"
}

@test "a case that rows share runs once; kept answers are judged again by --results" {
    expect 0 '3 passed' rows --solver "echo >>ran; $code" --keep kept --jobs 2
    [ "$(wc -l <ran)" -eq 5 ]
    for file in case out.csv log status; do [ -e "kept/rod-gauss/0.125/$file" ]; done
    expect 0 '2 passed, 0 failed, 0 inconclusive, 1 skipped' heatladder verify --gates rows --results kept
}

@test "a program that hangs or prints without end is ended at --timeout" {
    expect 3 'not done after 0.5 s' heatladder run rod-gauss mine --dx 1 --timeout 0.5 --solver 'sleep 60; : {case} {out}'
    stand_in "endless$$" 'while :; do echo y; done'
    expect 3 'not done after 0.5 s' heatladder run rod-gauss mine --dx 1 --timeout 0.5 --solver "endless$$ # {case} {out}"
    for _ in $(seq 50); do # the system removes killed processes a little later
        pgrep -x "endless$$" || break
        sleep 0.1
    done
    run ! pgrep -x "endless$$"
    expect 3 'an answer may have 2 GB' heatladder run rod-gauss mine --dx 1 --solver 'truncate -s 8G {out} # {case}'
}

@test "bytes that are no letters make no broken UTF-8, XML or terminal command" {
    printf 'z\351ro \233 \302\233[2J\n' >latin
    run heatladder verify --only smooth/gauss --junit junit.xml --json gates.json --page page.html \
        --solver "cat $PWD/latin; exit 3; : {case} {out}"
    [ "$status" -eq 3 ]
    for file in junit.xml gates.json page.html; do iconv -f UTF-8 -t UTF-8 $file >/dev/null; done
    run ! grep -q "$(printf '\302\233')" <<<"$output"
    needs xmllint
    xmllint --noout junit.xml
}

@test "an interrupt keeps the verdicts so far, and ends the program" {
    run rows --solver "[ ! -e ran ] || kill -TERM \$PPID; $code; echo >>ran; sleep 0.2" --json cut.json --only 'b/*'
    [ "$status" -eq 143 ]
    grep -q '"interrupted": 15' cut.json
    [[ "$output" == *"interrupted: 1 of 2 rows judged"* ]]
    run timeout -s INT 0.2 heatladder verify --json cut.json
    [[ "$output" == *"gates judged"* ]]
    grep -q '"interrupted": 2' cut.json
}

@test "rows that a program declines are counted; --verbose has a line for each; a failing row names its cases" {
    run heatladder verify --only smooth/clock,smooth/gauss --solver 'exit 77 # {case} {out}'
    [[ "$output" == *"2 rows: 0 passed, 0 failed, 0 inconclusive, 2 skipped"* ]]
    run ! grep -q '^1 of 2 ' <<<"$output"
    run heatladder verify --only smooth/clock,smooth/gauss --verbose --solver 'exit 77 # {case} {out}'
    grep -q '^1 of 2 .*skipped: not applicable (exit status 77)' <<<"$output"
    run heatladder verify --only smooth/clock,smooth/gauss --keep kept --solver \
        'case {case} in (*sigma0=1.6*) exit 77;; esac; exit 9 # {out}'
    [[ "$output" == *"smooth           0/1 pass, 1 skipped"* ]]
    [ -e "$(sed -n 's/^  cases: //p' <<<"$output")/0.025/case" ]
}

@test "a FILE of - is standard output, with nothing else; folders that are missing are made" {
    [ "$(heatladder run rod-gauss ftcs --dx 1 --field - 2>/dev/null | head -n 1)" = x,T,exact ]
    for row in json={ csv=i page='<' junit='<'; do # the first letters
        [ "$(heatladder verify --only symmetry/none "--${row%%=*}" - 2>/dev/null | head -c 1)" = "${row#*=}" ]
    done
    expect 2 'standard output takes one file' heatladder verify --only symmetry/none --json - --junit -
    [ ! -e - ]
    expect 0 'gate declared' heatladder verify --only symmetry/none --json a/b/gates.json --page c/d/page.html
    [ -s a/b/gates.json ] && [ -s c/d/page.html ]
    expect 0 '1 case' heatladder case rod-gauss --dx 1 --into e/f/cases
}

@test "a pipe that nobody writes to is refused, not waited for" {
    mkfifo pipe
    expect 2 '' timeout 10 heatladder verify --gates pipe
    expect 2 '' timeout 10 heatladder reference rod-gauss --points pipe --time 1
}

@test "many processes list their cases in one file" {
    printf '%s\n' 1 0.5 0.25 0.2 0.125 0.1 0.0625 0.05 | xargs -P 8 -I {} heatladder case rod-gauss --dx {} --into cases
    [ "$(sort -u cases/cases.txt | wc -l)" -eq 8 ]
}

@test "batch engines run each line of cases.txt once" {
    heatladder case rod-gauss --dx 1,0.5 --into cases
    stand_in mycode 'heatladder run rod-gauss ftcs --dx "$(sed -n "s/^dx = //p" "$1")" --field "$2"'
    ln -s bin/mycode .
    for task in 1 2; do SLURM_ARRAY_TASK_ID=$task sh "$tree/scripts/cluster/array.sh"; done
    expect 4 'slope' heatladder ladder rod-gauss mine --results cases --dx 1,0.5
}

@test "a row of another order, a code of another order, words in one argument" {
    expect 2 'is a row of --order 2' heatladder verify --solver 'true {case} {out}' --order 4 --only walls/cooled
    expect 1 'converge with order 2: --order 2' heatladder verify --solver "$examples/cells_c {case} {out}" --order 4 \
        --only 'walls/insulated,smooth/gauss'
    expect 2 'split it at blanks' heatladder reference "rod-cooling --at 0.1 --time 1"
}

action() { # inputs of the action as NAME=VALUE...
    mkdir -p action
    cp "$tree/scripts/action/verify.sh" action/
    ln -sf "$program" action/heatladder
    env GITHUB_OUTPUT=outputs RUNNER_TEMP="$PWD" "$@" action/verify.sh
}

@test "the GitHub Action: outputs, a verdict, an annotation" {
    expect 0 '1 row: 1 passed' action ONLY=walls/insulated SOLVER="$examples/cells_c {case} {out}"
    grep -qx verdict=pass outputs
    expect 3 '' action ONLY=walls/insulated SOLVER='false {case} {out}'
    grep -qx verdict=fail outputs
    GITHUB_ACTIONS=true expect 3 '^::error title=smooth/clock' heatladder verify --only smooth/clock \
        --solver 'exit 9; : {case} {out}'
}

@test "the Python package" {
    python=$(PATH=/usr/bin:$PATH "$tree/scripts/interpreter" pytest)
    [ -n "$python" ] || skip "pytest is not here"
    HEATLADDER=$program PYTHONPATH=$tree/scripts/python PYTHONDONTWRITEBYTECODE=1 \
        "$python" -m pytest -q -p no:cacheprovider "$tree/scripts/python/tests"
}
