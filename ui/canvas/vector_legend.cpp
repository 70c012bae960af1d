#include "ui/canvas/vector_legend.h"

#include <fmt/format.h>

#include "base/element_names.h"
#include "ui/canvas/vector_marks.h"
#include "ui/ui.h"
#include "ui/widgets/arrows.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Between a letter and its words, and between entries, design pixels.
constexpr float letter_gap = 5.0f, entry_gap = 18.0f;

/// Calls place(entry, x, row) for each entry, which wrap like words.
template <class Place>
std::size_t wrap(const std::vector<VectorEntry>& entries, float width, const Place& place) {
    float x = 0.0f;
    std::size_t row = 0;
    for (const VectorEntry& entry : entries) {
        if (x > 0.0f && x + entry.width > width) {
            x = 0.0f;
            ++row;
        }
        place(entry, x, row);
        x += entry.width;
    }
    return entries.empty() ? 0 : row + 1;
}

} // namespace

std::vector<VectorEntry> vector_entries(const Ui& ui) {
    const std::optional<VectorReport>& report = ui.results.a.inspected.vectors;
    if (!report) return {};
    const float u = ui.options.text_scale;
    const SceneSpace space = ui.results.a.frame.scene->space;
    std::vector<VectorEntry> entries;
    const auto add = [&](VectorName name, const std::string& symbol, std::string words) {
        const float width = text_width(ui.fonts.small, symbol) + letter_gap * u +
                            text_width(ui.fonts.small, words) + entry_gap * u;
        entries.push_back({name, symbol, std::move(words), width});
    };
    for (const ShownVector& vector : report->vectors) {
        const VectorWords words = vector_words(vector.name);
        add(vector.name, std::string(words.symbol),
            fmt::format("{}, {}", words.title, length_words(vector, space)));
    }
    return entries;
}

std::string vector_subject(const Ui& ui) {
    const std::optional<VectorReport>& report = ui.results.a.inspected.vectors;
    if (!report) return "no triangle is selected";
    if (!report->pixel) return "of " + triangle_name(report->triangle);
    return "at the picked pixel";
}

std::string tooltip_lines(const std::vector<VectorEntry>& entries) {
    std::string lines;
    for (const VectorEntry& entry : entries)
        lines += fmt::format("\n{}: {}", entry.symbol, entry.words);
    return lines;
}

std::size_t vector_rows(const std::vector<VectorEntry>& entries, float width) {
    return wrap(entries, width, [](const VectorEntry&, float, std::size_t) {});
}

void draw_vector_entries(const Ui& ui, const std::vector<VectorEntry>& entries, float width,
                         ImVec2 at, float line) {
    const Palette& p = palette(ui.options.theme);
    wrap(entries, width, [&](const VectorEntry& entry, float x, std::size_t row) {
        ImGui::SetCursorScreenPos({at.x + x, at.y + line * static_cast<float>(row)});
        text_in(vector_colour(entry.name, ui.options.theme), entry.symbol);
        ImGui::SameLine(0.0f, letter_gap * ui.options.text_scale);
        text_in(p.text, entry.words);
    });
}

void draw_vector_swatch(const Ui& ui, ImDrawList* list, ImVec2 at, ImVec2 size) {
    const float border = 0.2f * size.y, u = 0.5f * ui.options.text_scale;
    const ImVec2 start{at.x + 0.25f * size.x, at.y + size.y - border};
    const auto draw = [&](VectorName name, ImVec2 tip) {
        draw_arrow(list, u, start, tip, {packed(vector_colour(name, Theme::dark)), 0});
    };
    draw(VectorName::u, {at.x + size.x - border, start.y});
    draw(VectorName::v, {start.x, at.y + border});
}

} // namespace rasterwalk
