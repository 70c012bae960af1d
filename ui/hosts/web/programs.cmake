# The programs for a browser: the page, and for tests under Node the commands and the hashes of the pictures.

set(memory "SHELL:-s ALLOW_MEMORY_GROWTH=1" "SHELL:-s INITIAL_MEMORY=64MB" "SHELL:-s TOTAL_STACK=5MB")

# What the page needs before its first picture comes with it, as rasterwalk.data: the texts of the lessons, and the
# fonts. ui/hosts/web/build puts them in folder `start`.
add_executable(rasterwalk ui/hosts/web/page.cpp ui/hosts/web/input.cpp ui/hosts/life.cpp ui/hosts/gl2.cpp)
set_target_properties(rasterwalk PROPERTIES SUFFIX .js LINK_DEPENDS "${CMAKE_BINARY_DIR}/start.stamp")
target_link_libraries(rasterwalk PRIVATE rasterwalk_ui)
target_link_options(rasterwalk PRIVATE -O2 ${memory} "SHELL:-s ENVIRONMENT=web"
  "SHELL:-s MIN_WEBGL_VERSION=2" "SHELL:-s MAX_WEBGL_VERSION=2"
  "SHELL:-s EXPORTED_RUNTIME_METHODS=ccall,callMain,FS,ENV"
  "SHELL:--preload-file ${CMAKE_BINARY_DIR}/start@/")

foreach(program rasterwalk-commands hash-pictures)
  add_executable(${program} EXCLUDE_FROM_ALL)
  set_target_properties(${program} PROPERTIES SUFFIX .js)
  target_link_libraries(${program} PRIVATE rasterwalk_core)
  target_link_options(${program} PRIVATE -O1 ${memory} "SHELL:-s ENVIRONMENT=node" "SHELL:-s NODERAWFS=1"
    "SHELL:-s EXIT_RUNTIME=1" "SHELL:--pre-js ${PROJECT_SOURCE_DIR}/tests/web/node.js")
endforeach()
target_sources(rasterwalk-commands PRIVATE tests/web/commands.cpp)
target_sources(hash-pictures PRIVATE tests/same_bits/hash_pictures.cpp)
