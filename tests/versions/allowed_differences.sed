# What may differ between the version before the types and the stream were made anew (commit 4727bb7) and those after
# it. compare_versions reads the answers of both versions through this script: what is taken out or spelled alike here
# is not a difference. Every rule says why. A record goes from ">>> invocation" to "<<< exit code".

# Settings that there were not: shading, and rounding in its two parts. Of each the lists have a new row, which goes.
/^ *\{ *$/{
    :object
    /\n *\}/!{
        N
        b object
    }
    /"name" *: *"(vertex_rounding|line_rounding)"/d
    /"name" *: *"shading".*"takes" *: *"unlit/d
    s/"name"( *: *)"depth_order"/"name"\1"shading"/
}
/^  (shading=(unlit|gouraud|phong)|vertex_rounding=|line_rounding=)/,/^      Takes /d
/^setting (shading (unlit|gouraud|phong)|vertex_rounding .*|line_rounding .*)$/d

# The setting `shading` (when a fragment's colour is worked out) is now `depth_order`; `shading` says which light. Its old
# words are still read, and set the new one.
s/depth_order=(after|before)_depth_test/shading=\1_depth_test/g
s/^setting depth_order /setting shading /
s/^(err: rasterwalk: shading cannot be '[^']*': it takes ).*/\1its words./

# They stand in the tab of settings, which is longer.
/^>>> (own )?rasterwalk-offscreen .*--tab settings/,/^<<< exit/{
    /^widget /d
    /^[0-9a-f]{32}  /d
}

# Time has two phases more, clip and cull; so far nothing happens in them.
s/One of: vertices clip cull edges rows end/One of: vertices edges rows end/
