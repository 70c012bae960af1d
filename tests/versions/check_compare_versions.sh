#!/usr/bin/env bash
# Shows that compare_versions can fail: compares a version with itself, and with one that is wrong in one place.
#   check_compare_versions.sh BUILD      BUILD holds rasterwalk
set -u
here=$(cd "$(dirname "$0")" && pwd)
build=${1:?BUILD is missing}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

# version NAME COMMANDS: a build folder whose programs call those of BUILD and then carry out COMMANDS, for which the
# output is in the file `answer` and the exit code in $code.
version() {
    mkdir -p "$work/$1"
    cp "$build/CMakeCache.txt" "$work/$1"
    printf '#!/bin/bash\n"%s" "$@" >answer\ncode=$?\n%s\ncat answer\nexit $code\n' "$build/rasterwalk" "$2" >"$work/$1/rasterwalk"
    printf '#!/bin/sh\nexit 0\n' >"$work/$1/rasterwalk-offscreen"
    chmod +x "$work/$1"/rasterwalk*
}
# expect CODE WHAT COMMANDS [OPTION...]: against a version with these COMMANDS the exit code is CODE, and the answer contains WHAT.
number=0
expect() {
    number=$((number + 1))
    version "$number" "$3"
    answer=$("$here/compare_versions" --list "$work/list" "${@:4}" "$work/old" "$work/$number" 2>&1)
    code=$?
    [ $code -eq "$1" ] && [[ $answer == *"$2"* ]] && return
    echo "Expected exit code $1 and '$2', got $code and: $answer"
    failed=1
}

cat >"$work/list" <<'LINES'
rasterwalk stats --scene scenes/fence.toml
rasterwalk rows 10,5 5,10 15,15
rasterwalk render -o out.png --scene scenes/fence.toml
rasterwalk stats --stage nothing
LINES
version old ""

expect 0 "4 invocations: no difference" ""
expect 1 "4 invocations: 1 differ" 'sed -i s/^uncovered/not_covered/ answer'
echo 's/^not_covered/uncovered/' >"$work/allowed.sed"
expect 0 "4 invocations: no difference" 'sed -i s/^uncovered/not_covered/ answer' --allowed "$work/allowed.sed"
expect 2 "There is no" "" --allowed "$work/nothing.sed"
expect 1 "old: Start: (10,5). End: (10,5)." 'sed -i "s/Start: (10,5)/Start: (9,5)/" answer'
expect 1 "new: Start: (10,5). End: (10,5)." 'sed -i "s/End: (5,10)/&/; /Start: (9,6)/d" answer && case "$*" in rows*) sed -i 1p answer ;; esac'
expect 1 "rasterwalk render -o out.png" '[ -e out.png ] && echo >>out.png'
expect 1 "new: <<< exit 7" '[ $code -eq 2 ] && code=7'
expect 1 "new: err: and" '[ $code -eq 2 ] && echo and >&2'

[ $failed -eq 0 ] && echo "Every planted difference was found."
exit $failed
