#include "lessons/lesson_picture.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/quoted.h"
#include "figures/figure_tags.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view screenshots = "../screenshots/";

bool is_within(const fs::path& file, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
           folder.end();
}

/// What a page shows: its kind as messages name it, how its name ends, and where it must be.
struct PictureKind {
    std::string_view name, ending, place;
    bool may_be_screenshot = false;
};
constexpr PictureKind png_picture{"picture", ".png",
                                  "a PNG in the lessons folder or in ../screenshots/", true};
constexpr PictureKind svg_figure{"figure", ".svg", "an SVG file in the lessons folder"};

/// The file itself, with symbolic links resolved.
fs::path find_picture(const fs::path& folder, std::string_view target, const PictureKind& kind) {
    const bool is_screenshot = kind.may_be_screenshot && target.starts_with(screenshots);
    const std::string_view inner = target.substr(is_screenshot ? screenshots.size() : 0);
    const bool leads_out = fs::path(inner).is_absolute() || inner.find("..") != inner.npos ||
                           inner.find(':') != inner.npos || inner.find('\\') != inner.npos;
    const auto refuse = [&] {
        throw UsageError(
            fmt::format("the {} {} must be {}.", kind.name, in_quotes(target), kind.place));
    };
    if (leads_out || !inner.ends_with(kind.ending)) refuse();
    const auto miss = [&] {
        throw UsageError(fmt::format("there is no {} {}.", kind.name, in_quotes(target)));
    };
    std::error_code fault;
    const fs::path inside = is_screenshot ? folder / ".." / "screenshots" : folder;
    const fs::path root = fs::canonical(inside.empty() ? "." : inside, fault);
    const fs::path file = fault ? fs::path() : fs::canonical(root / inner, fault);
    if (fault) miss();
    if (!is_within(file, root)) refuse();
    if (!fs::is_regular_file(file, fault)) miss();
    return file;
}

} // namespace

Image read_lesson_picture(const std::string& folder, const std::string& target) {
    const fs::path file = find_picture(folder, target, png_picture);
    try {
        return read_png(file.string(), largest_lesson_picture);
    } catch (const Error& fault) {
        // "path: sentence", with the picture's name as in the lesson.
        std::string_view sentence = fault.what();
        const std::string path = file.string() + ": ";
        if (sentence.starts_with(path)) sentence.remove_prefix(path.size());
        throw UsageError(fmt::format("the picture {}: {}", in_quotes(target), sentence));
    }
}

bool names_figure(std::string_view target) {
    return target.ends_with(svg_figure.ending);
}

Figure read_lesson_figure(const std::string& folder, const std::string& target) {
    const fs::path file = find_picture(folder, target, svg_figure);
    try {
        return read_figure(read_file(file.string(), largest_figure), visible_line(target));
    } catch (const Error& fault) {
        throw UsageError(std::string("the figure ") + fault.what());
    }
}

} // namespace rasterwalk
