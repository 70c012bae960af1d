#!/usr/bin/env bash
# Compiles the drawing core under several compilers and flags and compares what they draw, bit by bit.
#   same_bits.sh ROOT FOLDER      FOLDER takes the objects, programs and hashes
# SAME_BITS_LEVELS=all tests -O2 too. SAME_BITS_FLAGS replaces the flag that keeps the bits; `SAME_BITS_FLAGS=-ffp-contract=fast` shows that the test can fail.
set -u
root=${1:?ROOT is missing}
folder=${2:?FOLDER is missing}
keeps_bits=${SAME_BITS_FLAGS--ffp-contract=off}
compilers=(g++ clang++)
levels=("-O0" "-O3 -march=native") # the extremes: levels between them draw like both
[ "${SAME_BITS_LEVELS:-}" = all ] && levels=("-O0" "-O2" "-O3 -march=native")
cd "$root" || exit 2
mkdir -p "$folder" || exit 2

# Everything that draws: all of these folders, in the order of the layers.
folders=(base scene stages mistakes settings pipeline picture)
launcher=$(command -v ccache || true)
# The packages of the core; unused parts of them cost nothing.
packages=(fmt nlohmann_json stb tomlplusplus)
libraries="-Wl,--as-needed $(pkg-config --libs "${packages[@]}")" || exit 2
common="-std=c++20 $keeps_bits -Isrc $(pkg-config --cflags "${packages[@]}")"

for compiler in "${compilers[@]}"; do
    command -v "$compiler" >/dev/null || { echo "$compiler is not installed."; exit 2; }
done

# two_at_a_time: runs the commands of its input, one a line, until one fails.
two_at_a_time() { xargs -P 2 -d '\n' -n 1 bash -c 'eval "$0" || exit 255'; }
# sources_of FOLDER...: a source that includes all of these folders: their headers are read once.
sources_of() {
    local name source
    for name; do
        for source in src/"$name"/*.cpp; do
            echo "#include \"$PWD/$source\""
        done
    done
}
# compile: all sources in $folder under all variants; the longest come first.
compile() {
    local i compiler source variant
    for ((i = ${#levels[@]} - 1; i >= 0; --i)); do
        for compiler in "${compilers[@]}"; do
            variant=$folder/$compiler${levels[i]// /}
            mkdir -p "$variant" && rm -f "$variant"/*.o
            for source in "$folder"/*.cpp; do
                echo "$launcher $compiler $common ${levels[i]} -c $source -o $variant/$(basename "$source").o"
            done
        done
    done | two_at_a_time
}

rm -f "$folder"/*.cpp
echo "#include \"$PWD/tests/same_bits/hash_pictures.cpp\"" >"$folder/hash_pictures.cpp"
sources_of "${folders[@]}" >"$folder/core.cpp"
if ! compile 2>"$folder/errors"; then
    echo "Names of two folders meet, or the core does not compile: each folder by itself."
    rm "$folder/core.cpp"
    for name in "${folders[@]}"; do sources_of "$name" >"$folder/$name.cpp"; done
    compile || { echo "The core does not compile."; exit 2; }
fi

for level in "${levels[@]}"; do
    for compiler in "${compilers[@]}"; do
        variant=$folder/$compiler${level// /}
        echo "$compiler $variant/*.o $libraries -o $variant/hash_pictures &&" \
            "$variant/hash_pictures lessons/scenes/lab-room.toml >$variant/hashes"
    done
done | two_at_a_time || { echo "The core does not draw."; exit 2; }

reference=
different=0
printf '%-10s %-20s %-34s\n' compiler flags "hash of all pictures"
for compiler in "${compilers[@]}"; do
    for level in "${levels[@]}"; do
        variant=$folder/$compiler${level// /}
        printf '%-10s %-20s %-34s' "$compiler" "$level" "$(md5sum <"$variant/hashes" | cut -d ' ' -f 1)"
        : "${reference:=$variant/hashes}"
        if cmp -s "$reference" "$variant/hashes"; then
            echo
            continue
        fi
        different=1
        count=$(diff "$reference" "$variant/hashes" | grep -c '^>')
        first=$(diff "$reference" "$variant/hashes" | sed -n 's/^> //p' | head -n 1 | awk '{ print $1, $2, $3 }')
        echo "differs in $count pictures; the first: $first"
    done
done
pictures=$(wc -l <"$reference")
if [ "$pictures" -lt 100 ]; then
    echo "Only $pictures pictures were drawn."
    exit 2
fi
if [ $different -ne 0 ]; then
    echo "The pictures are not the same bits under every compiler."
    exit 1
fi
echo "$pictures pictures, the same bits in all."
