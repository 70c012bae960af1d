#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "session/depth_view.h"
#include "session/strip.h"
#include "settings/setting_table.h"
#include "settings/value_words.h"
#include "ui/actions/actions.h"
#include "ui/actions/compare.h"
#include "ui/bars/bars.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// How much the strip says; each form needs less room than the previous one. The last is the
/// narrowest and fits wherever the layout has a strip.
struct Form {
    float padding; ///< around the name of an entry, design pixels
    int few;       ///< entries shown at most, the chosen one and neighbours, with a list of all;
                   ///< 0: all are shown
    bool is_short; ///< the switches are abbreviated
    bool has_scene_word; ///< "scene" before its name
    float scene_width;   ///< of the name at most, design pixels; 0: only the menu has the scenes
};

constexpr Form forms[] = {
    {12.0f, 0, false, true, 340.0f}, {10.0f, 0, false, false, 190.0f},
    {8.0f, 0, true, false, 130.0f},  {7.0f, 0, true, false, 0.0f},
    {8.0f, 3, true, false, 130.0f},  {8.0f, 3, true, false, 0.0f},
    {8.0f, 2, true, false, 0.0f},    {8.0f, 1, true, false, 0.0f},
};

/// What the layout keeps room for, if the window has it, and what a lecture begins with.
constexpr const Form* form_of_three = &forms[5];

/// Gap between two stages, design pixels.
constexpr float chevron_gap = 16.0f;
constexpr float bar_gap = 21.0f;

/// A word at the right of the strip that can be clicked.
struct StripWord {
    std::string name;  ///< of the widget, and of the action that it runs
    std::string quiet; ///< said first, quietly
    std::string loud;  ///< said after it
    std::string help;
    bool chosen = false;
    bool is_unusual = false; ///< `loud` differs from the handout
    std::string widest;      ///< the widest `loud` can be: a click must not shift its neighbours
};

std::string action_of(const StripEntry& entry) {
    return std::string("stage.").append(entry.name);
}

/// The entries that the strip shows.
StripRow shown_entries(const Ui& ui, const Form& form) {
    StripRow entries = usable_entries(ui.session);
    if (form.few == 0) return entries;
    const auto shown = std::find(entries.begin(), entries.end(), &chosen_entry(ui.session));
    const auto chosen = static_cast<std::size_t>(shown - entries.begin());
    const auto most = static_cast<std::size_t>(form.few);
    const std::size_t last_first = std::max(entries.size(), most) - most;
    const std::size_t first = std::min(std::max(chosen, most / 2) - most / 2, last_first);
    StripRow few;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const bool is_near = i >= first && i < first + most;
        const bool is_meant = ui.lesson.pointed_at == action_of(*entries[i]);
        if (is_near || is_meant) few.push_back(entries[i]);
    }
    return few;
}

/// Between two entries, screen pixels.
float gap_of(const Ui& ui, StripJoin join) {
    const float u = ui.options.text_scale;
    switch (join) {
    case StripJoin::begins_group:
        return bar_gap * u;
    case StripJoin::follows:
        return chevron_gap * u;
    case StripJoin::alternative:
        return 0.0f;
    }
    return 0.0f;
}

std::string word_of_perspective(const Settings& settings) {
    switch (settings.interpolation) {
    case Interpolation::perspective:
        return tr("on");
    case Interpolation::affine:
        return tr("off");
    case Interpolation::mixed:
        return tr("mixed");
    case Interpolation::zinv_twice:
    case Interpolation::divided_twice:
        return tr("twice");
    case Interpolation::undivided:
        return tr("half");
    }
    return {};
}

std::string word_of_depth_test(const Settings& settings, const Frame& frame) {
    switch (settings.depth_test) {
    case DepthTest::off:
        return tr("off");
    case DepthTest::inverse_z:
    case DepthTest::or_equal:
    case DepthTest::raced:
        return std::string(depth_words(frame).short_name);
    case DepthTest::reversed:
        // Not its own word, which a depth format has too.
        return choice_words(*find_setting("depth_test"), word_of(DepthTest::reversed));
    default:
        return "z";
    }
}

/// What the word for the depth means, a line of the tooltip.
std::string depth_help(const Frame& frame) {
    const DepthWords& words = depth_words(frame);
    std::string name(words.name);
    if (words.short_name != words.name) name += ", \"" + std::string(words.short_name) + "\"";
    return "\n" + tr("The depth buffer holds {}: {}", name, tr(words.ends));
}

/// Do the switches change anything where this entry is the last one computed?
bool needs_switches(const StripEntry& entry) {
    return entry.group >= StripGroup::visibility;
}

