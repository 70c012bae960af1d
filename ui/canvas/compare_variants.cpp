#include "ui/canvas/compare_variants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "ui/actions/compare.h"
#include "ui/canvas/picture_view.h"
#include "ui/ui.h"
#include "ui/widgets/small_pictures.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// In design pixels.
constexpr float largest_height = 170.0f, wished_least = 84.0f, least_height = 44.0f;
constexpr float card_padding = 8.0f, tight_padding = 4.0f, words_width = 92.0f;
constexpr float least_picture = 24.0f;

/// Largest share of a card for its words.
constexpr float largest_words_share = 0.42f;

/// Largest share of the room for picture and row.
constexpr float largest_share = 0.25f;

/// One of the small pictures.
struct Variant {
    CompareView view;
    std::string_view title;         ///< "A"
    std::string_view short_title;   ///< where there is little room
    std::vector<std::string> words; ///< what is different in it, from the longest form to the
                                    ///< shortest
    const Image* image;
    std::uint64_t number; ///< of the image
};

std::array<Variant, 3> variants_of(const Ui& ui) {
    const Results& results = ui.results;
    const ComparisonResults& comparison = results.comparison;
    const PixelDifference& pixels = comparison.pixels;
    const std::int64_t count = pixels.shown > 0 ? pixels.shown : pixels.different;
    const std::string differ =
        count == 0 ? "no pixel" : grouped(count) + (count == 1 ? " pixel" : " pixels");
    const NumberedPicture a = shown_picture(results.a), b = shown_picture(*results.b);
    return {{{CompareView::run_a, "A", "A", run_forms(ui.session, false), &a.image, a.number},
             {CompareView::run_b, "B", "B", run_forms(ui.session, true), &b.image, b.number},
             {CompareView::difference,
              "Difference",
              "B − A",
              {differ, grouped(count)},
              &comparison.difference,
              comparison.difference_number}}};
}

/// Where a small picture and its words are on its card.
struct CardLayout {
    ImVec2 picture; ///< from the card's corner
    float scale;    ///< screen pixels per picture pixel
    ImVec2 words;   ///< from the card's corner
    float room;     ///< for the words
    bool is_above;  ///< the words are one line above the picture; if not, next to it
};

/// @param least_words the width of the words that must not be left out
CardLayout card_layout(const Ui& ui, ImVec2 card, const Image& image, float least_words) {
    const float u = ui.options.text_scale;
    const bool is_tight = least_words > largest_words_share * card.x;
    const float pad = std::round((is_tight ? tight_padding : card_padding) * u);
    const float line = std::round(1.3f * ui.fonts.small->FontSize);
    const ImVec2 size{static_cast<float>(image.width), static_cast<float>(image.height)};
    const auto scale_in = [&](float width, float height) {
        const float scale = std::max(std::min(width / size.x, height / size.y), 1e-4f);
        return scale >= 1.0f ? std::floor(scale) : scale; // all pixels are the same size
    };
    const float above = scale_in(card.x - 2.0f * pad, card.y - line - 2.0f * pad);
    // A picture smaller than this would show nothing.
    const float most_words = std::max(card.x - 3.0f * pad - least_picture * u, 0.0f);
    const float words = std::max(std::min(words_width * u, largest_words_share * card.x),
                                 std::min(std::ceil(least_words), most_words));
    const float beside = scale_in(card.x - words - 3.0f * pad, card.y - 2.0f * pad);
    CardLayout layout{};
    layout.is_above = above >= beside;
    layout.scale = std::max(above, beside);
    const ImVec2 shown{layout.scale * size.x, layout.scale * size.y};
    layout.words = {pad, std::round(0.6f * pad)};
    layout.room = card.x - 2.0f * pad;
    if (layout.is_above) {
        layout.picture = {std::round(0.5f * (card.x - shown.x)),
                          std::round(line + 0.5f * (card.y - line - shown.y))};
        return layout;
    }
    layout.picture = {pad, std::round(0.5f * (card.y - shown.y))};
    layout.words = {std::round(2.0f * pad + shown.x), pad};
    layout.room = card.x - layout.words.x - pad;
    return layout;
}

/// The first form that has room, broken into lines; empty if none has.
std::string lines_that_fit(const std::vector<std::string>& forms, ImVec2 room, float line) {
    std::vector<std::string> low_enough;
    for (const std::string& form : forms) {
        const std::string lines = broken_into_lines(form, room.x);
        const auto count = static_cast<float>(1 + std::count(lines.begin(), lines.end(), '\n'));
        if (count * line <= room.y) low_enough.push_back(lines);
    }
    low_enough.emplace_back();
    return first_fitting(low_enough, room.x);
}

