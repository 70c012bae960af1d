#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "figures/figure.h"

namespace rasterwalk {

const std::vector<FigureClass>& figure_classes() {
    using Colour = FigureColour;
    static const std::vector<FigureClass> classes{
        {"ink", "#1b1e23", "#e4e6ea", Colour::ink, nullptr, true},
        {"quiet", "#5a616b", "#969ca8", Colour::quiet, nullptr, true},
        {"edge-1", "#8a5c00", "#e69f00", Colour::edge_1, nullptr, true},
        {"edge-2", "#00704f", "#00b583", Colour::edge_2, nullptr, true},
        {"edge-3", "#9a4a76", "#d98bb5", Colour::edge_3, nullptr, true},
        {"left", "#706800", "#f0e442", Colour::left, nullptr, true},
        {"right", "#005a8f", "#4c9cd9", Colour::right, nullptr, true},
        {"current", "#000000", "#ffffff", Colour::current, nullptr, true},
        {"pass", "#0a6aa8", "#56b4e9", Colour::pass, nullptr, true},
        {"fail", "#a84200", "#f0722b", Colour::fail, nullptr, true},
        {"filled", "", "", Colour::ink, &FigureLook::is_filled, false},
        {"soft", "", "", Colour::ink, &FigureLook::is_soft, false},
        {"bare", "", "", Colour::ink, &FigureLook::is_bare, false},
        {"thin", "", "", Colour::ink, &FigureLook::is_thin, false},
        {"thick", "", "", Colour::ink, &FigureLook::is_thick, false},
        {"dashed", "", "", Colour::ink, &FigureLook::is_dashed, false},
        {"arrow", "", "", Colour::ink, &FigureLook::has_arrow, false},
        {"bold", "", "", Colour::ink, &FigureLook::is_bold, true},
        {"italic", "", "", Colour::ink, &FigureLook::is_italic, true},
        {"small", "", "", Colour::ink, &FigureLook::is_small, true},
    };
    return classes;
}

std::string figure_style() {
    // A browser's own settings for text and lines; currentColor lets a group colour its parts.
    std::string light = "svg{background:#fafaf8;color:#1b1e23;font:14px sans-serif}\n"
                        "line,polyline,polygon,rect,circle,path{fill:none;stroke:currentColor;"
                        "stroke-width:1.5;stroke-linecap:round;stroke-linejoin:round}\n"
                        "text{fill:currentColor}\n"
                        ".filled{fill:currentColor;stroke:none}\n"
                        ".soft{fill:currentColor;fill-opacity:.2}\n"
                        ".bare{stroke:none}\n"
                        ".thin{stroke-width:.75}\n"
                        ".thick{stroke-width:3}\n"
                        ".dashed{stroke-dasharray:4 4;stroke-linecap:butt}\n"
                        ".arrow{marker-end:url(#head)}\n"
                        "marker path{fill:#777;fill:context-stroke;stroke:none}\n"
                        ".bold{font-weight:bold}\n"
                        ".italic{font-style:italic}\n"
                        ".small{font-size:12px}\n"
                        ".sub{baseline-shift:sub;font-size:75%}\n";
    std::string dark = "@media (prefers-color-scheme:dark){\n"
                       "svg{background:#14161a;color:#e4e6ea}\n";
    for (const FigureClass& each : figure_classes()) {
        if (each.flag != nullptr) continue;
        light += fmt::format(".{}{{color:{}}}\n", each.name, each.light);
        dark += fmt::format(".{}{{color:{}}}\n", each.name, each.dark);
    }
    return light + dark + "}\n";
}

bool is_same_style(std::string_view a, std::string_view b) {
    const auto without_blanks = [](std::string_view text) {
        std::string result(text);
        std::erase_if(result,
                      [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; });
        return result;
    };
    return without_blanks(a) == without_blanks(b);
}

} // namespace rasterwalk
