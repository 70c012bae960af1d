#!/bin/sh
# check_libraries.sh osmesa|egl WINDOW_PROGRAM MEMORY_PROGRAM...
# The window's program has libGL and no libOSMesa. The others have libOSMesa, or libEGL and libOpenGL, and neither the
# other nor libGL nor GLFW.
set -eu
fault=0

expect() { # program, library, yes or no
  found=no
  if printf '%s\n' "$libraries" | grep -Eq "^[[:space:]]*$2\.so"; then found=yes; fi
  if [ "$found" != "$3" ]; then
    echo "$1: is $2 loaded? expected $3, found $found" >&2
    fault=1
  fi
}

osmesa=yes egl=no
if [ "$1" = egl ]; then osmesa=no egl=yes; fi
shift
libraries=$(ldd "$1")
expect "$1" "lib(GL|OpenGL)" yes
expect "$1" libOSMesa no
shift
for program in "$@"; do
  libraries=$(ldd "$program")
  expect "$program" libOSMesa $osmesa
  expect "$program" "lib(EGL|OpenGL)" $egl
  expect "$program" "lib(GL|GLX)" no
  expect "$program" libglfw no
done
exit $fault
