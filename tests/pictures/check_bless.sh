#!/usr/bin/env bash
# check_bless.sh PICTURE_TESTS: if a shot cannot be taken, blessing ends with 1 and names it last; the shots before and
# after it are still taken. What a version of Dear ImGui draws differently goes into its own folder.
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

# take CODE WHY ARGUMENTS...: takes the first picture, with a different one of the same name drawn here.
program=$1
take() {
    output=$("$program" "--shots=$folder/shots.txt" "${@:3}" bless-before 2>&1)
    code=$?
    [ $code -eq "$1" ] || fault "$2"
}
cp "$folder/bless-before.png" "$folder/first.png"
sed -i 's/320x240$/320x240 --theme light/' "$folder/shots.txt"
take 1 "The other picture is not the first one." "--others=$folder/others"
take 0 "The other picture can be blessed." "--others=$folder/others" --bless
cmp -s "$folder/bless-before.png" "$folder/first.png" || fault "The first picture must be as it was."
[ -s "$folder/others/bless-before.png" ] || fault "The other picture must have been written."
take 0 "The other picture is as expected where it is drawn." "--others=$folder/others"
take 1 "Elsewhere the first one is expected."
sed -i 's/ --theme light$//' "$folder/shots.txt"
take 0 "The first picture can be blessed again." "--others=$folder/others" --bless
[ ! -e "$folder/others/bless-before.png" ] || fault "The first picture is drawn: the other one must be gone."