/// The switches, and what begins a comparison. In a lecture only those that it points at.
std::vector<StripWord> strip_words(const Ui& ui, const Form& form, bool has_switches) {
    std::vector<StripWord> words;
    const Settings& settings = ui.session.a.settings;
    if (has_switches) {
        const bool is_hidden = hides_settings(ui.session);
        const auto add = [&](const char* name, const char* title, const std::string& state,
                             bool is_usual, const char* widest) {
            words.push_back({.name = name,
                             .quiet = title,
                             .loud = is_hidden ? "?" : state,
                             .help = tooltip_of(name),
                             .is_unusual = !is_hidden && !is_usual,
                             .widest = widest});
        };
        add("switch.perspective", tr(form.is_short ? "P-corr." : "Perspective-correct"),
            word_of_perspective(settings), settings.interpolation == Interpolation::perspective,
            tr("off"));
        if (hidden_rule(settings) == Hidden::depth_buffer) {
            add("switch.depth_test", tr(form.is_short ? "Depth" : "Depth test"),
                word_of_depth_test(settings, ui.results.a.frame),
                settings.depth_test == DepthTest::inverse_z, "1/z");
            if (!is_hidden) words.back().help += depth_help(ui.results.a.frame);
        } else {
            add("switch.depth_test", form.is_short ? "" : tr("Hidden by"),
                choice_words(*find_setting("hidden"), word_of(settings.hidden)), false, "");
        }
    }
    words.push_back({.name = "switch.compare",
                     .quiet = "",
                     .loud = form.is_short ? "A | B" : tr("Compare"),
                     .help = tooltip_of("switch.compare") +
                             (ui.session.b ? "" : tr("\nNow: {}.", comparison_offered(ui.session))),
                     .chosen = ui.session.b.has_value(),
                     .widest = ""});
    if (ui.options.is_lecture) {
        std::erase_if(words,
                      [&](const StripWord& word) { return word.name != ui.lesson.pointed_at; });
    }
    return words;
}

float word_width(const Ui& ui, const StripWord& word) {
    const float u = ui.options.text_scale;
    const float between = word.quiet.empty() || word.loud.empty() ? 0.0f : 6.0f * u;
    return text_width(word.quiet) + between +
           std::max(text_width(word.loud), text_width(word.widest)) + 16.0f * u;
}

StripWord scene_word(const Ui& ui, const Form& form) {
    const std::string& name = ui.session.scene->name;
    return {.name = "scenes",
            .quiet = form.has_scene_word ? tr("scene") : "",
            .loud = shortened(name.empty() ? tr("unnamed") : name,
                              form.scene_width * ui.options.text_scale) +
                    " ▾",
            .help = tr("The current scene: {}.\nClick to open another one.", name),
            .widest = ""};
}

StripWord stages_word() {
    return {.name = "stages", .quiet = "", .loud = "▾", .help = tr("All stages."), .widest = ""};
}

float segment_width(const Ui& ui, const Form& form, const StripEntry& entry) {
    return text_width(title_of(entry, ui.session, current_language())) +
           2.0f * form.padding * ui.options.text_scale;
}

float entries_width(const Ui& ui, const Form& form, const StripRow& entries) {
    float width = 0.0f;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i > 0) width += gap_of(ui, join_between(*entries[i - 1], *entries[i]));
        width += segment_width(ui, form, *entries[i]);
    }
    return width;
}

/// The widest set of entries that a form shows side by side, whichever is chosen, with the list of
/// the others.
float widest_few(const Ui& ui, const Form& form, const StripRow& all) {
    float widest = entries_width(ui, form, shown_entries(ui, form));
    const auto most = static_cast<std::size_t>(form.few);
    for (std::size_t i = 0; i + most <= std::max(all.size(), most); ++i) {
        const std::size_t end = std::min(i + most, all.size());
        const StripRow few(all.begin() + static_cast<std::ptrdiff_t>(i),
                           all.begin() + static_cast<std::ptrdiff_t>(end));
        widest = std::max(widest, entries_width(ui, form, few));
    }
    return widest + word_width(ui, stages_word());
}

/// What a form needs on one line, screen pixels. Choosing a stage must not change the form: there
/// is room for all that any stage needs.
float form_width(const Ui& ui, const Form& form) {
    const float u = ui.options.text_scale;
    const StripRow all = entries_of_all_steps(ui.session);
    float width = form.few > 0 ? widest_few(ui, form, all) : entries_width(ui, form, all);
    const bool has_switches = std::any_of(
        all.begin(), all.end(), [](const StripEntry* entry) { return needs_switches(*entry); });
    for (const StripWord& word : strip_words(ui, form, has_switches))
        width += word_width(ui, word);
    if (form.scene_width > 0.0f) width += bar_gap * u + word_width(ui, scene_word(ui, form));
    return width + 2.0f * bar_gap * u; // between both ends
}

