#include "ui/widgets/style.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "explain/vectors.h"

namespace rasterwalk {

namespace {

ImVec4 hex(unsigned rgb) {
    return {static_cast<float>((rgb >> 16) & 0xFF) / 255.0f,
            static_cast<float>((rgb >> 8) & 0xFF) / 255.0f, static_cast<float>(rgb & 0xFF) / 255.0f,
            1.0f};
}

const Palette dark_palette{.ground = hex(0x14161A),
                           .bar = hex(0x1A1D23),
                           .card = hex(0x1C2027),
                           .canvas = hex(0x0B0C0F),
                           .line = hex(0x2C3038),
                           .button = hex(0x262B34),
                           .button_hovered = hex(0x333A46),
                           .accent = hex(0x2A6C9E),
                           .accent_text = hex(0xFFFFFF),
                           .text = hex(0xE4E6EA),
                           .dim = hex(0x969CA8),
                           .link = hex(0x6FBFF0),
                           .row_lit = hex(0x20303D),
                           .chosen = hex(0x2B3A49),
                           .changed = hex(0xE69F00)};

const Palette light_palette{.ground = hex(0xFAFAF8),
                            .bar = hex(0xEFEFEC),
                            .card = hex(0xF0F2F4),
                            .canvas = hex(0xD9DBDE),
                            .line = hex(0xCDD0D5),
                            .button = hex(0xE2E5E9),
                            .button_hovered = hex(0xD3D8DE),
                            .accent = hex(0x1F659A),
                            .accent_text = hex(0xFFFFFF),
                            .text = hex(0x1B1E23),
                            .dim = hex(0x5A616B),
                            .link = hex(0x0A5C94),
                            .row_lit = hex(0xD9E9F5),
                            .chosen = hex(0xC9DDEE),
                            .changed = hex(0x8A5600)};

} // namespace

const Palette& palette(Theme theme) {
    return theme == Theme::dark ? dark_palette : light_palette;
}

ImVec4 colour_of(Meaning meaning, Theme theme) {
    constexpr std::size_t count = static_cast<std::size_t>(Meaning::fail) + 1;
    static const std::array<ImVec4, count> dark{
        hex(0xE69F00), hex(0x00B583), hex(0xD98BB5), hex(0x00FCFC), hex(0xA854FC),
        hex(0x908400), hex(0x60F078), hex(0xB4C0FC), hex(0x00909C), hex(0xF0E442),
        hex(0x4C9CD9), hex(0xFFFFFF), hex(0x56B4E9), hex(0xF0722B)};
    static const std::array<ImVec4, count> light{
        hex(0x8A5C00), hex(0x00704F), hex(0x9A4A76), hex(0x6000FC), hex(0x48186C),
        hex(0xC018D8), hex(0x483000), hex(0x0000B4), hex(0x900000), hex(0x706800),
        hex(0x005A8F), hex(0x000000), hex(0x0A6AA8), hex(0xA84200)};
    return (theme == Theme::dark ? dark : light)[static_cast<std::size_t>(meaning)];
}

Meaning edge_meaning(int edge) {
    static_assert(static_cast<int>(Meaning::edge_9) == edge_colour_count - 1);
    return static_cast<Meaning>(std::max(edge, 0) % edge_colour_count);
}

Meaning vector_meaning(VectorName name) {
    switch (name) {
    case VectorName::normal:
    case VectorName::unbent:
        return Meaning::edge_3;
    case VectorName::to_lamp:
        return Meaning::left_end;
    case VectorName::to_eye:
    case VectorName::v:
        return Meaning::pass;
    case VectorName::half:
        return Meaning::fail;
    case VectorName::tangent:
    case VectorName::u:
        return Meaning::edge_1;
    case VectorName::bitangent:
        return Meaning::edge_2;
    case VectorName::from_eye:
        return Meaning::current;
    }
    return Meaning::current;
}

ImU32 packed(const ImVec4& colour, float opacity) {
    return ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, colour.w * opacity});
}

