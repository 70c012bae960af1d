#pragma once

// Files that other files name: the texture of a scene, the materials of a model, their images.

#include <initializer_list>
#include <string>
#include <string_view>

namespace rasterwalk {

/// A file that another one names.
struct BesideFile {
    std::string path;    ///< empty: it is not to be read
    std::string trouble; ///< why not: "there is no file 'x.mtl'"; empty if it is there
};

/// Looks for a file that another one names. It lies beside that one or in a folder below it, so
/// that both can be handed on together: under its whole name, with the backslashes of another
/// system as slashes, or beside it under its last name alone, since many programs write the place
/// that an image had on their own disk. Nothing is opened; what is no plain file, as a folder, a
/// pipe or a device, is refused.
/// @param namers paths of the file that names it, and of those that led there: the image of a
/// material may lie beside the materials, or beside the model
BesideFile find_beside(std::initializer_list<std::string_view> namers, std::string_view name);

} // namespace rasterwalk
