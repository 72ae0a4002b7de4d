#!/bin/sh
# The step of action.yml: runs the battery on $SOLVER by the static binary beside this file and writes the outputs of
# the step.  Its exit status is that of `heatladder verify`.
set -u
here=$(cd "$(dirname "$0")" && pwd)
heatladder=$here/heatladder
[ -x "$heatladder" ] || heatladder=$(command -v heatladder) || {
    echo "::error::heatladder is neither beside action.yml (make action) nor on the PATH"
    exit 2
}
HEATLADDER=$heatladder
export HEATLADDER

results=${RUNNER_TEMP:-${TMPDIR:-/tmp}}/heatladder
mkdir -p "$results"
set -- --order "${ORDER:-2}" --page "$results/verdict.html" --junit "$results/junit.xml"
[ -z "${ONLY:-}" ] || set -- "$@" --only "$ONLY"
[ -z "${SKIP:-}" ] || set -- "$@" --skip "$SKIP"
[ -z "${JOBS:-}" ] || set -- "$@" --jobs "$JOBS"
status=0
"$heatladder" verify --solver "$SOLVER" "$@" >"$results/verdict.txt" || status=$?
cat "$results/verdict.txt"

case $status in
0) verdict=pass ;;
4) verdict=inconclusive ;;
77) verdict=skipped ;;
*) verdict=fail ;;
esac
{
    echo "verdict=$verdict"
    echo "page=$results/verdict.html"
    echo "junit=$results/junit.xml"
} >>"${GITHUB_OUTPUT:-/dev/null}"
{
    echo "### heatladder: $verdict"
    echo '```'
    cat "$results/verdict.txt"
    echo '```'
} >>"${GITHUB_STEP_SUMMARY:-/dev/null}"
[ "$status" -ne 77 ] || status=0 # every row was skipped: no failure
exit "$status"
