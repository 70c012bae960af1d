#!/usr/bin/env bash
# Adds a number to the light as CONTRIBUTING.md says, in one place of a scratch copy, and looks for it in the text and the
# JSON of a command, in the panel, and as a fact of a lesson.
#   check_new_number.sh ROOT BUILD      BUILD is a build folder of ROOT, made by ninja
set -u
root=$(cd "${1:?ROOT is missing}" && pwd)
build=$(cd "${2:?BUILD is missing}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$1"; exit 1; }

# The lines of the example, after the cosine is added.
sed -n '/^    const FormulaInput cosine/,/section/p' "$root/CONTRIBUTING.md" >"$work/example"
[ "$(wc -l <"$work/example")" -eq 4 ] || fail "CONTRIBUTING.md has no example of four lines."
sed "/^    add_cosine(/r $work/example" "$root/src/explain/light_formulas.cpp" >"$work/light_formulas.cpp"
cmp -s "$work/light_formulas.cpp" "$root/src/explain/light_formulas.cpp" && fail "The example has no place."

# Compiled with the build's own options; of a function that is there twice, GNU ld takes the first.
options=$(ninja -C "$build" -t commands rasterwalk | grep -oE -- ' -(D|I|isystem |std=|ffp-)[^ ]+' | grep -v '"' |
    awk '!seen[$0]++' | tr '\n' ' ')
cd "$build" || exit 1
c++ $options -c "$work/light_formulas.cpp" -o "$work/light.o" || fail "It does not compile."
for program in rasterwalk rasterwalk-offscreen; do
    link=$(ninja -t commands $program | tail -1 | grep -oE -- '[^ ]*CMakeFiles/.*')
    link=${link%% && *}
    c++ "$work/light.o" ${link/-o $program/-o $work/$program} -Wl,--allow-multiple-definition || fail "$program is not linked."
done

export RASTERWALK_LESSONS=$root/lessons
"$work/rasterwalk" pixel 240,300 --formulas >"$work/text"
grep -qF "  half = cosine / 2 + 1/2 = " "$work/text" || fail "The command does not print it."
"$work/rasterwalk" pixel 240,300 --formulas --json >"$work/json"
grep -qF '"id" : "pixel_light.half"' "$work/json" || fail "The JSON does not have it."
"$work/rasterwalk-offscreen" -o "$work/shot.png" --tab fragment --pixel 240,300 --report-widgets "$work/widgets" >/dev/null
grep -qF "fragment.pixel_light.half" "$work/widgets" || fail "The panel does not show it."
# The check plays the task's recipe: it is solved only if the fact has its value.
cat >"$work/new-number.md" <<'LESSON'
<!-- lesson
title = "A new number"
section = "Light"
minutes = 1
about = "Light that is never dark."
program = "nothing"
scene = "scenes/lab-room.toml"
set = ["stage=pixel_light"]
-->
# A new number

<!-- step
pixel = "240,300"
tab = "fragment"
-->

One step.

<!-- task
id = "bright"
done = "abs(pixel.pixel_light.half - pixel.cosine / 2 - 0.5) < 0.0001 and camera.focal_length > 600"
recipe = ["set:camera.focal_length=700"]
hint = "Move closer."
because = "It is {pixel.pixel_light.half:2} there."
-->
> Pick a bright pixel.
LESSON
"$work/rasterwalk" check "$work/new-number.md" || fail "A lesson cannot ask for it."
[[ $("$build/rasterwalk" check "$work/new-number.md" 2>&1) == *"'pixel.pixel_light.half' has no value"* ]] ||
    fail "A lesson can ask for it before it is there."
echo "It is in the command's text and JSON, in the panel and among the facts."