bool has_dark_ink(const glm::vec<3, std::uint8_t>& ground) {
    const auto linear = [](std::uint8_t byte) {
        const float share = static_cast<float>(byte) / 255.0f;
        return share <= 0.04045f ? share / 12.92f : std::pow((share + 0.055f) / 1.055f, 2.4f);
    };
    const float luminance =
        0.2126f * linear(ground.r) + 0.7152f * linear(ground.g) + 0.0722f * linear(ground.b);
    // At this luminance black and white have the same contrast, 4.58 : 1.
    const float even = std::sqrt(1.05f * 0.05f) - 0.05f;
    return luminance > even;
}

void apply_style(const UiOptions& options) {
    const Palette& p = palette(options.theme);
    ImGuiStyle style;
    if (options.theme == Theme::dark) {
        ImGui::StyleColorsDark(&style);
    } else {
        ImGui::StyleColorsLight(&style);
    }
    style.WindowPadding = {14.0f, 12.0f};
    style.WindowBorderSize = 0.0f;
    style.WindowRounding = 0.0f;
    style.ChildBorderSize = 0.0f;
    style.PopupRounding = 6.0f;
    style.FrameRounding = 4.0f;
    style.FramePadding = {10.0f, 5.0f};
    style.ItemSpacing = {8.0f, 6.0f};
    style.ItemInnerSpacing = {6.0f, 4.0f};
    style.CellPadding = {6.0f, 2.5f};
    style.ScrollbarSize = 12.0f;
    style.ScrollbarRounding = 6.0f;
    style.GrabMinSize = 12.0f;
    style.GrabRounding = 4.0f;
    style.TabRounding = 4.0f;
    style.ScaleAllSizes(options.text_scale);
    style.WindowMinSize = {1.0f, 1.0f};

    const auto set = [&](ImGuiCol index, const ImVec4& colour) { style.Colors[index] = colour; };
    set(ImGuiCol_Text, p.text);
    set(ImGuiCol_TextDisabled, p.dim);
    set(ImGuiCol_WindowBg, p.ground);
    set(ImGuiCol_PopupBg, p.card);
    set(ImGuiCol_MenuBarBg, p.bar);
    set(ImGuiCol_Border, p.line);
    set(ImGuiCol_Separator, p.line);
    set(ImGuiCol_Button, p.button);
    set(ImGuiCol_ButtonHovered, p.button_hovered);
    set(ImGuiCol_ButtonActive, p.accent);
    set(ImGuiCol_FrameBg, p.button);
    set(ImGuiCol_FrameBgHovered, p.button_hovered);
    set(ImGuiCol_FrameBgActive, p.button_hovered);
    set(ImGuiCol_Header, p.row_lit);
    set(ImGuiCol_HeaderHovered, p.button_hovered);
    set(ImGuiCol_HeaderActive, p.accent);
    set(ImGuiCol_CheckMark, p.link);
    set(ImGuiCol_SliderGrab, p.accent);
    set(ImGuiCol_SliderGrabActive, p.link);
    set(ImGuiCol_ScrollbarBg, ImVec4(0, 0, 0, 0));
    set(ImGuiCol_ScrollbarGrab, p.button);
    set(ImGuiCol_ScrollbarGrabHovered, p.button_hovered);
    set(ImGuiCol_TableHeaderBg, p.ground);
    set(ImGuiCol_TableBorderStrong, p.line);
    set(ImGuiCol_TableBorderLight, p.line);
    ImVec4 selected = p.link;
    selected.w = 0.35f;
    set(ImGuiCol_TextSelectedBg, selected);
    set(ImGuiCol_ModalWindowDimBg, ImVec4(0.0f, 0.0f, 0.0f, 0.45f));
    set(ImGuiCol_NavHighlight, p.link);
    ImGui::GetStyle() = style;
}

} // namespace rasterwalk
