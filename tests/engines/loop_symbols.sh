#!/usr/bin/env bash
# Does any level of the fast engine's loops define symbols that other objects may use?
#   loop_symbols.sh NM OBJECT...
# Each level is compiled for different instructions. The linker keeps one copy of a weak symbol, such as an inline
# function or a template, for the whole program: compiled for a newer processor it would end the program on an older
# one. So an object of fast_loops_LEVEL.cpp has one global symbol, LEVEL_loops(), or none if LEVEL is not built. Other
# objects are not checked. Prints a sentence for each fault; exits 1 if there is one, 2 if there was nothing to check.
set -u
nm=${1:?NM is missing}
shift
looked_at=0
faults=
for object in "$@"; do
    file=${object##*/}
    [[ $file =~ ^fast_loops_([a-z0-9]+)\.cpp\. ]] || continue
    level=${BASH_REMATCH[1]}
    symbols=$("$nm" --defined-only --demangle "$object" 2>/dev/null) || { echo "$object: cannot be read" >&2; exit 2; }
    looked_at=$((looked_at + 1))
    [ -z "$symbols" ] && [ "$level" != scalar ] && continue
    # Small letters are local, except u, v and w, which are shared or weak.
    faults+=$(awk -v file="$file" -v own="rasterwalk::fast::${level}_loops()" '
        { kind = $2; name = $0; sub(/^[^ ]* *[A-Za-z] /, "", name) }
        kind == "T" && name == own { has_own = 1; next }
        kind ~ /^[A-Zuvw]$/ { printf "%s: %s is global, of kind %s\n", file, name, kind }
        END { if (!has_own) printf "%s: %s is missing\n", file, own }
    ' <<<"$symbols")
done
if [ "$looked_at" -eq 0 ]; then
    echo "no object of fast_loops_*.cpp is among those given" >&2
    exit 2
fi
if [ -n "$faults" ]; then
    echo "$faults"
    exit 1
fi
echo "$looked_at objects of loops share nothing."
