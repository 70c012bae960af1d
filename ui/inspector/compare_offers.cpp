#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "picture/thumbnail.h"
#include "pipeline/work.h"
#include "ui/actions/compare.h"
#include "ui/actions/held_keys.h"
#include "ui/inspector/compare_parts.h"
#include "ui/ui.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Design pixels.
constexpr float largest_picture = 132.0f, least_picture = 56.0f, card_gap = 8.0f,
                offer_padding = 8.0f;

constexpr int largest_side = 300; ///< of what is drawn, screen pixels

/// Run B of a pair as it would be drawn.
Settings offered(const ComparePair& pair, const Settings& a) {
    return offered_settings(pair, at_step_of(pair, a));
}

bool is_being_moved(const Ui& ui) {
    return ImGui::IsAnyItemActive() || ImGui::IsAnyMouseDown() || is_moving_by_key(ui);
}

/// Brings the pictures up to date, unless something is being moved: then the next frame at rest
/// does.
void renew(Ui& ui, int side) {
    OfferPictures& offers = ui.compare.offers;
    const std::shared_ptr<const Scene>& scene = ui.session.scene;
    const Settings& a = ui.session.a.settings;
    side = std::clamp(side, 1, largest_side);
    const bool is_same = offers.scene == scene && offers.side == side && offers.settings == a;
    if (is_same || (offers.settings && is_being_moved(ui))) return;
    offers.scene = scene;
    offers.settings = a;
    offers.side = side;
    const auto pairs = compare_pairs();
    offers.is_drawn = thumbnail_work(*scene, at_step_of(pairs.front(), a), side) *
                          static_cast<double>(pairs.size()) <=
                      frame_limit.at_once;
    if (!offers.is_drawn) return;
    offers.textures.resize(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Image image = thumbnail(*scene, offered(pairs[i], a), side);
        PictureTexture& texture = offers.textures[i];
        texture.id = ui.host.textures->upload(texture.id, image);
        texture.size = {static_cast<float>(image.width), static_cast<float>(image.height)};
    }
}

/// Sizes on a card, screen pixels.
struct CardSize {
    float width, picture, height;
};

/// No row of cards is cut off by the lower edge. One that fills more than half of the page is shown
/// there once half a page of it is visible: that has to do.
void clip_card_to_lines(float top, float bottom) {
    clip_range_to_lines(top, bottom);
    keep_beginning(top, std::min(bottom, top + 0.5f * page_room()));
}

/// Returns true if it is pressed.
bool draw_offer(Ui& ui, const ComparePair& pair, std::size_t index, ImVec2 low,
                const CardSize& card) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale, pad = offer_padding * u;
    const std::string name = std::string("compare.tab.").append(pair.name);
    const PairMethod& method = offer_of(pair, ui.session.a.settings);
    ImGui::SetCursorScreenPos(low);
    const bool is_pressed = ImGui::InvisibleButton(name.c_str(), {card.width, card.height});
    const bool is_hovered = ImGui::IsItemHovered();
    register_widget(ui, name, tooltip_of_pair(ui.session, pair, false), method.title);
    const ImVec2 high{low.x + card.width, low.y + card.height};
    clip_card_to_lines(low.y, high.y);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(low, high, packed(is_hovered ? p.button_hovered : p.card), 4.0f * u);
    const PictureTexture& texture = ui.compare.offers.textures[index];
    // A scene of a few pixels is shown in whole multiples.
    float scale = card.picture / std::max(texture.size.x, texture.size.y);
    if (scale >= 1.0f) scale = std::floor(scale);
    const ImVec2 shown{scale * texture.size.x, scale * texture.size.y};
    const ImVec2 at{std::round(low.x + 0.5f * (card.width - shown.x)),
                    std::round(low.y + pad + 0.5f * (card.picture - shown.y))};
    list->AddImage(texture.id, at, {at.x + shown.x, at.y + shown.y});
    float y = low.y + card.picture + 1.6f * pad;
    ImGui::PushFont(ui.fonts.small);
    const float room = card.width - 2.0f * pad;
    const auto write = [&](std::string_view text, const ImVec4& colour) {
        const std::string lines = broken_into_lines(text, room);
        list->AddText({low.x + pad, y}, packed(colour), lines.c_str());
        const float line = ImGui::GetFontSize(), bottom = y + ImGui::CalcTextSize(lines.c_str()).y;
        for (; y + 0.5f * line < bottom; y += line)
            clip_range_to_lines(y, y + line);
    };
    write(method.title, p.text);
    y += std::round(0.3f * ImGui::GetFontSize());
    write(method.words, p.dim);
    ImGui::PopFont();
    return is_pressed;
}

