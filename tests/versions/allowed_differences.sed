# What may differ between the version before the types and the stream were rewritten (commit 4727bb7) and those after
# it. compare_versions reads the answers of both versions through this script: what is removed or spelled alike here is
# not a difference. Every rule says why. A record goes from ">>> invocation" to "<<< exit code".

# Settings that did not exist: shading, and the two parts of rounding. Each has a new row in the lists, removed here.
/^ *\{ *$/{
    :object
    /\n *\}/!{
        N
        b object
    }
    s/\n *"(clip|cull)",//g
    /"name" *: *"(vertex_rounding|line_rounding)"/d
    /"name" *: *"shading".*"(takes|words)" *: *(\[[ \n]*)?"unlit/d
    /"name" *: *"table\.e(dge)?[0-9]\.samples"/d
    s/"name"( *: *)"depth_order"/"name"\1"shading"/
}
/^  (shading=(unlit|gouraud|phong)|vertex_rounding=|line_rounding=)/,/^      Takes /d
/^setting (shading (unlit|gouraud|phong)|vertex_rounding .*|line_rounding .*)$/d
/^>>> (own )?rasterwalk facts$/,/^<<< exit/{
    /^(shading|depth_order|vertex_rounding|line_rounding) +word$/{
        N
        d
    }
}

# The setting `shading` (when a fragment's colour is computed) is now `depth_order`; `shading` says which light. Its old
# words are still read, and set the new one.
s/depth_order=(after|before)_depth_test/shading=\1_depth_test/g
s/^setting depth_order /setting shading /
s/^(err: rasterwalk: shading cannot be '[^']*': it takes ).*/\1its words./

# They are in the Settings tab, which is longer; these steps of lessons open it.
/^>>> (own )?rasterwalk-offscreen .*--tab settings/,/^<<< exit/{
    /^widget /d
    /^[0-9a-f]{32}  /d
}
/^>>> rasterwalk-offscreen .*--lesson (01-.* [356]|02-.* [13-6]|03-.* [46]|04-.* [37]|09-.* [45]|10-.* 3|12-.* [56]) --report/,/^<<< exit/{
    /^widget /d
    /^[0-9a-f]{32}  /d
}

# Time has two more phases, clip and cull; so far nothing happens in them.
s/One of: vertices clip cull edges rows end/One of: vertices edges rows end/

# Text counts triangles, vertices, edges and samples from 0, as JSON and the text of moments did before, and spells their
# names as in C++: triangles[7], vertices[0], edge 1, line[4]. Numbers that sed cannot count down by one are removed.
s/\bedge [0-9]+, (sample [0-9]+|line\[[0-9]+\]) of [0-9]+\. A: /a sample. A: /
s/\bedge [0-9]+ has ([0-9]+) samples? in A and /an edge has \1 in A and /
s/\b(vertex [0-9]+ of [0-9]+|vertices\[[0-9]+\]): /a vertex: /
s/^Triangle ([0-9]+) \((.*)\), counted from 0, one of ([0-9]+)$/triangles[\1] of \3 (\2)/
s/\btriangle ([0-9]+) \(/triangles[\1] (/
s/^Vertices +(v0 +v1 +v2|vertices\[0\] +vertices\[1\] +vertices\[2\])$/Vertices/
s/^  e([0-9]+) from \(/  edge \1 from (/
s/^  e([0-9]+)\/s([0-9]+) at \(/  edge \1, line[\2] at (/
s/^err: rasterwalk: sample ([0-9]+) of edge ([0-9]+) at \(/err: rasterwalk: edge \2, line[\1] at (/
/^>>> (own )?rasterwalk pixel/,/^<<< exit/s/^ *[0-9]+  (t[0-9]+\/)/\1/

# The facts about an edge's samples are named as the text of a moment names the edge; their old names counted from 1.
/^table\.e(dge)?[0-9]\.samples /{
    N
    d
}
s/(Triangle of the moment|Sample of that edge|Selected triangle|Triangle that the inspector shows), from 0(: line\[\.\.\.\])?/\1/

# A count of one takes the singular.
s/\bhas only 1 rows\b/has only 1 row/

# Lessons are checked by the parser that draws them: a line of single dashes does not make a table, and for a formula
# over several lines each command is named at its own line.
/^>>> rasterwalk check broken_lessons\/18-wide-table\.md$/,/^<<< exit/{
    /^(>>>|<<< exit)/!d
    s/^<<< exit .*/<<< exit/
}
/^broken_lessons\/(14-formulas\.md:1[79]: the program cannot draw|18-wide-table\.md:)/d
/^>>> rasterwalk check broken_lessons(\/14-formulas\.md)?$/,/^<<< exit/s/^(err: rasterwalk: )[0-9]+ faults/\1faults/

# `diagnose --help` says everything that it reads.
s/^(  FILE REQUIRED .*'); - reads standard input$/\1/
