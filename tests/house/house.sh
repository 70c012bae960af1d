#!/usr/bin/env bash
# The order of the house: which way includes run, and the flags that the core is compiled with.
#   house.sh ROOT [COMPILE_COMMANDS]
# ROOT holds src/ and ui/; COMPILE_COMMANDS is the compile_commands.json of a build of it.
# Prints file:line and a sentence for each fault; exits 1 if there is one, 2 if there was nothing to read.
set -u
root=${1:?ROOT is missing}
commands=${2:-}
cd "$root" || exit 2

# The kit is compiled with students' programs, not with ours.
mapfile -t files < <(find src ui -path src/mine/kit -prune -o -type f \( -name '*.h' -o -name '*.cpp' \) -print 2>/dev/null |
    LC_ALL=C sort)
if [ ${#files[@]} -eq 0 ]; then
    echo "$root: no sources under src/ and ui/" >&2
    exit 2
fi

# The order of the folders: an include may not go to a later line, nor to a neighbour on the same line.
# `ui` is ui/ui.h, the state of the whole interface; `state` is the states of its parts, ui/*/*_state.h.
order='
    base
    code
    scene
    stages
    mistakes
    settings
    pipeline
    engines
    picture inspect outside lab_code
    explain compare
    session
    view
    laboratory
    mine
    facts
    text
    figures
    lessons
    opening
    state
    cli ui
    widgets
    page
    actions
    canvas
    lesson
    bars inspector sheets start
    app
    hand
    hosts
'
faults=$(awk -v order="$order" '
    function folder_of(path) {
        if (path == "ui/ui.h") return "ui"
        if (path ~ /^ui\/.*_state\.h$/) return "state"
        sub(/^ui\//, "", path)
        sub(/^src\//, "", path)
        return path ~ /\// ? substr(path, 1, index(path, "/") - 1) : ""
    }
    function fault(sentence) { printf "%s:%d: %s\n", FILENAME, FNR, sentence }
    BEGIN {
        lines = split(order, line, "\n")
        for (i = 1; i <= lines; ++i) {
            names = split(line[i], name, " ")
            for (j = 1; j <= names; ++j) rank[name[j]] = i
        }
    }
    FNR == 1 {
        from = folder_of(FILENAME)
        if (!(from in rank)) fault("this folder has no place in the order of the house")
    }
    /^[ \t]*#[ \t]*(include|import)[ \t]*[<"]/ {
        target = $0
        sub(/^[ \t]*#[ \t]*(include|import)[ \t]*/, "", target)
        quoted = substr(target, 1, 1) == "\""
        target = substr(target, 2)
        sub(/[>"].*$/, "", target)
        to = folder_of(target)
        graphics = target ~ /^(GL|GLES[0-9]?|GLFW|KHR|EGL|X11)\// || target ~ /glfw|osmesa|glcorearb|impl_opengl/ ||
                   target ~ /^imgui_impl_/
        if (to in rank) {
            if (!(from in rank)) next
            if (rank[to] > rank[from])
                fault(from " includes \"" target "\" of " to ", which comes after it")
            else if (to != from && rank[to] == rank[from])
                fault(from " includes \"" target "\" of " to ", which is on the same level")
        } else if (quoted) {
            fault("\"" target "\" is not written from src/ or from the root")
        }
        if (FILENAME ~ /^src\// && (graphics || target ~ /imgui|imstb/ || target ~ /^GL/ || target ~ /^ui\//))
            fault("src/ includes <" target ">: the core has no window")
        else if (FILENAME ~ /^ui\// && from != "hosts" && graphics)
            fault("ui/ includes <" target ">: only ui/hosts/ speaks to the graphics system")
    }
    FILENAME ~ /^src\// && /#[ \t]*pragma.*(FP_CONTRACT[ \t]+ON|fast-math|Ofast|fp_contract)/ {
        fault("this pragma lets the compiler change numbers")
    }
' "${files[@]}")

if [ -n "$commands" ]; then
    if [ ! -r "$commands" ]; then
        echo "$commands: cannot be read" >&2
        exit 2
    fi
    # An entry for each source file, its command on one line and its "file" after it.
    flags=$(awk -v root="$(pwd)" '
        /^[ \t]*"command":/ { command = $0; line = FNR }
        /^[ \t]*"file":/ {
            file = $0
            sub(/^[ \t]*"file":[ \t]*"/, "", file); sub(/".*$/, "", file)
            # Or the file that includes all sources of a folder of the core.
            if (index(file, root "/src/") != 1 && file !~ /\/rasterwalk_(core|drawing|engines|following|reporting)\.dir\/Unity\/[^\/]*$/) next
            ++core
            # The loops of the fast engine do not promise the same bits.
            if (file ~ /\/src\/engines\/fast\/fast_loops_[a-z0-9]*\.cpp$/) next
            if (match(command, /-ffast-math|-Ofast|-funsafe-math-optimizations|-fassociative-math|-ffp-contract=(fast|on)/))
                printf "%s:%d: %s is compiled with %s\n", FILENAME, line, file, substr(command, RSTART, RLENGTH)
            if (command !~ /-ffp-contract=off/)
                printf "%s:%d: %s is compiled without -ffp-contract=off\n", FILENAME, line, file
        }
        END { if (!core) printf "%s:1: names no file of %s/src\n", FILENAME, root }
    ' "$commands")
    faults=$faults${faults:+${flags:+$'\n'}}$flags
fi

if [ -n "$faults" ]; then
    printf '%s\n' "$faults"
    exit 1
fi
echo "${#files[@]} files: includes run one way."