/// The most lines of the small font that the title and the words of a pair take.
int lines_of_words(const Ui& ui, float room) {
    std::ptrdiff_t lines = 2;
    for (const ComparePair& pair : compare_pairs()) {
        const PairMethod& method = offer_of(pair, ui.session.a.settings);
        const std::string text =
            broken_into_lines(method.title, room) + "\n" + broken_into_lines(method.words, room);
        lines = std::max(lines, 1 + std::count(text.begin(), text.end(), '\n'));
    }
    return static_cast<int>(lines);
}

CardSize card_size(const Ui& ui, float width) {
    const float u = ui.options.text_scale, pad = offer_padding * u;
    CardSize card{};
    card.width = width;
    ImGui::PushFont(ui.fonts.small);
    const float line = std::round(1.3f * ImGui::GetFontSize());
    const float words =
        2.2f * pad + 0.3f * ImGui::GetFontSize() +
        static_cast<float>(lines_of_words(ui, width - 2.0f * pad)) * ImGui::GetTextLineHeight();
    // All cards are seen whole, or in a low panel the first row of them.
    const float room = ImGui::GetContentRegionAvail().y - line;
    const float of_all = 0.5f * (room - card_gap * u) - words;
    const float whole = of_all >= least_picture * u ? of_all : room - words;
    ImGui::PopFont();
    const float largest = std::min(width - 2.0f * pad, largest_picture * u);
    card.picture = std::round(std::min(largest, std::max(whole, least_picture * u)));
    card.height = std::round(card.picture + words);
    return card;
}

} // namespace

std::string tooltip_of_pair(const Session& session, const ComparePair& pair, bool is_shown) {
    const Settings& a = session.a.settings;
    const PairMethod& method = offer_of(pair, a);
    std::string text("Compares the picture as it is (run A) with ");
    text.append(method.title).append(" (run B).\n").append(method.words);
    if (!(at_step_of(pair, a) == a))
        text.append("\nThe difference does not show at this stage, so both runs go to one where it "
                    "does.");
    return is_shown ? text.append("\nClick again to go back to one run.") : text;
}

void draw_offers(Ui& ui) {
    const float u = ui.options.text_scale;
    const float gap = std::round(card_gap * u);
    const float room = ImGui::GetContentRegionAvail().x;
    const CardSize card = card_size(ui, std::floor(0.5f * (room - gap)));
    if (card.picture >= 1.0f) renew(ui, static_cast<int>(card.picture));
    if (card.picture < 1.0f || !ui.compare.offers.is_drawn) {
        draw_pairs(ui);
        return;
    }
    text_in(palette(ui.options.theme).dim, "Compare the picture as it is with", ui.fonts.small);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const auto pairs = compare_pairs();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const std::size_t above = i / 2;
        const auto column = static_cast<float>(i % 2), line = static_cast<float>(above);
        const ImVec2 low{start.x + column * (card.width + gap),
                         start.y + line * (card.height + gap)};
        if (draw_offer(ui, pairs[i], i, low, card)) begin_pair(ui, pairs[i]);
    }
}

void draw_pairs(Ui& ui) {
    const ComparePair* const offered_pair = shown_pair(ui.session);
    ImGui::PushFont(ui.fonts.small);
    text_in(palette(ui.options.theme).dim, "Compare the picture as it is with");
    std::vector<std::string> labels;
    std::vector<float> widths;
    for (const ComparePair& pair : compare_pairs()) {
        labels.emplace_back(offer_of(pair, ui.session.a.settings).title);
        widths.push_back(button_width(labels.back()));
    }
    const float gap = 4.0f * ui.options.text_scale;
    const std::vector<FlowPlace> places = flow(widths, gap, ImGui::GetContentRegionAvail().x);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetFrameHeight() + gap;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const ComparePair& pair = compare_pairs()[i];
        ImGui::SetCursorScreenPos(
            {start.x + places[i].x, start.y + static_cast<float>(places[i].line) * line});
        const bool is_pressed = button(ui, std::string("compare.tab.").append(pair.name), labels[i],
                                       &pair == offered_pair ? Look::chosen : Look::plain,
                                       tooltip_of_pair(ui.session, pair, &pair == offered_pair));
        if (is_pressed) {
            if (&pair == offered_pair) {
                end_comparison(ui.session);
            } else {
                begin_pair(ui, pair);
            }
        }
    }
    ImGui::PopFont();
}

} // namespace rasterwalk
