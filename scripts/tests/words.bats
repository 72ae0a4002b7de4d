#!/usr/bin/env bats
# Each verb and each kind of refusal: status, words and keys.  Numbers are the business of gates and unit tests.
load common

@test "help, version, topics" {
    expect 0 '^heatladder [0-9.]*' heatladder --version
    expect 0 '^  heatladder ladder' heatladder --help
    expect 0 '^  --dx DX' heatladder run --help
    expect 0 '^rod-gauss:' heatladder list scenes
    expect 0 '^so_ssph' heatladder list methods
    expect 0 '^smooth/clock ' heatladder list battery
    expect 2 'heatladder' heatladder
}

@test "a misspelt word is refused with the nearest one" {
    expect 2 "did you mean 'verify'" heatladder verfy
    expect 2 "did you mean 'cubic'" heatladder run rod-step so_ssph --dx 0.1 --kernel cubci
    expect 2 'rod-stp' heatladder run rod-stp ftcs --dx 0.1
    expect 2 'unknown option' heatladder run rod-step ftcs --dx 0.1 --nothing
    expect 2 "needs a value" heatladder run rod-step ftcs --dx
}

@test "numbers and options that do not fit are refused" {
    expect 2 'must be' heatladder run rod-step ftcs --dx 0,1
    expect 2 'does not divide' heatladder case rod-step --dx 0.5,0.3 --into cases
    [ ! -e cases ]
    expect 2 '--fourier' heatladder run rod-step ftcs --dx 0.1 --dt 1 --fourier 0.1
    expect 2 'no meaning' heatladder run rod-step ftcs --dx 0.1 --kernel cubic
    expect 2 'GB' heatladder run square-step so_ssph --layout jitter --jitter 0.1 --dx 4/20000 --memory 1
}

@test "control characters reach neither the terminal nor a file" {
    run heatladder run "$(printf 'a\302\233\033[2Jb')" ftcs --dx 1
    [ "$status" -eq 2 ]
    ! LC_ALL=C grep -q "$(printf '\302\233\|\033')" <<<"$output"
}

@test "run" {
    expect 0 '^  error' heatladder run rod-gauss ftcs --dx 0.5 --field field.csv
    [ "$(sed -n '/^x/p' field.csv | cut -d , -f 1-2)" = x,T ]
    heatladder run rod-gauss so_ssph --dx 0.5 --json run.json
    keys run.json scene method dx dt steps particles error_l1 error_linf reference_error seconds
    expect 0 'heat ' heatladder run rod-step so_ssph --dx 0.1 --quantity heat
    expect 3 'unstable' heatladder run rod-step ftcs --dx 0.1 --stepper euler --fourier 2
    expect 2 'exceeds the end time' heatladder run rod-step ftcs --dx 0.1 --dt 50
}

@test "ladder: a verdict and its status" {
    local ladder='ladder rod-gauss ftcs --dx 2,1,0.5,0.25'
    expect 0 'pass' heatladder $ladder --expect 1.5,2.5 --ceiling 1
    expect 1 'fail' heatladder $ladder --expect 3,4
    expect 4 'inconclusive' heatladder ladder rod-gauss ftcs --dx 2,1 --expect 1.5,2.5
    expect 2 'at least two rungs' heatladder ladder rod-gauss mine --dx 1 --solver 'cp {case} {out}'
    heatladder $ladder --json ladder.json
    keys ladder.json slope rungs error_l1 verdict
    heatladder $ladder --expect 3,4 --junit ladder.xml --page page.html || true
    grep -q 'failures="1" errors="0"' ladder.xml
    grep -q '</html>' page.html
    run ! grep -wq 'nan\|inf' ladder.xml
}

