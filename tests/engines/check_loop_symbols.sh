#!/usr/bin/env bash
# Plants shared functions in objects of loops, and checks that loop_symbols.sh finds them.
#   check_loop_symbols.sh NM COMPILER FOLDER
set -u
nm=${1:?NM is missing} compiler=${2:?COMPILER is missing} folder=${3:?FOLDER is missing}
test=$(dirname "$0")/loop_symbols.sh
mkdir -p "$folder" || exit 2
own='namespace rasterwalk::fast { struct Loops { int n; }; static const Loops loops{1};
    const Loops& scalar_loops() { return loops; } }'
faults=0

# expect CODE WORDS SOURCE: what the test says about an object built from this source.
expect() {
    local object=$folder/fast_loops_scalar.cpp.o said code
    "$compiler" -std=c++20 -O0 -x c++ -c -o "$object" - <<<"$3" || exit 2
    said=$(bash "$test" "$nm" "$object" 2>&1)
    code=$?
    if [ "$code" -ne "$1" ] || [[ $said != *"$2"* ]]; then
        echo "exit $code, not $1, or no '$2' in: $said"
        faults=1
    fi
}
expect 0 "1 objects" "$own"
expect 1 "shared()" "$own inline int shared() { return 1; } [[gnu::used]] static int (*volatile use)() = shared;"
expect 1 "shared_number is global" "$own inline int shared_number = 1; [[gnu::used]] static int* volatile use = &shared_number;"
expect 1 "kept is global" "$own inline int f() { static int kept = 1; return ++kept; } [[gnu::used]] static int (*volatile use)() = f;"
expect 1 "twice<int>" "$own template <class T> T twice(T t) { return t + t; } [[gnu::used]] static int use = twice(1);"
expect 1 "another()" "$own int another() { return 1; }"
expect 1 "is missing" "static int nothing() { return 1; } [[gnu::used]] static int (*volatile use)() = nothing;"
bash "$test" "$nm" "$folder/none.o" >/dev/null 2>&1
[ $? -eq 2 ] || { echo "nothing to look at is no fault"; faults=1; }
exit $faults
