#!/usr/bin/env bash
# Shows that tidy.py can find faults: builds a small tree, plants one at a time and checks that it is found.
#   check_tidy.sh CLANG_TIDY_FILE
set -u
config=${1:?the .clang-tidy to ask with is missing}
tidy=$(cd "$(dirname "$0")" && pwd)/tidy.py
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
export XDG_CACHE_HOME=$tree/cache
failed=0
mkdir -p "$tree"/src/{scene,stages} && cp "$config" "$tree/.clang-tidy" && cd "$tree" || exit 2

new_tree() {
    rm -rf src/*/*
    printf '#pragma once\nint size_of(int side);\n' >src/scene/size.h
    printf '#include "scene/size.h"\n\nint size_of(int side) { return side * side; }\n' >src/scene/size.cpp
    printf '#include "scene/size.h"\n\nint twice(int side) { return 2 * size_of(side); }\n' >src/scene/twice.cpp
    printf 'int edge(int side) { return side; }\n' >src/stages/edge.cpp
    local entries= source
    for source in src/*/*.cpp; do
        entries+=${entries:+,}$(printf '{"directory": "%s", "command": "c++ -I%s/src -std=c++20 -o a.o -c %s", "file": "%s"}' \
            "$tree" "$tree" "$tree/$source" "$tree/$source")
    done
    echo "[$entries]" >compile_commands.json
}
# expect CODE WANTED ARGUMENTS...: tidy.py ends with this code, and its answer contains WANTED.
expect() {
    local code answer
    answer=$(python3 "$tidy" "$3" compile_commands.json "${@:4}" 2>&1)
    code=$?
    if [ $code -eq 77 ]; then
        echo "$answer"
        exit 77
    fi
    [ $code -eq "$1" ] && [[ $answer == *"$2"* ]] && return
    echo "${*:3}: expected exit code $1 and '$2', got $code and: $answer"
    failed=1
}

new_tree
expect 0 "3 files in 2 units" checks folders
expect 0 "3 files in 2 units, 2 remembered" checks folders
expect 0 "0 files remembered, 0 analyzed, 3 left for another time" analyzer -1
expect 0 "0 files remembered, 3 analyzed" analyzer
expect 0 "3 files remembered, 0 analyzed" analyzer 60

# After a change in a header, the files that read it are checked again.
echo "int half(int side);" >>src/scene/size.h
expect 0 "1 files remembered, 2 analyzed" analyzer
expect 0 "3 files in 2 units, 1 remembered" checks folders
echo "int third(int side);" >>src/stages/edge.cpp
expect 0 "3 files in 2 units, 1 remembered" checks folders
expect 0 "3 files in 2 units, 2 remembered" checks folders
echo "# another" >>.clang-tidy
expect 0 "0 files remembered, 3 analyzed" analyzer
expect 0 "3 files in 2 units." checks folders
sed -i 's/-std=c++20/-std=c++17/g' compile_commands.json
expect 0 "0 files remembered, 3 analyzed" analyzer
expect 0 "3 files in 2 units." checks folders

# A fault in the text, in a source and in a header.
new_tree
echo "int BadName() { return 3; }" >>src/scene/twice.cpp
for _ in first again; do
    expect 1 "src/scene/twice.cpp:4:5: error: invalid case style for function 'BadName'" checks folders
done
new_tree
echo "inline int BadName() { return 3; }" >>src/scene/size.h
expect 1 "src/scene/size.h:3:12: error: invalid case style" checks folders

# A fault that only a path shows; faulty files are not remembered.
new_tree
echo "int at(bool known) { int* place = nullptr; int there = 1; if (known) place = &there; return *place; }" >>src/stages/edge.cpp
expect 0 "3 files in 2 units" checks folders
expect 1 "src/stages/edge.cpp:2:" analyzer
expect 1 "NullDereference" analyzer

# Two helpers of the same name are not a fault: the files are checked separately, even if the clash was not foreseen.
new_tree
for file in size twice; do
    echo "namespace { int helper() { return 3; } } int $file() { return helper(); }" >>"src/scene/$file.cpp"
done
sed -i 's/int twice(int side)/int doubled(int side)/; s/int size(/int squared(/' src/scene/*.cpp
expect 0 "1 in parts: names meet" checks folders
echo "int BadName() { return 3; }" >>src/scene/twice.cpp
expect 1 "invalid case style for function 'BadName'" checks folders

new_tree
for file in size twice; do
    printf 'namespace {\n\nstruct Helper {\n    int %s = 0;\n};\n\n} // namespace\n' $file >>"src/scene/$file.cpp"
done
expect 0 "3 files in 2 units." checks folders

# The same for a name that a header gives to something else.
new_tree
printf '#pragma once\nstruct Side {\n    int length = 0;\n};\n' >src/stages/side.h
printf '#include "stages/side.h"\n\nint length_of(Side side) { return side.length; }\n' >>src/stages/edge.cpp
printf 'namespace {\n\nusing Side = double;\n\n} // namespace\n\nSide half(Side side) { return side / 2.0; }\n' >>src/scene/size.cpp
sed -i 's/^#include "stages.*$//; 1i #include "stages/side.h"' src/stages/edge.cpp
mv src/stages/edge.cpp src/scene/edge.cpp
sed -i 's,stages/edge.cpp,scene/edge.cpp,g' compile_commands.json
expect 0 "3 files in 2 units." checks folders

# Two programs, each with a main and with a different macro on its command line.
new_tree
for file in size twice; do
    echo "int main() { return 0; }" >>"src/scene/$file.cpp"
    sed -i "s,-std=c++20 -o a.o -c $tree/src/scene/$file,-DNAME_OF_$file -std=c++20 -o a.o -c $tree/src/scene/$file," compile_commands.json
done
expect 0 "3 files in 2 units." checks folders

[ $failed -eq 0 ] && echo "Every fault was found in its place."
exit $failed
