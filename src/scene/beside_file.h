#pragma once

// Files that other files name: the texture of a scene, the materials of a model, their images.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A file that another one names.
struct BesideFile {
    std::string path;    ///< empty: it is not to be read
    std::string trouble; ///< why not: "there is no file 'x.mtl'"; empty if it is there
    std::string remark;  ///< where it is not named as it is called: "there is no file 'X.PNG';
                         ///< 'x.png' is used"; empty if it is
};

/// The most names in folders that are looked at for files that are not where they are said to be.
inline constexpr std::size_t most_names_looked_at = 1000;

/// Looks for files that other ones name. Such a file lies beside the one that names it or anywhere
/// below that one's folder, so that both can be handed on together, or below the folder that holds
/// that folder: archives of models come as `source/model.obj` and `textures/wood.png`. Nothing is
/// read from anywhere else.
///
/// A name is tried as it stands, with the backslashes of another system as slashes; then beside the
/// namer under its last part alone, since many programs write the place that an image had on their
/// own disk. Where there is no such file, one of the same last part is looked for without regard to
/// case: beside the namer, in the folders there, in the folders next to the namer's own, and deeper
/// below; among several, one in a folder of the name that was given comes first. That search
/// follows no links. Nothing is opened; what is no plain file, as a folder, a pipe or a device, is
/// refused.
class BesideFiles {
  public:
    /// @param namers paths of the file that names others, and of those that led there: the image of
    /// a material may lie beside the materials, or beside the model
    explicit BesideFiles(std::vector<std::string> namers);

    BesideFile find(std::string_view name) { return find(std::vector{std::string(name)}); }

    /// The first of several readings of one name that there is.
    /// @param names at least one; messages tell of the first
    BesideFile find(const std::vector<std::string>& names);

    /// The file of a name, without the search for one of a similar name.
    BesideFile find_exactly(const std::string& name) const;

  private:
    struct KnownFile {
        std::string folder, path;
    };

    std::string find_similar(const std::string& name);
    void look_around(const std::string& namer);
    void look_into(const std::string& folder, std::vector<std::string>& folders);

    std::vector<std::string> namers_;
    std::map<std::string, std::vector<KnownFile>> known_; ///< by their names in small letters
    std::size_t looked_at_ = 0;
    bool has_looked_ = false;
};

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