@test "verify: rows, a choice, a file of rows" {
    expect 0 'declared, .* 0 failed' heatladder verify --only 'rod-step/*' --json gates.json --junit junit.xml
    keys gates.json id command expected measured verdict why seconds declared executed
    expect 2 'no gate' heatladder verify --only nothing
    echo 'GATE("mine", QUICK, "error", "run rod-gauss ftcs --dx 0.5", 0, 1e-9, NAN, "too small")' >rows
    expect 1 'verify --only mine --gates' heatladder verify --gates rows
    expect 2 'UTF-8' heatladder verify --gates <(printf 'GATE("\233", QUICK, "error", "run", 0, 1, NAN, "w")\n')
}

@test "limit" {
    expect 0 'measured' heatladder limit ftcs --dim 1
    heatladder limit so_ssph --dim 1 --json - 2>/dev/null >limit.json
    keys limit.json von_neumann measured
    expect 2 'steps' heatladder limit so_ssph --dim 1 --stepper exact
}

measured=('run rod-gauss so_ssph --dx 0.5' 'ladder rod-gauss ftcs --dx 2,1,0.5,0.25' 'limit so_ssph --dim 1'
    'bench --brief --scene rod-step' 'verify --only symmetry/*')

@test "jq reads every verb" {
    needs jq
    for line in "${measured[@]}" 'reference rod-gauss --at 0.25 --time 1' 'report claims --only pamplona/mass' \
        list 'list scenes' 'list methods' 'list kernels' 'list steppers' 'list gates' 'list battery' 'list claims' \
        'case rod-gauss --dx 1,0.5 --into cases' 'case --battery --into battery'; do
        echo "$line"
        # shellcheck disable=SC2086 # words
        (set -f; heatladder $line --json - 2>text | jq -e 'length > 0')
        [ -s text ]
    done
    [ "$(heatladder list battery --json - 2>text | jq '.battery | map(select(.order == 2)) | length')" -gt 60 ]
    [ "$(heatladder verify --only 'melt/cell*,symmetry/*' --json - 2>text |
        jq '.gates[] | select(.measure == "error") | .ceiling == .tolerance' | sort -u)" = true ]
    [ "$(heatladder list scenes --json - 2>text | jq -r ".scenes[].name")" = \
        "$(heatladder list scenes | sed -n 's/^\([a-z-]*\): .*/\1/p')" ]
}

@test "--csv: one header line, rows as long, the numbers of --json" {
    for line in "${measured[@]}"; do
        echo "$line"
        # shellcheck disable=SC2086 # words
        (set -f; heatladder $line --csv - 2>text >table.csv)
        [ -s text ]
        # Commas within quotes are taken out first.
        awk '{ while (match($0, /"[^"]*"/)) $0 = substr($0, 1, RSTART - 1) substr($0, RSTART + RLENGTH) }
             { if (NR > 1 && gsub(/,/, "") != commas) exit bad = 1; else if (NR == 1) commas = gsub(/,/, "") }
             END { exit bad || NR < 2 || commas < 10 }' table.csv
    done
    heatladder run rod-gauss so_ssph --dx 0.5 --csv a/run.csv --json run.json
    [ "$(head -n 1 a/run.csv | tr , '\n' | grep -c '^dx \[m\]$\|^error_linf \[K\]$')" -eq 2 ]
    error=$(sed -n 's/^ *"error_l1": \(.*\),$/\1/p' run.json)
    grep -q ",$error," a/run.csv
    expect 2 'standard output takes one file' heatladder run rod-gauss so_ssph --dx 0.5 --csv - --json -
    expect 2 'choose another name' heatladder verify --only 'symmetry/*' --page v.html --csv v.csv
}

@test "reference: points, times, threads" {
    expect 0 'time,' heatladder reference rod-gauss --at 0.25 --time 0:1.5:4
    awk 'BEGIN { print "x,y"; for (i = 0; i < 20000; i++) printf "%.4f,%.4f\n", i % 101 / 1e3, i % 71 / 1e3 }' >points
    for threads in 1 3; do
        OMP_NUM_THREADS=$threads heatladder reference plate --points points --time 1 --what temperature,k_x >answer$threads
    done
    [ "$(grep -c , answer1)" -eq 20001 ]
    cmp answer1 answer3
    expect 2 'NUL' timeout 20 heatladder reference plate --time 1 --points /dev/zero
    expect 2 'outside' heatladder reference plate --time 1 --at 7,7
}

