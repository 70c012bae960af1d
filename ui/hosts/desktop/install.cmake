# What `cmake --install` installs, and `cpack` packs: the programs and their lessons; man pages and completions, made by
# the programs themselves; and what a desktop needs to show Rasterwalk among its applications.
include(GNUInstallDirs)
set(desktop ${CMAKE_CURRENT_LIST_DIR})
# The day of the release is written in one place.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS CITATION.cff)
file(STRINGS CITATION.cff release_date REGEX "^date-released:")
string(REGEX MATCH "[0-9]+-[0-9]+-[0-9]+" release_date "${release_date}")

install(TARGETS rasterwalk rasterwalk-offscreen RUNTIME)
# rasterwalk starts it; it is of no use on its own.
install(TARGETS rasterwalk-llvmpipe RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/rasterwalk)
install(DIRECTORY lessons DESTINATION ${CMAKE_INSTALL_DATADIR}/rasterwalk)

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
  install(FILES ${file} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder})
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
install(FILES ${PROJECT_BINARY_DIR}/rasterwalk.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${desktop}/rasterwalk.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${desktop}/rasterwalk.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES ${desktop}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/rasterwalk)
