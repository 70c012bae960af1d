#!/usr/bin/env bash
# Shows that the house test can fail: builds small houses with one fault each and checks that it is found.
set -u
house=$(cd "$(dirname "$0")" && pwd)/house.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failed=0

new_house() {
    rm -rf "${tree:?}"/*
    mkdir -p "$tree"/src/{base,scene,stages,settings,pipeline,picture,inspect,session,cli} "$tree"/ui/{widgets,canvas,bars,inspector,app,hosts}
    echo '#include "scene/scene.h"' >"$tree/src/stages/stages.h"
    echo '#include "ui/ui.h"' >"$tree/ui/inspector/rows_panel.cpp"
    printf '#include <imgui.h>\n#include "session/session.h"\n' >"$tree/ui/ui.h"
    printf '#include <GLFW/glfw3.h>\n#include "ui/ui.h"\n#include "cli/cli.h"\n' >"$tree/ui/hosts/window.cpp"
    echo '#include "session/session.h"' >"$tree/src/cli/cli.h"
    flags "-O2 -ffp-contract=off"
}
flags() { # FLAGS [FILE]
    printf '[\n{\n  "directory": "/",\n  "command": "c++ %s -c a.cpp",\n  "file": "%s"\n}\n]\n' \
        "$1" "${2:-$tree/src/scene/a.cpp}" >"$tree/compile_commands.json"
}
# expect WHAT: the house is refused, and the answer contains WHAT; if WHAT is empty, it is accepted.
expect() {
    answer=$("$house" "$tree" "$tree/compile_commands.json")
    code=$?
    if [ -z "$1" ]; then
        [ $code -eq 0 ] && return
        echo "A house in order was refused: $answer"
    else
        [ $code -eq 1 ] && [[ $answer == *"$1"* ]] && return
        echo "Expected the fault '$1', got exit code $code and: $answer"
    fi
    failed=1
}
# faulty FILE LINE WANTED: a house in order except for FILE, which has LINE as its second line.
faulty() {
    new_house
    printf '#pragma once\n%s\n' "$2" >"$tree/$1"
    expect "$1:2: $3"
}

new_house
expect ""
faulty src/scene/scene.h '#include "stages/stages.h"' 'scene includes "stages/stages.h" of stages'
faulty src/stages/edges.h '  #  include <pipeline/draw.h>' 'stages includes "pipeline/draw.h" of pipeline'
faulty src/pipeline/draw.cpp '#include "inspect/stats.h"' 'pipeline includes'
faulty src/inspect/stats.h '#include "session/session.h"' 'inspect includes'
faulty src/session/session.h '#include "ui/ui.h"' 'session includes'
faulty src/session/session.cpp '#include "cli/cli.h"' 'session includes'
faulty src/cli/cli.cpp '#include "ui/ui.h"' 'cli includes'
faulty src/base/files.h '#include "scene/scene.h"' 'base includes'
faulty src/settings/settings.h '#include "pipeline/draw.h"' 'settings includes'
faulty src/picture/overlay.cpp '#include "inspect/stats.h"' 'picture includes'
faulty ui/inspector/rows_panel.cpp '#include "ui/bars/bars.h"' 'inspector includes'
faulty ui/canvas/canvas.cpp '#include "ui/app/app.h"' 'canvas includes'
faulty ui/ui.h '#include "cli/cli.h"' 'ui includes'
faulty ui/canvas/canvas_state.h '#include "ui/ui.h"' 'state includes "ui/ui.h" of ui'
faulty ui/canvas/canvas_state.h '#include "ui/canvas/canvas.h"' 'state includes'
faulty src/cli/cli.h '#include "ui/canvas/canvas_state.h"' 'src/ includes <ui/canvas/canvas_state.h>'
faulty ui/app/app.cpp '#include "ui/hosts/window.h"' 'app includes'
faulty ui/app/app.cpp '#include "ui.h"' '"ui.h" is not written'
for header in imgui.h GL/gl.h GLFW/glfw3.h GL/osmesa.h imgui_impl_opengl2.h; do
    faulty src/session/results.cpp "#include <$header>" "src/ includes <$header>"
done
for header in GL/gl.h GLFW/glfw3.h GL/osmesa.h imgui_impl_glfw.h; do
    faulty ui/app/app.cpp "#include <$header>" "ui/ includes <$header>"
done
faulty src/stages/project.cpp '#pragma STDC FP_CONTRACT ON' 'this pragma'
new_house; mkdir "$tree/src/misc"; touch "$tree/src/misc/a.h"; echo >>"$tree/src/misc/a.h"
expect "src/misc/a.h:1: this folder has no place"
new_house; flags "-O3 -ffp-contract=off -ffast-math"; expect "compile_commands.json:4: $tree/src/scene/a.cpp is compiled with -ffast-math"
for library in core drawing reporting; do
    new_house; flags "-O3" "/b/rasterwalk_$library.dir/Unity/unity_src_stages_cxx.cxx"
    expect "$library.dir/Unity/unity_src_stages_cxx.cxx is compiled without -ffp-contract=off"
done
new_house; flags "-O3"; expect "is compiled without -ffp-contract=off"

[ $failed -eq 0 ] && echo "Every fault was found in its place."
exit $failed
