#include "ui/widgets/fonts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <imgui_freetype.h>

namespace rasterwalk {

namespace {

/// Of Debian, Arch, others, and Fedora.
const char* const font_folders[] = {
    "/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/TTF/", "/usr/share/fonts/dejavu/",
    "/usr/share/fonts/dejavu-sans-fonts/", "/usr/share/fonts/dejavu-sans-mono-fonts/"};

bool is_font_file(const std::string& path) {
    std::error_code fault;
    const auto size = std::filesystem::file_size(path, fault);
    return !fault && size > 10'000;
}

/// The file in the first folder that has it; empty: ImGui aborts on a missing file or one that is
/// not a font.
std::string font_path(const char* name) {
    for (const char* folder : font_folders) {
        std::string path = std::string(folder) + name;
        if (is_font_file(path)) return path;
    }
    return {};
}

bool are_fonts_there() {
    return !font_path("DejaVuSans.ttf").empty() && !font_path("DejaVuSans-Bold.ttf").empty() &&
           !font_path("DejaVuSansMono.ttf").empty();
}

struct FontFile {
    const char* name;
    float size; ///< pixels at text scale 1
    ImFont* Fonts::*font;
};

constexpr std::array font_files{FontFile{"DejaVuSans.ttf", 16.0f, &Fonts::text},
                                FontFile{"DejaVuSansMono.ttf", 15.0f, &Fonts::mono},
                                FontFile{"DejaVuSans-Bold.ttf", 16.0f, &Fonts::bold},
                                FontFile{"DejaVuSans-Oblique.ttf", 16.0f, &Fonts::italic},
                                FontFile{"DejaVuSans-Bold.ttf", 21.0f, &Fonts::title},
                                FontFile{"DejaVuSans.ttf", 13.5f, &Fonts::small},
                                FontFile{"DejaVuSans-Bold.ttf", 32.0f, &Fonts::headline},
                                FontFile{"DejaVuSansMono.ttf", 13.0f, &Fonts::mono_small}};

/// What an atlas is made from.
struct FontSizes {
    bool is_built_in;                             ///< the fonts are not installed
    std::array<float, font_files.size()> sizes{}; ///< of the letters, screen pixels

    friend bool operator==(const FontSizes&, const FontSizes&) = default;
};

FontSizes sizes_for(float text_scale, float least) {
    FontSizes wanted{!are_fonts_there(), {}};
    for (std::size_t i = 0; i < font_files.size() && !wanted.is_built_in; ++i)
        wanted.sizes[i] = std::round(std::max(font_files[i].size * text_scale, least));
    return wanted;
}

Fonts make_fonts(const FontSizes& wanted) {
    Fonts fonts;
    fonts.atlas = std::make_shared<ImFontAtlas>();
    ImFontAtlas& atlas = *fonts.atlas;
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    if (wanted.is_built_in) {
        ImFont* const built_in = atlas.AddFontDefault();
        for (const FontFile& file : font_files)
            fonts.*file.font = built_in;
        fonts.notice = "The DejaVu fonts are not installed, so text is shown in the built-in font, "
                       "without mathematical symbols.";
    }
    // Latin, Greek, punctuation, super- and subscripts, arrows, mathematics, shapes, tick and
    // cross.
    static constexpr ImWchar ranges[] = {0x0020, 0x017F, 0x0302, 0x0302, 0x0391, 0x03C9, 0x2010,
                                         0x2044, 0x2070, 0x209C, 0x2190, 0x21FF, 0x2200, 0x22FF,
                                         0x25A0, 0x25FF, 0x2713, 0x2718, 0x27E8, 0x27E9, 0};
    for (std::size_t i = 0; i < font_files.size() && !wanted.is_built_in; ++i) {
        const FontFile& file = font_files[i];
        const std::string path = font_path(file.name);
        if (path.empty()) continue;
        ImFontConfig config;
        config.OversampleH = config.OversampleV = 1;
        fonts.*file.font = atlas.AddFontFromFileTTF(path.c_str(), wanted.sizes[i], &config, ranges);
    }
    if (fonts.italic == nullptr) fonts.italic = fonts.text;
    atlas.Build();
    atlas.ClearInputData(); // the files
    return fonts;
}

struct KeptFonts {
    FontSizes sizes;
    Fonts fonts;
};

constexpr std::size_t most_kept = 4;

} // namespace

Fonts load_fonts(float text_scale, float least) {
    static std::vector<KeptFonts> all_kept; // the last used is the first
    const FontSizes wanted = sizes_for(text_scale, least);
    auto found = std::find_if(all_kept.begin(), all_kept.end(),
                              [&](const KeptFonts& kept) { return kept.sizes == wanted; });
    if (found == all_kept.end()) {
        if (all_kept.size() == most_kept) all_kept.pop_back();
        all_kept.push_back({wanted, make_fonts(wanted)});
        found = all_kept.end() - 1;
    }
    std::rotate(all_kept.begin(), found, found + 1);
    Fonts fonts = all_kept.front().fonts;
    ImGuiIO& io = ImGui::GetIO();
    fonts.atlas->SetTexID(io.Fonts->TexID);
    io.Fonts = fonts.atlas.get();
    return fonts;
}

} // namespace rasterwalk