/// The name, and as many of the words as fit: nothing is cut off.
/// @return the words, without line breaks
std::string draw_words(const Ui& ui, ImDrawList* list, const Variant& variant,
                       const CardLayout& layout, ImVec2 low, ImVec2 high) {
    const Palette& p = palette(ui.options.theme);
    const float size = ui.fonts.small->FontSize, line = std::round(1.3f * size);
    const bool has_room = text_width(ui.fonts.bold, variant.title, size) <= layout.room;
    const std::string name(has_room ? variant.title : variant.short_title);
    const ImVec2 at{low.x + layout.words.x, low.y + layout.words.y};
    list->AddText(ui.fonts.bold, size, at, packed(p.text), name.c_str());
    std::string shown;
    ImGui::PushFont(ui.fonts.small);
    if (layout.is_above) {
        const float from = text_width(ui.fonts.bold, name, size) + 8.0f * ui.options.text_scale;
        std::vector<std::string> words = variant.words;
        words.emplace_back(); // or nothing
        shown = first_fitting(words, layout.room - from);
        list->AddText({at.x + from, at.y}, packed(p.dim), shown.c_str());
    } else {
        float y = at.y + line;
        const std::string lines = lines_that_fit(variant.words, {layout.room, high.y - y}, line);
        shown = lines;
        std::replace(shown.begin(), shown.end(), '\n', ' ');
        for (std::size_t from = 0; from < lines.size(); y += line) {
            const std::size_t end = std::min(lines.find('\n', from), lines.size());
            list->AddText({at.x, y}, packed(p.dim), lines.substr(from, end - from).c_str());
            from = end + 1;
        }
    }
    ImGui::PopFont();
    return shown;
}

std::string tooltip_of_variant(const Ui& ui, const Variant& variant) {
    const CompareViewInfo& info = compare_view_list()[static_cast<std::size_t>(variant.view)];
    std::string text(info.menu_title);
    text += ".\n";
    text += variant.view == CompareView::difference
                ? variant.words.front() + " differ in what is drawn so far"
                : run_assignments(ui.session, variant.view == CompareView::run_b);
    return text + "\nClick to enlarge it.";
}

/// The widest single word of all the shortest forms: the small pictures stay equally large.
float least_words(const Ui& ui, const std::array<Variant, 3>& variants) {
    float width = 0.0f;
    for (const Variant& variant : variants) {
        std::istringstream words(variant.words.back());
        for (std::string word; words >> word;)
            width = std::max(width, text_width(ui.fonts.small, word));
    }
    return width;
}

void draw_variant(Ui& ui, std::size_t index, const Variant& variant, float words, ImVec2 low,
                  ImVec2 high) {
    const ImVec2 size{high.x - low.x, high.y - low.y};
    const std::string name = std::string("compare.small.").append(word_of(variant.view));
    if (small_card(ui, name, tooltip_of_variant(ui, variant), low, high))
        ui.session.compare_view = variant.view;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const CardLayout layout = card_layout(ui, size, *variant.image, words);
    PictureTexture& texture = ui.compare.small[index];
    show_small(ui, texture, *variant.image, variant.number, layout.scale);
    list->PushClipRect(low, high, true);
    const ImVec2 at{low.x + layout.picture.x, low.y + layout.picture.y};
    list->AddImage(texture.id, at, {at.x + texture.size.x, at.y + texture.size.y});
    const std::string words_shown = draw_words(ui, list, variant, layout, low, high);
    register_text(ui, name, words_shown);
    list->PopClipRect();
    if (ui.session.compare_view == variant.view) frame_small_card(ui, low, high);
}

} // namespace

bool has_room_for_variants(const Ui& ui, float height) {
    return largest_share * height >= least_height * ui.options.text_scale;
}

float variants_height(const Ui& ui, ImVec2 room) {
    if (!is_comparing(ui)) return 0.0f;
    const float u = ui.options.text_scale;
    const float largest = std::min(largest_share * room.y, largest_height * u);
    if (!has_room_for_variants(ui, room.y)) return 0.0f;
    const float needed = height_at_full_size(ui, room.x);
    // The large picture is made smaller anyway: the row takes its share.
    if (needed > room.y) return std::round(largest);
    // A very low row is better than a large picture that is partly hidden.
    const float left = room.y - needed;
    const float least =
        std::min(largest, (left < least_height * u ? wished_least : least_height) * u);
    return std::floor(std::clamp(left, least, largest));
}

void draw_variants(Ui& ui, const Pane& row) {
    const float gap = std::round(8.0f * ui.options.text_scale);
    const std::array<Variant, 3> variants = variants_of(ui);
    const auto count = static_cast<float>(variants.size());
    const float width = std::floor((row.room().x - (count - 1.0f) * gap) / count);
    if (width < 1.0f) return;
    const float words = least_words(ui, variants);
    for (std::size_t i = 0; i < variants.size(); ++i) {
        const float left = row.low.x + static_cast<float>(i) * (width + gap);
        draw_variant(ui, i, variants[i], words, {left, row.low.y}, {left + width, row.high.y});
    }
}

} // namespace rasterwalk
