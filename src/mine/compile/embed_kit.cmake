# Writes the files of a folder as C++: cmake -DKIT=FOLDER -DOUTPUT=FILE.cpp -P embed_kit.cmake

file(GLOB_RECURSE names LIST_DIRECTORIES false RELATIVE ${KIT} ${KIT}/*)
list(SORT names)
set(written "// Written by embed_kit.cmake.\n#include \"mine/compile/kit_parts.h\"\n\nnamespace rasterwalk {\n\n")
string(APPEND written "const std::vector<KitPart>& kit_parts() {\n    static const std::vector<KitPart> parts = {\n")
set(bytes_in_part 3000) # compilers warn about literals of 64 kB
math(EXPR digits_in_part "2 * ${bytes_in_part}")
foreach(name IN LISTS names)
  # Read as digits, because CMake's lists treat semicolons and brackets of a text as their own.
  file(READ ${KIT}/${name} digits HEX)
  string(LENGTH "${digits}" length)
  set(start 0)
  while(start LESS length OR start EQUAL 0)
    string(SUBSTRING "${digits}" ${start} ${digits_in_part} part)
    string(LENGTH "${part}" size)
    math(EXPR size "${size} / 2")
    string(REGEX REPLACE "(..)" "\\\\x\\1" part "${part}")
    string(APPEND written "        {\"${name}\", {\"${part}\", ${size}}},\n")
    math(EXPR start "${start} + ${digits_in_part}")
  endwhile()
endforeach()
string(APPEND written "    };\n    return parts;\n}\n\n} // namespace rasterwalk\n")
file(WRITE ${OUTPUT} "${written}")