const Form& fitting_form(const Ui& ui, float room) {
    const Form* const first = ui.options.is_lecture ? form_of_three : std::begin(forms);
    const auto fits = [&](const Form& form) {
        // Both ends come closer before entries are left out.
        const bool may_be_close = &form >= form_of_three;
        const float spare = may_be_close ? 2.0f * bar_gap * ui.options.text_scale : 0.0f;
        return form_width(ui, form) - spare <= room;
    };
    const Form* const found = std::find_if(first, std::end(forms), fits);
    return found == std::end(forms) ? *std::prev(std::end(forms)) : *found;
}

/// Where the strip is, and where things are drawn in it.
struct Band {
    float top;    ///< of the buttons
    float height; ///< of the buttons
    float bottom; ///< of the strip
};

void draw_chevron(const Ui& ui, ImVec2 middle) {
    const float r = 3.0f * ui.options.text_scale;
    const ImVec2 points[] = {{middle.x - 0.5f * r, middle.y - r},
                             {middle.x + 0.5f * r, middle.y},
                             {middle.x - 0.5f * r, middle.y + r}};
    ImGui::GetWindowDrawList()->AddPolyline(points, 3, packed(palette(ui.options.theme).dim), 0,
                                            1.3f * ui.options.text_scale);
}

/// Draws how an entry is joined to the previous one.
void draw_join(const Ui& ui, StripJoin join, float middle, const Band& band) {
    const float y = band.top + 0.5f * band.height;
    if (join == StripJoin::follows) draw_chevron(ui, {middle, y});
    if (join == StripJoin::begins_group) {
        const float half = 9.0f * ui.options.text_scale;
        const float x = std::round(middle) + 0.5f;
        ImGui::GetWindowDrawList()->AddLine({x, y - half}, {x, y + half},
                                            packed(palette(ui.options.theme).dim, 0.7f));
    }
}

void draw_entry(Ui& ui, const StripEntry& entry, float x, float width, const Band& band) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const std::string name = action_of(entry);
    const std::string title = title_of(entry, ui.session, current_language());
    const bool chosen = &entry == &chosen_entry(ui.session);
    const bool computed = is_computed(entry, ui.session);
    ImGui::SetCursorScreenPos({x, band.top});
    const bool pressed = ImGui::InvisibleButton(name.c_str(), {width, band.height});
    const bool hovered = ImGui::IsItemHovered();
    register_widget(ui, name, tooltip_of(ui, name));
    ImDrawList* const list = ImGui::GetWindowDrawList();
    if (chosen || hovered) {
        list->AddRectFilled({x, band.top}, {x + width, band.top + band.height},
                            packed(chosen ? p.chosen : p.button_hovered), 4.0f * u);
    }
    const float text = text_width(title);
    list->AddText(
        {x + 0.5f * (width - text), band.top + 0.5f * (band.height - ImGui::GetFontSize())},
        packed(computed || hovered ? p.text : p.dim), title.c_str());
    if (computed) {
        const float inset = 2.0f * u;
        list->AddRectFilled({x + inset, band.bottom - 3.0f * u}, {x + width - inset, band.bottom},
                            packed(chosen ? p.link : p.accent));
    }
    if (pressed) find_action(name).run(ui);
}

/// A thin line around entries that replace each other.
void draw_box(const Ui& ui, float left, float right, const Band& band) {
    ImGui::GetWindowDrawList()->AddRect(
        {left - 0.5f, band.top - 0.5f}, {right + 0.5f, band.top + band.height + 0.5f},
        packed(palette(ui.options.theme).dim, 0.45f), 5.0f * ui.options.text_scale);
}

/// Returns where the last one ends.
float draw_entries(Ui& ui, const Form& form, float left, const Band& band) {
    const StripRow entries = shown_entries(ui, form);
    const auto join_of = [&](std::size_t i) {
        return i > 0 && i < entries.size() ? join_between(*entries[i - 1], *entries[i])
                                           : StripJoin::begins_group;
    };
    float x = left, box = left;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const float width = segment_width(ui, form, *entries[i]);
        const bool is_alternative = join_of(i) == StripJoin::alternative;
        if (i > 0) {
            const float gap = gap_of(ui, join_of(i));
            draw_join(ui, join_of(i), x + 0.5f * gap, band);
            x += gap;
        }
        if (!is_alternative) box = x;
        draw_entry(ui, *entries[i], x, width, band);
        x += width;
        const bool goes_on = join_of(i + 1) == StripJoin::alternative;
        if (is_alternative && !goes_on) draw_box(ui, box, x, band);
    }
    return x;
}

