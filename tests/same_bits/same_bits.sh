#!/usr/bin/env bash
# Compiles the drawing core under several compilers, libraries, processors and flags, and compares what they draw, bit by bit.
#   same_bits.sh ROOT FOLDER      FOLDER takes the objects, programs and hashes
# libc++, and a compiler for ARM with qemu-user to run its program, take part where they are installed.
# SAME_BITS_LEVELS=all tests -O2 too. SAME_BITS_FLAGS replaces the flag that keeps the bits; `SAME_BITS_FLAGS=-ffp-contract=fast` shows that the test can fail.
# SAME_BITS_ONLY takes only the variants that this regular expression matches, and the first one to compare with.
# Exit codes: 0 the same bits, 1 other bits, 2 something does not compile or run.
set -u
root=${1:?ROOT is missing}
folder=${2:?FOLDER is missing}
keeps_bits=${SAME_BITS_FLAGS--ffp-contract=off}
cd "$root" || exit 2
mkdir -p "$folder" || exit 2

for compiler in g++ clang++; do
    command -v "$compiler" >/dev/null || { echo "$compiler is not installed."; exit 2; }
done
# A variant is a compiler and its flags: the extremes, levels between them draw like both. The longest come first.
native="-O3 -march=native"
variants=("g++ -O0" "g++ $native" "clang++ -O0" "clang++ $native")
[ "${SAME_BITS_LEVELS:-}" = all ] && variants+=("g++ -O2" "clang++ -O2")
if clang++ -stdlib=libc++ -x c++ -include version -E - </dev/null >/dev/null 2>&1; then
    variants+=("clang++ -stdlib=libc++ $native")
else
    echo "libc++ is not installed: left out."
fi
qemu=$(command -v qemu-aarch64-static || command -v qemu-aarch64 || true)
if command -v aarch64-linux-gnu-g++ >/dev/null && [ -n "$qemu" ]; then
    variants+=("aarch64-linux-gnu-g++ -O3")
else
    echo "aarch64-linux-gnu-g++ or qemu-aarch64 is not installed: left out."
fi
if [ -n "${SAME_BITS_ONLY:-}" ]; then
    mapfile -t others < <(printf '%s\n' "${variants[@]:1}" | grep -E -- "$SAME_BITS_ONLY")
    [ ${#others[@]} -gt 0 ] || { echo "No variant matches '$SAME_BITS_ONLY'."; exit 2; }
    variants=("${variants[0]}" "${others[@]}")
fi

# Everything that draws: all of these folders, in the order of the layers.
folders=(base scene stages mistakes settings pipeline picture)
launcher=$(command -v ccache || true)
# Everything from headers: the system's libraries are compiled for one processor and one standard library.
common="-std=c++20 $keeps_bits -Isrc -DFMT_HEADER_ONLY -DTOML_HEADER_ONLY=1"
common+=" $(pkg-config --cflags-only-I fmt nlohmann_json stb tomlplusplus)" || exit 2

# two_at_a_time: runs the commands of its input, one a line, until one fails.
two_at_a_time() { xargs -P 2 -d '\n' -n 1 bash -c 'eval "$0" || exit 255'; }
# place_of VARIANT: its folder.
place_of() { echo "$folder/${1// /}"; }
# flags_of VARIANT: what it needs besides.
flags_of() {
    case $1 in
    *libc++*) echo "-include ui/hosts/web/missing_library.h" ;;
    aarch64*) echo "-idirafter /usr/include -static" ;;
    esac
}
# sources_of FOLDER...: a source that includes all of these folders: their headers are read once.
sources_of() {
    local name source
    for name; do
        for source in src/"$name"/*.cpp; do
            echo "#include \"$PWD/$source\""
        done
    done
}
# compile: all sources in $folder under all variants.
compile() {
    local i place source
    for ((i = ${#variants[@]} - 1; i >= 0; --i)); do
        place=$(place_of "${variants[i]}")
        mkdir -p "$place" && rm -f "$place"/*.o
        for source in "$folder"/*.cpp; do
            echo "$launcher ${variants[i]} $common $(flags_of "${variants[i]}") -c $source -o $place/$(basename "$source").o"
        done
    done | two_at_a_time
}

rm -f "$folder"/*.cpp
echo "#include \"$PWD/tests/same_bits/hash_pictures.cpp\"" >"$folder/hash_pictures.cpp"
printf '#define STB_IMAGE_WRITE_IMPLEMENTATION\n#include <stb_image_write.h>\n' >"$folder/stb.cpp"
sources_of "${folders[@]}" >"$folder/core.cpp"
if ! compile 2>"$folder/errors"; then
    echo "Names of two folders meet, or the core does not compile: each folder by itself."
    rm "$folder/core.cpp"
    for name in "${folders[@]}"; do sources_of "$name" >"$folder/$name.cpp"; done
    compile || { echo "The core does not compile."; exit 2; }
fi

for variant in "${variants[@]}"; do
    place=$(place_of "$variant")
    run=
    [ "${variant#aarch64}" = "$variant" ] || run=$qemu
    echo "$variant $(flags_of "$variant") $place/*.o -o $place/hash_pictures &&" \
        "$run $place/hash_pictures lessons/scenes/lab-room.toml >$place/hashes"
done | two_at_a_time || { echo "The core does not draw."; exit 2; }

reference=$(place_of "${variants[0]}")/hashes
different=0
printf '%-40s %-34s\n' variant "hash of all pictures"
for variant in "${variants[@]}"; do
    hashes=$(place_of "$variant")/hashes
    printf '%-40s %-34s' "$variant" "$(md5sum <"$hashes" | cut -d ' ' -f 1)"
    if cmp -s "$reference" "$hashes"; then
        echo
        continue
    fi
    different=1
    count=$(diff "$reference" "$hashes" | grep -c '^>')
    first=$(diff "$reference" "$hashes" | sed -n 's/^> //p' | head -n 1 | awk '{ print $1, $2, $3 }')
    echo "differs in $count pictures; the first: $first"
done
pictures=$(wc -l <"$reference")
if [ "$pictures" -lt 100 ]; then
    echo "Only $pictures pictures were drawn."
    exit 2
fi
if [ $different -ne 0 ]; then
    echo "The pictures are not the same bits in all variants."
    exit 1
fi
echo "$pictures pictures, the same bits in all."
