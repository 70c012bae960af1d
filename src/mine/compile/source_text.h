#pragma once

// What a source says, as far as that can be seen without a compiler.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// The largest source that is read, bytes.
inline constexpr std::size_t largest_source = std::size_t{4} << 20;

/// A source as a compiler is to read it: without a byte order mark. Its lines may end as in
/// Windows. Throws AccessError if it cannot be read, InputError if it is too large, UTF-16 or no
/// text at all.
std::string read_source(const std::string& path);

/// Can a name in a source have it? ASCII only.
bool is_name_letter(char letter);

/// The text with blanks for its comments, and for what `#if 0` leaves out; line breaks stay, so all
/// else keeps its place.
std::string without_comments(std::string_view source);

/// The same with blanks for everything in quotes and for the directives of the preprocessor too.
std::string bare_code(std::string_view source);

/// An #include of a source, not one in a comment.
struct Include {
    std::size_t begin = 0, end = 0; ///< of what follows #include, with its quotes or brackets
    std::string name;
    bool is_quoted = false; ///< "name", and not <name>
};
std::vector<Include> includes_of(std::string_view source);

/// The functions that a source declares and defines outside classes and functions, each name once
/// and sorted: "Draw", "Camera::Update".
struct FunctionNames {
    std::vector<std::string> declared, defined;
};
FunctionNames function_names(std::string_view source);

} // namespace rasterwalk