/// Returns true if it is pressed.
bool draw_word(Ui& ui, const StripWord& word, float x, float width, const Band& band) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImGui::SetCursorScreenPos({x, band.top});
    const bool pressed = ImGui::InvisibleButton(word.name.c_str(), {width, band.height});
    const bool hovered = ImGui::IsItemHovered();
    register_widget(ui, word.name, word.help);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    if (word.chosen || hovered) {
        list->AddRectFilled({x, band.top}, {x + width, band.top + band.height},
                            packed(word.chosen ? p.chosen : p.button_hovered), 4.0f * u);
    }
    const float y = band.top + 0.5f * (band.height - ImGui::GetFontSize());
    const float between = word.quiet.empty() ? 0.0f : 6.0f * u;
    const float content =
        text_width(word.quiet) + between + std::max(text_width(word.loud), text_width(word.widest));
    const float begin = x + 0.5f * (width - content);
    list->AddText({begin, y}, packed(p.dim), word.quiet.c_str());
    list->AddText({begin + text_width(word.quiet) + between, y},
                  packed(word.is_unusual ? p.changed : p.text), word.loud.c_str());
    return pressed;
}

/// Opens below the last item drawn, or so that it ends where the item ends.
void open_below(const Ui& ui, bool at_right) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::SetNextWindowPos({at_right ? high.x : low.x, high.y + 4.0f * ui.options.text_scale}, 0,
                            {at_right ? 1.0f : 0.0f, 0.0f});
}

/// All entries, for when the strip shows only a few.
void draw_stage_list(Ui& ui) {
    open_below(ui, false);
    if (!ImGui::BeginPopup("all stages")) return;
    for (const StripEntry* entry : usable_entries(ui.session)) {
        const std::string action = action_of(*entry);
        const std::string title = title_of(*entry, ui.session, current_language());
        const bool chosen = entry == &chosen_entry(ui.session);
        if (ImGui::MenuItem(title.c_str(), nullptr, chosen)) find_action(action).run(ui);
        register_widget(ui, "stages." + std::string(entry->name), tooltip_of(ui, action));
    }
    ImGui::EndPopup();
}

void draw_scenes(Ui& ui) {
    open_below(ui, true);
    if (!ImGui::BeginPopup("scene list")) return;
    draw_scene_list(ui);
    ImGui::EndPopup();
}

/// From right to left: the scene, a bar, the comparison, the switches.
void draw_right_end(Ui& ui, const Form& form, float right, const Band& band) {
    float x = right;
    if (form.scene_width > 0.0f) {
        const StripWord word = scene_word(ui, form);
        const float width = word_width(ui, word);
        x -= width;
        if (draw_word(ui, word, x, width, band)) ImGui::OpenPopup("scene list");
        draw_scenes(ui);
        x -= bar_gap * ui.options.text_scale;
        draw_join(ui, StripJoin::begins_group, x + 0.5f * bar_gap * ui.options.text_scale, band);
    }
    std::vector<StripWord> words = strip_words(ui, form, needs_switches(chosen_entry(ui.session)));
    std::reverse(words.begin(), words.end());
    for (const StripWord& word : words) {
        const float width = word_width(ui, word);
        x -= width;
        if (draw_word(ui, word, x, width, band)) find_action(word.name).run(ui);
    }
}

} // namespace

float least_strip_width(const Ui& ui) {
    return form_width(ui, *form_of_three) + bar_margin(ui);
}

void draw_stage_strip(Ui& ui, const Layout& layout) {
    const Area& area = layout.strip;
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, layout.is_narrow ? p.bar : p.ground);
    ImGui::Begin("strip", nullptr, panel_flags);
    const float height = 32.0f * u;
    const Band band{area.position.y + std::round(0.5f * (area.size.y - height)), height,
                    area.position.y + area.size.y};
    // On the menu's line, its button and the gear are margin enough.
    const float margin = layout.is_narrow ? 0.5f * bar_margin(ui) : bar_margin(ui);
    const float left = area.position.x + margin;
    const float right = area.position.x + area.size.x - margin;
    const Form& form = fitting_form(ui, right - left);
    const float line = band.bottom - 0.5f;
    if (!layout.is_narrow) {
        ImGui::GetWindowDrawList()->AddLine({area.position.x, line},
                                            {area.position.x + area.size.x, line}, packed(p.line));
    }
    const float end = draw_entries(ui, form, left, band);
    if (form.few > 0) {
        const StripWord word = stages_word();
        if (draw_word(ui, word, end, word_width(ui, word), band)) ImGui::OpenPopup("all stages");
        draw_stage_list(ui);
    }
    draw_right_end(ui, form, right, band);
    ImGui::End();
    ImGui::PopStyleColor();
}

float bar_margin(const Ui& ui) {
    return 14.0f * ui.options.text_scale;
}

} // namespace rasterwalk
