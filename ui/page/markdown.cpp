#include "ui/page/markdown.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "ui/page/figure_view.h"
#include "ui/page/markdown_layout.h"
#include "ui/ui.h"
#include "ui/widgets/coloured_code.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/pictures.h"
#include "ui/widgets/style.h"
#include "ui/widgets/vector_letters.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

/// What a layout depends on besides the text.
struct PageMeasure {
    float width = 0.0f;
    float unit = 0.0f;
    const ImFont* font = nullptr;
    float font_size = 0.0f;
    float figure_height = 0.0f; ///< the most for a figure

    friend bool operator==(const PageMeasure&, const PageMeasure&) = default;
};

struct MarkdownPage {
    MarkdownPage() = default;
    // The layout points into the document.
    MarkdownPage(const MarkdownPage&) = delete;
    MarkdownPage& operator=(const MarkdownPage&) = delete;

    MarkdownContent content;
    std::string folder; ///< of its pictures; empty: the program's own lessons
    MarkdownDocument document;
    std::optional<PageMeasure> measure; ///< of the layout; none before the first
    PageLayout layout;
};

namespace {

/// ImGui's draw lists count their corners in 16 bits; beyond this many letters a frame, or this
/// many shapes, nothing more is drawn. No window has room for that many.
constexpr std::size_t most_letters = 12'000;
constexpr int most_shapes = 400;

/// Links that are entered in Ui::widgets even while they are scrolled away.
constexpr int most_hidden_links = 500;

/// A figure takes at most this share of the window's height, so that text is seen with it; or else
/// the room that the strip has.
constexpr float highest_figure = 0.4f;

float figure_height(const Ui& ui) {
    const float room = ui.lesson.strip.figure_height;
    return room > 0.0f ? room : highest_figure * ImGui::GetIO().DisplaySize.y;
}

/// Size of a picture or a figure, in design pixels.
ImVec2 size_on_page(const Ui& ui, const PictureName& name) {
    const ImVec2 size = picture_size(*ui.pictures, name);
    const float most = figure_height(ui) / ui.options.text_scale;
    if (shown_figure(*ui.pictures, name) == nullptr || size.y <= most) return size;
    return {size.x * most / size.y, most};
}

/// Brings the page up to date with content, width and fonts.
void prepare(Ui& ui, MarkdownPage& page, const MarkdownContent& content, float width,
             const std::string& folder) {
    const PageMeasure measure{width, ui.options.text_scale, ui.fonts.text, ui.fonts.text->FontSize,
                              ImGui::GetIO().DisplaySize.y};
    const bool is_new = !page.measure || page.content != content || page.folder != folder;
    if (!is_new && page.measure == measure) return;
    if (is_new) {
        page.layout = {};
        page.content = content;
        page.folder = folder;
        const auto* const text = std::get_if<std::string>(&content);
        page.document =
            text != nullptr ? parse_markdown(*text) : std::get<MarkdownDocument>(content);
        if (!page.document.fault.empty()) {
            MarkdownBlock& block = page.document.blocks.emplace_back();
            block.runs.push_back({page.document.fault});
        }
    }
    if (!ui.pictures) ui.pictures = std::make_shared<ImageCache>();
    page.layout = lay_out(page.document, ui.fonts, ui.options.text_scale, width,
                          [&](const std::string& target) {
                              return size_on_page(ui, {page.folder, target});
                          });
    page.measure = measure;
}

ImVec4 colour_of_tint(PageTint tint, Theme theme) {
    switch (tint) {
    case PageTint::text:
        return palette(theme).text;
    case PageTint::dim:
        return palette(theme).dim;
    case PageTint::link:
        return palette(theme).link;
    case PageTint::task:
        return palette(theme).changed;
    case PageTint::mistake:
        return colour_of(Meaning::fail, theme);
    }
    return palette(theme).text;
}

/// The part of the page that can be seen, screen pixels.
struct Sight {
    ImVec2 origin;
    float top, bottom;
    bool holds(float low, float high) const {
        return origin.y + high >= top && origin.y + low <= bottom;
    }
};

/// The footnote that the pointer rests on.
void show_note(const Ui& ui, const MarkdownPage& page, std::string_view target) {
    const auto number = static_cast<std::size_t>(std::atoi(target.substr(5).data()));
    if (!ImGui::IsItemHovered() || number < 1 || number > page.document.notes.size()) return;
    const std::string& note = page.document.notes[number - 1];
    draw_tooltip(ui, note);
}

/// An invisible button over every piece of every link.
MarkdownEvents press_links(Ui& ui, const MarkdownPage& page, const Sight& sight,
                           std::string_view prefix) {
    MarkdownEvents events;
    int hidden = 0, last = -1;
    int number = 0;
    for (const PagePiece& piece : page.layout.pieces) {
        if (piece.link < 0) continue;
        const float height = font_of(ui.fonts, piece.font)->FontSize;
        const bool visible = sight.holds(piece.at.y, piece.at.y + height);
        if (!visible && ++hidden > most_hidden_links) continue;
        ImGui::SetCursorScreenPos(
            {sight.origin.x + piece.at.x, sight.origin.y + piece.at.y - 2.0f});
        ImGui::PushID(number++);
        const bool pressed =
            ImGui::InvisibleButton("link", {std::max(piece.width, 1.0f), height + 4.0f});
        ImGui::PopID();
        if (ImGui::IsItemHovered()) {
            events.hovered = piece.link;
            ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        }
        const std::string_view target = page.document.links[static_cast<std::size_t>(piece.link)];
        if (target.starts_with("note:")) {
            show_note(ui, page, target);
        } else if (pressed) {
            events.followed = piece.link;
        }
        // A link over two lines has its name on the first.
        if (piece.link != last)
            register_widget(ui, std::string(prefix) + std::to_string(piece.link));
        last = piece.link;
    }
    return events;
}

void draw_shapes(const Ui& ui, ImDrawList* list, const MarkdownPage& page, const Sight& sight) {
    const Palette& p = palette(ui.options.theme);
    const float rounding = 5.0f * ui.options.text_scale;
    int drawn = 0;
    for (const PageShape& shape : page.layout.shapes) {
        if (!sight.holds(shape.low.y, shape.high.y) || ++drawn > most_shapes) continue;
        const ImVec2 low{sight.origin.x + shape.low.x, sight.origin.y + shape.low.y};
        const ImVec2 high{sight.origin.x + shape.high.x, sight.origin.y + shape.high.y};
        switch (shape.kind) {
        case PageShape::Kind::card:
            list->AddRectFilled(low, high, packed(p.card), rounding);
            break;
        case PageShape::Kind::bar:
            list->AddRectFilled(low, high, packed(colour_of_tint(shape.tint, ui.options.theme)),
                                rounding, ImDrawFlags_RoundCornersLeft);
            break;
        case PageShape::Kind::line:
            list->AddRectFilled(low, high, packed(p.line));
            break;
        case PageShape::Kind::stroke:
            list->AddRectFilled(low, high, packed(colour_of_tint(shape.tint, ui.options.theme)));
            break;
        case PageShape::Kind::bullet:
            list->AddCircleFilled({0.5f * (low.x + high.x), 0.5f * (low.y + high.y)},
                                  0.5f * (high.x - low.x), packed(p.dim));
            break;
        }
    }
}

void draw_pictures(Ui& ui, ImDrawList* list, const MarkdownPage& page, const Sight& sight) {
    int budget = most_figure_pieces;
    for (const PagePicture& picture : page.layout.pictures) {
        if (!sight.holds(picture.low.y, picture.high.y)) continue;
        const ImVec2 low{std::floor(sight.origin.x + picture.low.x),
                         std::floor(sight.origin.y + picture.low.y)};
        const ImVec2 size{picture.high.x - picture.low.x, picture.high.y - picture.low.y};
        const PictureName name{page.folder, std::string(picture.target)};
        const ImVec2 high{low.x + size.x, low.y + size.y};
        if (const std::shared_ptr<const Figure> figure = shown_figure(*ui.pictures, name)) {
            show_figure(ui, *figure, low, high, budget);
            continue;
        }
        ImTextureID texture = picture_texture(ui, name, static_cast<int>(size.x));
        if (texture != ImTextureID{}) list->AddImage(texture, low, high);
        list->AddRect(low, high, packed(palette(ui.options.theme).line));
    }
}

/// The lines that the edges of the window must not cut.
void clip_page_to_lines(Ui& ui, const MarkdownPage& page, const Sight& sight) {
    // Also counts the edge of the window's full room, if it is lower now or scrolled.
    const float edge = sight.top + page_room() - ImGui::GetScrollY();
    const Sight at_edge{sight.origin, edge, edge};
    const auto is_near = [&](float low, float high) {
        return sight.holds(low, high) || at_edge.holds(low, high);
    };
    const auto keep = [&](float low, float high) {
        if (is_near(low, high)) clip_range_to_lines(sight.origin.y + low, sight.origin.y + high);
    };
    for (const PagePicture& picture : page.layout.pictures)
        keep(picture.low.y, picture.high.y);
    for (const PageLine& line : page.layout.lines)
        keep(line.top, line.bottom);
    const float u = ui.options.text_scale;
    const std::vector<PagePiece>& pieces = page.layout.pieces;
    for (const PageShape& shape : page.layout.shapes) {
        if (shape.kind != PageShape::Kind::card || !is_near(shape.low.y, shape.high.y)) continue;
        // For a box, at least the first line that is not a heading in small letters.
        const auto first = std::find_if(pieces.begin(), pieces.end(), [&](const PagePiece& piece) {
            return piece.at.y >= shape.low.y && piece.font != PageFont::small;
        });
        if (first == pieces.end()) continue;
        const float high = first->at.y + font_of(ui.fonts, first->font)->FontSize + 2.0f * u;
        keep_beginning(sight.origin.y + shape.low.y - 1.0f, sight.origin.y + high);
    }
}

/// Names in code have the colours that they have in the table and in the picture.
void draw_piece_text(ImDrawList* list, const PagePiece& piece, ImFont* font, ImVec2 at,
                     const ImVec4& colour, Theme theme) {
    const auto draw = [&](std::string_view text, const ImVec4& ink) {
        list->AddText(font, font->FontSize, at, packed(ink), text.data(),
                      text.data() + text.size());
    };
    if (piece.font != PageFont::mono || piece.link >= 0) {
        draw(piece.text, colour);
        return;
    }
    for (const ColouredWords& words : coloured_code(piece.text, theme, colour, colour)) {
        draw(words.text, words.ink);
        at.x += text_width(font, words.text);
    }
}

void draw_pieces(const Ui& ui, ImDrawList* list, const MarkdownPage& page, const Sight& sight,
                 int hovered, bool has_vectors) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    std::size_t letters = 0;
    for (const PagePiece& piece : page.layout.pieces) {
        ImFont* const font = font_of(ui.fonts, piece.font);
        if (!sight.holds(piece.at.y, piece.at.y + font->FontSize)) continue;
        // ImGui would search for the end of a text without data: an empty line of code.
        if (piece.text.empty()) continue;
        letters += piece.text.size();
        if (letters > most_letters) break;
        const ImVec2 at{std::floor(sight.origin.x + piece.at.x),
                        std::floor(sight.origin.y + piece.at.y)};
        const ImVec4 plain = colour_of_tint(piece.tint, ui.options.theme);
        const ImVec4 colour = has_vectors && piece.link < 0
                                  ? vector_letter_colour(ui, piece.vector).value_or(plain)
                                  : plain;
        if (piece.is_code) {
            const ImVec2 low{at.x - 3.0f * u, at.y - 1.0f * u};
            const ImVec2 high{at.x + piece.width + 3.0f * u, at.y + font->FontSize + 2.0f * u};
            list->AddRectFilled(low, high, packed(p.button), 3.0f * u);
        }
        draw_piece_text(list, piece, font, at, colour, ui.options.theme);
        if (piece.link < 0) continue;
        const float y = std::round(at.y + font->Ascent + 2.5f * u);
        const float thickness =
            std::max(std::round(u), 1.0f) * (piece.link == hovered ? 2.0f : 1.0f);
        list->AddRectFilled({at.x, y}, {at.x + piece.width, y + thickness},
                            packed(colour, piece.link == hovered ? 1.0f : 0.6f));
    }
}

} // namespace

MarkdownEvents draw_markdown(Ui& ui, std::shared_ptr<MarkdownPage>& page,
                             const MarkdownContent& content, float width, std::string_view prefix,
                             const std::string& folder, bool has_vectors) {
    if (!page) page = std::make_shared<MarkdownPage>();
    prepare(ui, *page, content, width, folder);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const Sight sight{origin, list->GetClipRectMin().y, list->GetClipRectMax().y};
    const MarkdownEvents events = press_links(ui, *page, sight, prefix);
    draw_shapes(ui, list, *page, sight);
    draw_pictures(ui, list, *page, sight);
    draw_pieces(ui, list, *page, sight, events.hovered, has_vectors);
    clip_page_to_lines(ui, *page, sight);
    ImGui::SetCursorScreenPos(origin);
    ImGui::Dummy({width, page->layout.height});
    return events;
}

float markdown_height(Ui& ui, const MarkdownContent& content, float width) {
    MarkdownPage page;
    prepare(ui, page, content, width, {});
    return page.layout.height;
}

const MarkdownDocument& document_of(const MarkdownPage& page) {
    return page.document;
}

} // namespace rasterwalk
