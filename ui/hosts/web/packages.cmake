# For a browser, the packages that the system provides as libraries are compiled here, under the same names.
#   RASTERWALK_SOURCES  the folder with their unpacked sources; ui/hosts/web/build fetches them
enable_language(C)
set(RASTERWALK_SOURCES "${CMAKE_BINARY_DIR}/../web-sources" CACHE PATH
  "Folder with the unpacked sources of imgui, freetype, fmtlib and md4c")
set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
add_compile_options(-fwasm-exceptions)
add_link_options(-fwasm-exceptions)

# rasterwalk_source(VARIABLE PATTERN): the folder of the only file that matches the pattern, below the sources.
function(rasterwalk_source variable pattern)
  file(GLOB found ${RASTERWALK_SOURCES}/${pattern})
  list(LENGTH found count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "${RASTERWALK_SOURCES} has ${count} files ${pattern}; ui/hosts/web/build fetches them.")
  endif()
  get_filename_component(folder ${found} DIRECTORY)
  set(${variable} ${folder} PARENT_SCOPE)
endfunction()
rasterwalk_source(imgui_folder imgui-*/imgui.h)
rasterwalk_source(freetype_folder freetype-*/CMakeLists.txt)
rasterwalk_source(fmt_folder fmt*/src/format.cc)
rasterwalk_source(md4c_folder md4c-*/src/md4c.c)

# Headers that need no library, without the rest of /usr/include, which belongs to the system.
set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(name toml++ glm CLI nlohmann utf8cpp)
  file(CREATE_LINK /usr/include/${name} ${headers}/${name} SYMBOLIC)
endforeach()
include_directories(SYSTEM ${headers})

add_library(toml INTERFACE)
target_compile_definitions(toml INTERFACE TOML_HEADER_ONLY=1)
add_library(PkgConfig::tomlplusplus ALIAS toml)

add_library(json INTERFACE)
add_library(nlohmann_json::nlohmann_json ALIAS json)

add_library(fmt STATIC ${fmt_folder}/format.cc)
target_include_directories(fmt SYSTEM PUBLIC ${fmt_folder}/../include)
add_library(fmt::fmt ALIAS fmt)

add_library(md4c STATIC ${md4c_folder}/md4c.c ${md4c_folder}/entity.c)
target_include_directories(md4c SYSTEM PUBLIC ${md4c_folder})
add_library(PkgConfig::md4c ALIAS md4c)

file(WRITE ${CMAKE_BINARY_DIR}/stb.c
  "#define STB_IMAGE_IMPLEMENTATION\n#include <stb_image.h>\n"
  "#define STB_IMAGE_WRITE_IMPLEMENTATION\n#include <stb_image_write.h>\n")
add_library(stb STATIC ${CMAKE_BINARY_DIR}/stb.c)
target_include_directories(stb SYSTEM PUBLIC /usr/include/stb)
add_library(PkgConfig::stb ALIAS stb)

set(CMAKE_POLICY_DEFAULT_CMP0077 NEW)
foreach(part ZLIB BZIP2 PNG HARFBUZZ BROTLI)
  set(FT_DISABLE_${part} ON)
endforeach()
add_subdirectory(${freetype_folder} freetype EXCLUDE_FROM_ALL)
# Only its modules that draw TrueType fonts: a tenth of the program.
file(WRITE ${CMAKE_BINARY_DIR}/freetype_modules.h
  "FT_USE_MODULE(FT_Module_Class, autofit_module_class)\n"
  "FT_USE_MODULE(FT_Driver_ClassRec, tt_driver_class)\n"
  "FT_USE_MODULE(FT_Module_Class, sfnt_module_class)\n"
  "FT_USE_MODULE(FT_Renderer_Class, ft_smooth_renderer_class)\n")
target_compile_definitions(freetype PRIVATE "FT_CONFIG_MODULES_H=<${CMAKE_BINARY_DIR}/freetype_modules.h>")
add_library(Freetype::Freetype ALIAS freetype)

add_library(imgui STATIC
  ${imgui_folder}/imgui.cpp ${imgui_folder}/imgui_draw.cpp ${imgui_folder}/imgui_tables.cpp
  ${imgui_folder}/imgui_widgets.cpp ${imgui_folder}/misc/cpp/imgui_stdlib.cpp
  ${imgui_folder}/misc/freetype/imgui_freetype.cpp ${imgui_folder}/backends/imgui_impl_opengl3.cpp)
target_include_directories(imgui SYSTEM PUBLIC ${imgui_folder} ${imgui_folder}/misc/cpp
  ${imgui_folder}/misc/freetype)
target_compile_definitions(imgui PUBLIC IMGUI_IMPL_OPENGL_ES3)
# Its queries to WebGL, each of which waits for the whole picture, are answered in ui/hosts/web/page.cpp.
set_source_files_properties(${imgui_folder}/backends/imgui_impl_opengl3.cpp PROPERTIES
  COMPILE_DEFINITIONS glGetIntegerv=known_gl_integer)
target_link_libraries(imgui PUBLIC freetype)
add_library(PkgConfig::imgui ALIAS imgui)

find_package(Threads REQUIRED)
