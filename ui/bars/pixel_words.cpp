#include "ui/bars/pixel_words.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "session/depth_view.h"
#include "ui/actions/compare.h"
#include "ui/canvas/picture_view.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The pixel's colours in both runs, and how much they differ.
void add_colours_of_both(std::vector<std::string>& facts, const Ui& ui, std::size_t at) {
    const auto colour = [&](const char* run, const Framebuffer& picture) {
        const glm::vec3& c = picture.colour[at];
        return fmt::format("{} {:.3f} {:.3f} {:.3f}", run, c.r, c.g, c.b);
    };
    const float difference = ui.results.comparison.difference_values[at];
    facts.push_back(colour("A", *ui.results.a.framebuffer));
    facts.push_back(colour("B", *ui.results.b->framebuffer));
    facts.push_back(fmt::format("B − A {}{}", difference > 0.0f ? "+" : "",
                                fixed(static_cast<double>(difference), 4)));
}

/// Everything known about the pixel under the pointer, or else the picked one; the first facts
/// matter most.
std::vector<std::string> pixel_facts(const Ui& ui) {
    const std::optional<glm::ivec2> pixel = pixel_in_focus(ui);
    if (!pixel) return {"point at a pixel"};
    const Framebuffer& framebuffer = *ui.results.a.framebuffer;
    const std::size_t at = framebuffer.at(pixel->x, pixel->y);
    std::vector<std::string> facts{fmt::format("pixel ({}, {})", pixel->x, pixel->y)};
    if (ui.results.b) {
        add_colours_of_both(facts, ui, at);
        return facts;
    }
    const int owner = framebuffer.owner[at];
    if (owner < 0) {
        facts.emplace_back("not drawn");
        return facts;
    }
    const glm::vec3& c = framebuffer.colour[at];
    facts.push_back(fmt::format("colour {:.3f} {:.3f} {:.3f}", c.r, c.g, c.b));
    const auto colour = static_cast<std::ptrdiff_t>(facts.size()) - 1;
    const float depth = stored_depth(framebuffer, pixel->x, pixel->y);
    if (is_depth(depth, framebuffer.rules.depth_kind)) {
        facts.push_back(fmt::format("{} {:.4f}   z {:.4f}", depth_words(ui.results.a.frame).name,
                                    depth, z_of_stored_depth(ui.results.a.frame, depth)));
        // What the picture shows comes first.
        if (ui.session.view == View::depth) std::iter_swap(facts.begin() + colour, facts.end() - 1);
    }
    facts.push_back(triangle_name(owner) + ", " + part_words(*ui.results.a.frame.scene, owner));
    facts.push_back(counted(framebuffer.overdraw[at], "fragment", "fragments"));
    return facts;
}

} // namespace

std::string pixel_words(const Ui& ui, float room) {
    std::string words;
    for (const std::string& fact : pixel_facts(ui)) {
        const std::string longer = words.empty() ? fact : words + "   " + fact;
        if (!words.empty() && text_width(longer) > room) break;
        words = longer;
    }
    return words;
}

} // namespace rasterwalk
