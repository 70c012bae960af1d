#!/usr/bin/env bash
# Adds a varying to a copy of stages/varyings.h, puts that copy first on the include path, and checks that the rest of
# the core, unchanged, interpolates it, shows it and compares it. Then leaves out each step of the addition in turn, and
# checks that none of these compiles.
#   add_varying.sh ROOT SCRATCH COMPILER
set -eu
root=${1:?ROOT is missing}
scratch=${2:?SCRATCH is missing}
compiler=${3:-c++}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

rm -rf "$scratch"
mkdir -p "$scratch"/{whole,no_member_pointer,no_entry}/stages
header=$root/src/stages/varyings.h

add_member='s|^    glm::vec3 illumination{0.0f};.*|&\n    glm::vec2 heat{0.0f};|'
add_pointer='s|&Varyings::illumination};|\&Varyings::illumination, \&Varyings::heat};|'
entry='    varying_info("heat", "heat", "kelvin", false, VaryingUse::always,\
                 {{{"heat_in", "heat in", "hi/z", "Heat that arrives."},\
                   {"heat_out", "heat out", "ho/z", "Heat that leaves."}}},\
                 varying_component<\&Varyings::heat>, \&Varyings::heat),'
# The entry goes after the last one, which ends the list.
add_entry='s|^                 varying_component<&Varyings::illumination>, &Varyings::illumination),|&\n'$entry'|'

sed -e "$add_member" -e "$add_pointer" -e "$add_entry" "$header" > "$scratch/whole/stages/varyings.h"
sed -e "$add_member" "$header" > "$scratch/no_member_pointer/stages/varyings.h"
sed -e "$add_member" -e "$add_pointer" "$header" > "$scratch/no_entry/stages/varyings.h"
if [ "$(grep -c heat "$scratch/whole/stages/varyings.h")" -lt 6 ]; then
    echo "varyings.h has changed its form: the varying could not be added" >&2
    exit 1
fi

flags="-std=c++20 -O0 -ffp-contract=off"
# An incomplete addition must say what is missing.
for forgotten in no_member_pointer:varying_members no_entry:varying_list; do
    folder=${forgotten%%:*} word=${forgotten##*:}
    if "$compiler" $flags -fsyntax-only -I "$scratch/$folder" -I "$root/src" -x c++ \
            "$scratch/$folder/stages/varyings.h" 2> "$scratch/$folder/said"; then
        echo "$folder: it compiles, and the new varying would silently be 0" >&2
        exit 1
    fi
    if ! grep -q "missing from $word" "$scratch/$folder/said"; then
        echo "$folder: the compiler does not say what is missing:" >&2
        cat "$scratch/$folder/said" >&2
        exit 1
    fi
done

# The core needs nothing else: every file of these folders unchanged, in one go.
{
    echo "// The core with one varying more."
    for file in "$root"/src/scene/{scene,mesh,tessellation,texture,look_at}.cpp "$root"/src/stages/*.cpp \
            "$root"/src/mistakes/*.cpp "$root"/src/settings/settings.cpp \
            "$root"/src/settings/{choose_stages,stage_functions,setting_table,setting_value,depth_words}.cpp \
            "$root"/src/pipeline/*.cpp "$root"/src/picture/view_image.cpp \
            "$root"/src/picture/colour_map.cpp "$root"/src/inspect/row_history.cpp \
            "$root"/src/inspect/clip_history.cpp "$root"/src/inspect/{carried_row,pixel_tests,row_graph}.cpp \
            "$root"/src/compare/run_walk.cpp; do
        if [ -f "$file" ]; then echo "#include \"$file\""; fi
    done
} > "$scratch/core.cpp"
for source in "$scratch/core.cpp" \
        "$root"/src/base/{element_names,enumerated,files,language,nearest_name,numbers,quoted,text_parts}.cpp \
        "$root/src/compare/divergence.cpp" \
        "$root/src/compare/divergence_text.cpp" "$here/added_varying.cpp"; do
    "$compiler" $flags -I "$scratch/whole" -I "$root/src" -c "$source" \
        -o "$scratch/$(basename "$source").o"
done
"$compiler" "$scratch"/*.o -lfmt -o "$scratch/added_varying"
"$scratch/added_varying"
