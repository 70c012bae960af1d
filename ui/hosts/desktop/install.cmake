# What `cmake --install` installs, and `cpack` packs: the programs and their lessons; man pages and completions, made by
# the programs themselves; and what a desktop needs to show Rasterwalk among its applications.
set(desktop ${CMAKE_CURRENT_LIST_DIR})
# The day of the release is written in one place.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS CITATION.cff)
file(STRINGS CITATION.cff release_date REGEX "^date-released:")
string(REGEX MATCH "[0-9]+-[0-9]+-[0-9]+" release_date "${release_date}")

# The programs look for what they need in ../libexec and ../share, on every system. rasterwalk-llvmpipe is started by the
# others; it is of no use on its own.
install(TARGETS rasterwalk rasterwalk-offscreen RUNTIME DESTINATION bin)
install(TARGETS rasterwalk-llvmpipe RUNTIME DESTINATION libexec/rasterwalk)
install(DIRECTORY lessons DESTINATION share/rasterwalk)

# made_file(NAME FOLDER COMMAND...): a file made of a command's output, compressed if it is named so, and where it goes.
function(made_file name folder)
  set(file ${PROJECT_BINARY_DIR}/installed/${name})
  string(REGEX REPLACE "[.]gz$" "" text ${file})
  set(compress)
  if(NOT text STREQUAL file)
    set(compress COMMAND gzip -9nf ${text})
  endif()
  add_custom_command(OUTPUT ${file} COMMAND ${ARGN} > ${text} ${compress}
    DEPENDS rasterwalk rasterwalk-offscreen CHANGELOG.md VERBATIM)
  install(FILES ${file} DESTINATION share/${folder})
  set_property(GLOBAL APPEND PROPERTY rasterwalk_made_files ${file})
endfunction()
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/installed)
foreach(program IN ITEMS rasterwalk rasterwalk-offscreen)
  made_file(${program}.1.gz man/man1 $<TARGET_FILE:${program}> --print-for-package manual)
  made_file(${program} bash-completion/completions $<TARGET_FILE:${program}> --print-for-package bash)
  made_file(_${program} zsh/vendor-completions $<TARGET_FILE:${program}> --print-for-package zsh)
  made_file(${program}.fish fish/vendor_completions.d $<TARGET_FILE:${program}> --print-for-package fish)
endforeach()
made_file(changelog.gz doc/rasterwalk ${CMAKE_COMMAND} -E cat ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
get_property(made_files GLOBAL PROPERTY rasterwalk_made_files)
add_custom_target(rasterwalk_made_files ALL DEPENDS ${made_files})

configure_file(${desktop}/rasterwalk.metainfo.xml.in ${PROJECT_BINARY_DIR}/rasterwalk.metainfo.xml @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/rasterwalk.metainfo.xml DESTINATION share/metainfo)
install(FILES ${desktop}/rasterwalk.desktop DESTINATION share/applications)
install(FILES ${desktop}/rasterwalk.svg DESTINATION share/icons/hicolor/scalable/apps)
install(FILES ${desktop}/copyright DESTINATION share/doc/rasterwalk)
