# What `cpack` makes: a Debian package and an archive that runs from any folder, both of what install.cmake installs; and
# with --config CPackSourceConfig.cmake an archive of the sources.
set(CPACK_GENERATOR DEB TXZ)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_VENDOR "The Rasterwalk maintainers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "walk through a software rasterizer, stage by stage")
set(CPACK_PACKAGE_DESCRIPTION
  "Rasterwalk shows every step on the way from triangles to a picture: the
projected points, the samples of each edge, the row table as it fills, the
fragments row by row, the depth buffer, the light. Time runs in both
directions, and every number on the screen says where it comes from.

It has lessons with tasks that it checks, a laboratory of mistakes, and checks
of your own program of the rasterizer lab, for which it needs a C++ compiler
and GLM. Most of this is also available as commands, without a window.")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
# .invalid is no one's domain: the project has no address yet.
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The Rasterwalk maintainers <maintainers@rasterwalk.invalid>")
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core, fonts-dejavu-extra")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "g++ | clang, libglm-dev")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# Only Debian wants a changelog of the package besides the program's own, and to know which advice does not apply.
execute_process(COMMAND date -u -R -d ${release_date} OUTPUT_VARIABLE release_time OUTPUT_STRIP_TRAILING_WHITESPACE)
set(debian ${PROJECT_BINARY_DIR}/debian)
configure_file(${desktop}/changelog.Debian.in ${debian}/changelog @ONLY)
file(MAKE_DIRECTORY ${debian}/share/doc/rasterwalk)
execute_process(COMMAND gzip -9nc ${debian}/changelog OUTPUT_FILE ${debian}/share/doc/rasterwalk/changelog.Debian.gz)
cmake_host_system_information(RESULT debian_version QUERY DISTRIB_VERSION_ID)
file(READ ${desktop}/lintian-overrides overrides)
if(debian_version VERSION_LESS 13)
  string(REGEX REPLACE "# From Debian 13.*" "" overrides "${overrides}")
endif()
file(CONFIGURE OUTPUT ${debian}/share/lintian/overrides/rasterwalk CONTENT "${overrides}" @ONLY)
file(CONFIGURE OUTPUT ${debian}/package.cmake CONTENT [[
if(CPACK_GENERATOR STREQUAL "DEB")
  list(APPEND CPACK_INSTALLED_DIRECTORIES "@debian@/share" usr/share)
endif()
]] @ONLY)
set(CPACK_PROJECT_CONFIG_FILE ${debian}/package.cmake)

set(CPACK_SOURCE_GENERATOR TXZ)
string(REGEX REPLACE "([][+.*()^$?|\\\\])" "\\\\\\1" root "${PROJECT_SOURCE_DIR}")
set(CPACK_SOURCE_IGNORE_FILES "^${root}/(build|out|tests/failed|[.]git)(/|$)")
include(CPack)
