#!/usr/bin/env bash
# check_bless.sh PICTURE_TESTS: where a shot cannot be taken, blessing ends with 1 and names it last; the shots
# before and after it are taken all the same.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cat >"$folder/shots.txt" <<SHOTS
$folder/bless-before.png --window 320x240
$folder/bless-wrong.png --no-such-option
$folder/bless-after.png --window 320x240
SHOTS
output=$("$1" "--shots=$folder/shots.txt" --bless 2>&1)
code=$?
fault() { printf '%s\nIt ended with %s and said:\n%s\n' "$1" $code "$output"; exit 1; }
[ $code -eq 1 ] || fault "A shot failed, so the exit code must be 1."
[ "$(tail -n 1 <<<"$output")" = "failed: bless-wrong" ] || fault "The last line must name the shot that failed, and no other."
for name in before after; do
    [ -s "$folder/bless-$name.png" ] || fault "bless-$name.png must have been written."
done
output=$("$1" "--shots=$folder/shots.txt" --bless bless-before 2>&1)
code=$?
[ $code -eq 0 ] || fault "Where no shot failed, the exit code must be 0."
