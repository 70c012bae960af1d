#include "tests/ui/screen_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <imgui.h>
#include <imgui_internal.h>

namespace rasterwalk {

namespace {

struct Letter {
    const ImFont* font;
    const ImFontGlyph* glyph;
};

using Letters = std::map<std::pair<float, float>, Letter>;

/// Where the letters of each font are, how many and how large: what letters_of() uses.
using FontsKey = std::vector<std::tuple<const ImFont*, const ImFontGlyph*, int, float>>;

FontsKey key_of(const ImFontAtlas& atlas) {
    FontsKey key;
    for (const ImFont* const font : atlas.Fonts)
        key.emplace_back(font, font->Glyphs.Data, font->Glyphs.Size, font->FontSize);
    return key;
}

/// The letters of all fonts by the corner where they begin in the fonts' picture. They are some
/// ten thousand, so they are kept until the fonts change.
const Letters& letters_of(const ImFontAtlas& atlas) {
    static FontsKey known;
    static Letters letters;
    const FontsKey key = key_of(atlas);
    if (key == known) return letters;
    known = key;
    letters.clear();
    for (const ImFont* const font : atlas.Fonts) {
        for (const ImFontGlyph& glyph : font->Glyphs) {
            if (glyph.Visible != 0) letters[{glyph.U0, glyph.V0}] = {font, &glyph};
        }
    }
    return letters;
}

std::string utf8(unsigned codepoint) {
    char text[5];
    return ImTextCharToUtf8(text, codepoint);
}

/// Joins letters into lines.
class Reader {
  public:
    Reader(std::string window, float widest_gap, std::vector<ScreenText>& lines)
        : window_(std::move(window)), widest_gap_(widest_gap), lines_(lines) {}
    ~Reader() { end_line(); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    /// @param seen the rectangle in which a letter is seen: left, top, right, bottom
    void add(const Letter& letter, const ImDrawVert& low, const ImDrawVert& high,
             const ImVec4& seen) {
        const ImFontGlyph& glyph = *letter.glyph;
        const float scale = (high.pos.x - low.pos.x) / (glyph.X1 - glyph.X0);
        const float pen = low.pos.x - scale * glyph.X0, top = low.pos.y - scale * glyph.Y0;
        const float blank = scale * letter.font->GetCharAdvance(' ');
        const float gap = pen - pen_;
        const bool goes_on =
            std::abs(top - top_) < 1.5f && gap > -1.5f && gap < widest_gap_ * blank;
        if (!goes_on) {
            end_line();
            low_ = {pen, top};
            size_ = scale * letter.font->FontSize;
        }
        if (!goes_on || !is_same(seen, seen_)) {
            end_part();
            seen_ = seen;
            part_ = pen;
        }
        if (goes_on && gap > 0.6f * blank) words_ += ' ';
        words_ += utf8(glyph.Codepoint);
        pen_ = pen + scale * glyph.AdvanceX;
        top_ = top;
    }

  private:
    static bool is_same(const ImVec4& a, const ImVec4& b) {
        return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
    }

    /// Ends a part of a line whose letters are seen within one rectangle: is it cut by the edge?
    void end_part() {
        if (words_.empty() || part_ >= pen_) return;
        // The space above and below letters may be cut off.
        const float above = 0.15f * size_, beside = 1.5f;
        const float top = top_ + above, bottom = top_ + size_ - above;
        const bool is_seen = part_ + beside < seen_.z && pen_ - beside > seen_.x && top < seen_.w &&
                             bottom > seen_.y;
        const bool is_whole = part_ >= seen_.x - beside && pen_ <= seen_.z + beside &&
                              top >= seen_.y && bottom <= seen_.w;
        is_cut_ = is_cut_ || (is_seen && !is_whole);
        part_ = pen_;
    }

    void end_line() {
        end_part();
        if (!words_.empty())
            lines_.push_back({window_, words_, low_, {pen_, top_ + size_}, size_, is_cut_});
        words_.clear();
        is_cut_ = false;
    }

    std::string window_;
    float widest_gap_;
    std::vector<ScreenText>& lines_;
    std::string words_;
    float pen_ = 0.0f, top_ = -1e9f;
    ImVec2 low_;
    float size_ = 0.0f;
    ImVec4 seen_;
    float part_ = 0.0f; ///< where the letters that are seen within it begin
    bool is_cut_ = false;
};

/// The rectangle in which each corner of a list is seen; none for one that is not drawn.
std::vector<ImVec4> seen_of_corners(const ImDrawList& drawn) {
    std::vector<ImVec4> seen(static_cast<std::size_t>(drawn.VtxBuffer.Size), ImVec4());
    for (const ImDrawCmd& command : drawn.CmdBuffer) {
        for (unsigned i = 0; i < command.ElemCount; ++i) {
            const unsigned corner =
                command.VtxOffset + drawn.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
            seen[corner] = command.ClipRect;
        }
    }
    return seen;
}

} // namespace

std::vector<ScreenText> screen_text(float widest_gap) {
    const Letters& letters = letters_of(*ImGui::GetIO().Fonts);
    std::vector<ScreenText> lines;
    const ImDrawData* const data = ImGui::GetDrawData();
    for (int list = 0; data != nullptr && list < data->CmdListsCount; ++list) {
        const ImDrawList& drawn = *data->CmdLists[list];
        const std::vector<ImVec4> seen = seen_of_corners(drawn);
        Reader reader(drawn._OwnerName != nullptr ? drawn._OwnerName : "", widest_gap, lines);
        // A letter is a rectangle, and two of its four corners are enough to identify it.
        for (int i = 0; i + 3 < drawn.VtxBuffer.Size;) {
            const ImDrawVert &low = drawn.VtxBuffer[i], &high = drawn.VtxBuffer[i + 2];
            const auto found = letters.find({low.uv.x, low.uv.y});
            const bool is_letter = found != letters.end() && found->second.glyph->U1 == high.uv.x &&
                                   found->second.glyph->V1 == high.uv.y;
            if (is_letter) reader.add(found->second, low, high, seen[static_cast<std::size_t>(i)]);
            i += is_letter ? 4 : 1;
        }
    }
    return lines;
}

bool shows_words(std::string_view words, std::string_view window) {
    const std::vector<ScreenText> lines = screen_text();
    return std::any_of(lines.begin(), lines.end(), [&](const ScreenText& line) {
        return line.window.find(window) != line.window.npos &&
               line.words.find(words) != line.words.npos;
    });
}

std::string words_in(std::string_view window) {
    std::string words;
    for (const ScreenText& line : screen_text()) {
        if (line.window.find(window) != line.window.npos) words += line.words + " ";
    }
    return words;
}

} // namespace rasterwalk
