#pragma once

// Files that other files name: the texture of a scene, the materials of a model, their images.

#include <cstddef>
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

/// Counts the bytes of the files of one kind that are read for a scene.
class BesideBytes {
  public:
    /// @param most   bytes of them all
    /// @param plural says what they are: "all images"
    BesideBytes(std::size_t most, std::string_view plural) : most_(most), plural_(plural) {}

    /// A file is to be read. Throws InputError if all together would be more than may be read; it
    /// is then not counted.
    void add(const std::string& path);

  private:
    std::size_t most_;
    std::string_view plural_;
    std::size_t count_ = 0;
};

} // namespace rasterwalk
