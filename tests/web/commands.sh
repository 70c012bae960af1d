#!/usr/bin/env bash
# Under Node, the commands of the browser's build say and draw what the native ones do.
#   tests/web/commands.sh COMMANDS_JS NATIVE [HASHES_JS NATIVE_HASHES]
# COMMANDS_JS is build/web/rasterwalk-commands.js. With the other two the hashes of tests/same_bits are compared with
# each other as well. What is different is printed: the command, both exit codes, and the first lines that differ.
set -u
commands=$(realpath "${1:?COMMANDS_JS is missing}")
native=$(realpath "${2:?NATIVE is missing}")
hashes=${3:+$(realpath "$3")}
native_hashes=${4:+$(realpath "$4")}
cd "$(dirname "$0")/../.." || exit 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/home" "$folder/state"
export RASTERWALK_LESSONS=$PWD/lessons HOME=$folder/home XDG_STATE_HOME=$folder/state LC_ALL=C.UTF-8
# Emscripten mistakes Node's own fetch for a browser's; the parsers need more stack than Node gives.
node=(node --no-experimental-fetch --stack-size=4000)
same=0
different=0

# both ARGUMENTS...: runs both, and compares output, messages, exit code and out.png, if one is written.
both() {
    local a b what fault=
    rm -f "$folder"/*.png
    (cd "$folder" && "$native" "$@" >native.out 2>native.err </dev/null); a=$?
    [ ! -e "$folder/out.png" ] || mv "$folder/out.png" "$folder/native.png"
    (cd "$folder" && "${node[@]}" "$commands" "$@" >web.out 2>web.err </dev/null); b=$?
    [ ! -e "$folder/out.png" ] || mv "$folder/out.png" "$folder/web.png"
    [ $a = $b ] || fault="  exit codes: expected $a, saw $b"$'\n'
    for what in out err; do
        cmp -s "$folder/native.$what" "$folder/web.$what" ||
            fault+=$(diff "$folder/native.$what" "$folder/web.$what" | cut -c 1-200 | head -n 6 | sed "s/^/  $what: /")$'\n'
    done
    if [ -e "$folder/native.png" ] || [ -e "$folder/web.png" ]; then
        cmp -s "$folder/native.png" "$folder/web.png" || fault+="  the pictures are different"$'\n'
    fi
    if [ -z "$fault" ]; then
        same=$((same + 1))
        return
    fi
    different=$((different + 1))
    printf 'different: rasterwalk %s\n%s' "$*" "$fault"
}
stages="points edges rows fill depth vertex_light pixel_light"

# ---- All commands, and what they say about themselves
both --help
both --version
for command in render stats rows triangle pixel compare diagnose settings presets bugs lessons check facts engines; do
    both $command --help
done
for command in settings presets bugs lessons facts stats "stats --stage pixel_light" "pixel 250,400 --stage depth" "triangle 7" \
    "rows 10,5 5,10 15,15" "compare --b interpolation=affine"; do
    both $command
    both $command --json
done

# ---- Pictures and counts
for stage in $stages; do
    for view in colour depth triangle overdraw; do both render --stage "$stage" --view "$view" -o out.png; done
    both stats --stage "$stage" --json
    both pixel 250,250 --stage "$stage" --json
done
for file in lessons/scenes/*.toml lessons/models/*.obj; do
    both stats --scene "$PWD/$file" --json
    both render --scene "${file#lessons/}" -o out.png
done
for bug in B1 B9 B20 B33; do
    both render --bug $bug -o out.png
    both stats --bug $bug --json
done
for moment in t12 t12/v1 t12/e2/s14 t12/r37/c5 t20/e1/s7 end; do
    both render --to $moment -o out.png
    both render --to $moment --stage pixel_light --set clipping=near -o out.png
done
for setting in rounding=floor rounding=round line_walk=exact line_walk=multiply interpolation=affine depth_test=linear_z \
    edge_samples=rows light.model=blinn_phong projection=orthographic; do
    both render --stage pixel_light --set $setting -o out.png
    both compare --stage pixel_light --b $setting --json
done
both render --size 640x300 --stage depth -o out.png
both render --set nonsense=1 -o out.png
for triangle in 0 7 20 29; do
    both triangle $triangle --stage pixel_light
    both triangle $triangle --json
done
for pixel in 0,0 100,100 330,310 499,499; do both pixel $pixel --stage pixel_light; done
both rows 0,2 3,1 2,6
both rows 10,5 5,10 15,15 --set rounding=floor
both diagnose "$PWD/tests/golden/room.txt"

# ---- Lessons
both check "$PWD/lessons/"
for lesson in lessons/[0-9]*.md; do
    both check "$PWD/$lesson"
    both stats --lesson "$(basename "$lesson" .md)" --step 1 --json
done
for broken in tests/lessons/broken/*; do both check "$PWD/$broken"; done

# ---- Faults, and possibly malicious input
printf '[camera\nposition = 3' >"$folder/broken.toml"
printf 'v 1 2\nf 1 2 9\nf a b c\n' >"$folder/broken.obj"
printf 'v 0 0 0\nv 1e39 0 1\nv nan 1 inf\nv 1e-46 0x10 1.5.2\nf 1 2 3\nf -1 -2 -3\n' >"$folder/numbers.obj"
head -c 20000 /dev/zero >"$folder/zeros.obj"
: >"$folder/empty.toml"
printf 'no picture' >"$folder/no.png"
mkdir "$folder/a folder"
for file in broken.toml broken.obj numbers.obj zeros.obj empty.toml no.png "a folder" nothing.toml; do
    both stats --scene "$file" --json
    both render --scene "$file" -o out.png
    both diagnose "$file"
    both check "$file"
done
for line in nonsense "stats --stage nonsense" "stats --set rounding=florr" "stats --set camera.yaw=1e400" "stats --set light.power=nan" \
    "stats --set viewport.width=0x10" "stats --set viewport.width=1.5" "stats --set viewport.width=99999999999" "stats --size 0x0" \
    "stats --size 100000x100000" "pixel" "pixel 1" "pixel 9999,1" "pixel 1,b" "triangle" "triangle -1" "triangle 999" "rows 1,1" "rows a,b 1,1 2,2" \
    "rows 0,0 1e9,0 0,1e9" "render" "render -o nowhere/out.png" "render --to t99999" "render --to x1" "compare" "compare --b nonsense" \
    "stats --lesson nonsense" "stats --lesson 05-row-table --step 99" "stats --step 1" "stats --bug B999" "stats --preset nonsense" \
    "--lesson" "stats --json --json" "check nowhere" "diagnose" "facts extra" \
    "engines --workload w4" "engines --size 0x0" "engines --threads 3" "engines --rounds 1"; do
    both $line
done

# ---- The pictures behind the pictures
if [ -n "$hashes" ]; then
    scene=$PWD/lessons/scenes/lab-room.toml
    "$native_hashes" "$scene" >"$folder/native.hashes"
    "${node[@]}" "$hashes" "$scene" >"$folder/web.hashes"
    if [ -s "$folder/native.hashes" ] && cmp -s "$folder/native.hashes" "$folder/web.hashes"; then
        echo "All $(wc -l <"$folder/native.hashes") hashes of pictures are the same."
    else
        different=$((different + 1))
        echo "different: the hashes of pictures"
        diff "$folder/native.hashes" "$folder/web.hashes" | head -n 10
    fi
fi

echo "$same commands say and draw the same, $different do not."
[ $different -eq 0 ]
