# Dear ImGui, compiled from its sources in folder RASTERWALK_IMGUI, under the name that the system's package has.
add_library(imgui STATIC
  ${RASTERWALK_IMGUI}/imgui.cpp ${RASTERWALK_IMGUI}/imgui_draw.cpp ${RASTERWALK_IMGUI}/imgui_tables.cpp
  ${RASTERWALK_IMGUI}/imgui_widgets.cpp ${RASTERWALK_IMGUI}/misc/cpp/imgui_stdlib.cpp
  ${RASTERWALK_IMGUI}/misc/freetype/imgui_freetype.cpp
  ${RASTERWALK_IMGUI}/backends/imgui_impl_glfw.cpp ${RASTERWALK_IMGUI}/backends/imgui_impl_opengl2.cpp)
target_include_directories(imgui SYSTEM PUBLIC
  ${RASTERWALK_IMGUI} ${RASTERWALK_IMGUI}/misc/cpp ${RASTERWALK_IMGUI}/misc/freetype)
target_link_libraries(imgui PUBLIC Freetype::Freetype)
add_library(PkgConfig::imgui ALIAS imgui)
file(STRINGS ${RASTERWALK_IMGUI}/imgui.h imgui_VERSION REGEX "define IMGUI_VERSION ")
string(REGEX MATCH "[0-9.]+" imgui_VERSION "${imgui_VERSION}")
