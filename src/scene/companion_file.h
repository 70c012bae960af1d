#pragma once

// Files that other files name: the texture of a scene, the materials of a model, their images.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A file that another file names.
struct CompanionFile {
    std::string path;    ///< empty: it must not be read
    std::string problem; ///< why not: "there is no file 'x.mtl'"; empty if it is there
    std::string remark;  ///< if its real name differs: "there is no file 'X.PNG'; 'x.png' is
                         ///< used"; otherwise empty
};

/// The most folder entries that are searched for files that are not where they should be.
inline constexpr std::size_t most_names_checked = 1000;

/// Looks for files that other files name. Such a file is in the folder of the file that names it
/// (the namer) or anywhere below, so that both can be passed on together, or below the parent of
/// that folder: archives of models come as `source/model.obj` and `textures/wood.png`. Nothing is
/// read from anywhere else.
///
/// A name is tried as written, with backslashes read as slashes; then its last part alone is tried
/// in the namer's folder, since many programs write the place that an image had on their own disk.
/// If there is no such file, the search for one with the same last part ignores case: in the
/// namer's folder, in the folders in it, in the folders next to it, and deeper below; of several,
/// one in a folder of the given name comes first. That search follows no links. Nothing is opened;
/// anything but a plain file (a folder, a pipe, a device) is refused.
class CompanionFiles {
  public:
    /// @param namers paths of the file that names others, and of those that led to it: the image of
    /// a material may be next to the materials, or next to the model
    explicit CompanionFiles(std::vector<std::string> namers);

    CompanionFile find(std::string_view name) { return find(std::vector{std::string(name)}); }

    /// The first file that exists, of several readings of one name.
    /// @param names at least one; messages quote the first
    CompanionFile find(const std::vector<std::string>& names);

    /// The file of a name, without the search for one of a similar name.
    CompanionFile find_exactly(const std::string& name) const;

  private:
    struct KnownFile {
        std::string folder, path;
    };

    std::string find_similar(const std::string& name);
    void look_around(const std::string& namer);
    void look_into(const std::string& folder, std::vector<std::string>& folders);

    std::vector<std::string> namers_;
    std::map<std::string, std::vector<KnownFile>> known_; ///< by their names in lower case
    std::size_t names_checked_ = 0;
    bool has_searched_ = false;
};

/// Counts the bytes of all files of one kind that are read for a scene.
class CompanionBytes {
  public:
    /// @param most   bytes of all together
    /// @param plural their name: "all images"
    CompanionBytes(std::size_t most, std::string_view plural) : most_(most), plural_(plural) {}

    /// Counts a file that is about to be read. Throws InputError if all together would exceed the
    /// limit; the file is then not counted.
    void add(const std::string& path);

  private:
    std::size_t most_;
    std::string_view plural_;
    std::size_t count_ = 0;
};

} // namespace rasterwalk