@test "case and --results" {
    expect 0 '3 cases' heatladder case rod-gauss --dx 1,0.5,0.25 --into cases
    [ "$(wc -l <cases/cases.txt)" -eq 3 ]
    grep -q '^oracle = ' cases/rod-gauss/0.5/case
    for case in $(cat cases/cases.txt); do
        heatladder run rod-gauss ftcs --dx "${case##*/}" --field "${case#"$PWD"/}/out.csv" >/dev/null
    done
    expect 4 'slope of E1: 1.93' heatladder ladder rod-gauss mine --results cases --dx 1,0.5,0.25
}

@test "report" {
    expect 0 '' heatladder report song out
    [ -s out/song_table1.md ]
    expect 2 "did you mean 'song'" heatladder report sonng
    expect 2 "unknown study 'bogus'" heatladder report bogus
    [ ! -e bogus ]
    expect 0 '^1 statement of the papers: 0 reproduced, 1 with a condition' heatladder report claims --only pamplona/mass
}

@test "the same bits for any threads and any width of vectors" {
    for line in 'run square-step so_ssph --dx 0.05 --stepper rkl2 --domain whole' 'run plate ftcs --dx 0.002' \
        'run square-step fatehi_manzari --layout jitter --jitter 0.2 --dx 0.1' 'run disc-mode so_ssph --dx 0.05 --seed 1' \
        'run rod-contact contact_ssph --dx 0.01 --stepper chebyshev --dt 1'; do
        heatladder $line --field once >/dev/null
        heatladder $line --field again --threads 3 >/dev/null
        cmp once again
        for lanes in 2 4 8; do
            HEATLADDER_LANES=$lanes heatladder list scenes >/dev/null 2>&1 || continue
            HEATLADDER_LANES=$lanes heatladder $line --field again >/dev/null
            cmp once again
        done
    done
}

@test "manual page has every verb and option" {
    "$tree/scripts/manual" "$(command -v heatladder)" >page.1
    for verb in $(heatladder --help | sed -n 's/^  heatladder \([a-z]*\) .*/\1/p'); do
        for option in $(heatladder "$verb" --help | sed -n 's/^  *\(--[a-z-]*\).*/\1/p'); do
            sed 's/\\-/-/g' page.1 | grep -q -e "fB$option" || { echo "manual: $verb $option"; return 1; }
        done
    done
    needs mandoc
    mandoc -T lint page.1
}

@test "completion of verbs, scenes, options and values" {
    source "$tree/scripts/completion.bash"
    for row in 'heatladder lad=ladder' 'heatladder ladder rod-g=rod-gauss' 'heatladder verify --qui=--quick' \
        'heatladder run rod-gauss so_ssph --kernel wend=wendland' 'heatladder limit so_s=so_ssph'; do
        read -ra COMP_WORDS <<<"${row%=*}"
        COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
        _heatladder
        [ "${COMPREPLY[*]}" = "${row#*=}" ] || { echo "$row: ${COMPREPLY[*]}"; return 1; }
    done
}

@test "one version everywhere, and JSON, XML and HTML as others read them" {
    version=$(heatladder --version | cut -d ' ' -f 2)
    grep -qx "version: $version" "$tree/CITATION.cff"
    grep -m 1 '^## ' "$tree/CHANGELOG.md" | grep -q "^## $version,"
    grep -qx "__version__ = \"$version\"" "$tree/scripts/python/heatladder/__init__.py"
    heatladder verify --only 'rod-step/*' --json gates.json --junit junit.xml --page page.html >/dev/null
    needs jq
    jq -e .gates gates.json >/dev/null
    needs xmllint
    xmllint --noout junit.xml
    needs tidy
    tidy -e -q --custom-tags yes --drop-empty-elements no page.html
}
