#include "view/look_fields.h"

#include <algorithm>

#include "base/error.h"
#include "base/nearest_name.h"
#include "picture/overlay.h"
#include "session/depth_view.h"
#include "session/tabs.h"
#include "view/view_form.h"
#include "view/view_links.h"
#include "view/widget_names.h"

namespace rasterwalk {

ViewField tab_field() {
    ViewForm<std::string> form{&ViewState::tab};
    form.read = [](const TomlBlock& block, const toml::node& node) {
        return block.word(node, "tab", tab_names());
    };
    form.toml = toml_text;
    form.parse = [](const GivenOption& given, const std::string& word) {
        return std::string(tab_names()[option_index(given, tab_names(), word)]);
    };
    form.read_session = [](const Session& session) {
        // In a lesson the usual one may change, because its author may hide other panels.
        const bool is_usual = session.lesson.empty() && session.tab == usual_tab(session);
        return is_usual ? std::nullopt : std::optional(session.tab);
    };
    form.show = [](const auto& tab, Session& session) {
        guide_to_tab(session, tab.value_or(std::string()));
    };
    const ViewOption option{"tab", "NAME", "Tab of the inspector: " + one_of(tab_names())};
    ViewField field = make_field("tab", ViewPart::panel, option, form);
    // If none is named, the tab depends on the stage.
    field.words = [](const ViewChange& change) -> std::vector<std::string> {
        if (change.to.tab == change.from.tab) return {};
        return {change.to.tab.value_or(std::string(usual_tab(change.to_session)))};
    };
    field.link = word_link("tab", "tab", {tab_names().begin(), tab_names().end()}, lead_to_tab);
    return field;
}

ViewField panels_field() {
    ViewForm<std::vector<std::string>> form{&ViewState::panels};
    form.read = [](const TomlBlock& block, const toml::node& node) {
        std::vector<std::string_view> names;
        for (const TabInfo& tab : tab_list())
            names.push_back(tab.name);
        std::vector<std::string> panels;
        block.for_each_text(node, names.size(), [&](const std::string& name) {
            if (std::find(names.begin(), names.end(), name) == names.end()) {
                throw UsageError(no_such_name("panel", name, names));
            }
            panels.push_back(name);
        });
        return panels;
    };
    form.show = [](const auto& panels, Session& session) {
        session.tab_guide.panels = panels.value_or(std::vector<std::string>());
        session.tab_guide.shows_all = false;
    };
    return make_field("panels", ViewPart::panel, {}, form);
}

namespace {

std::vector<std::string_view> overlays_and_none() {
    std::vector<std::string_view> words{no_value};
    words.insert(words.end(), enum_words<Overlay>.begin(), enum_words<Overlay>.end());
    return words;
}

OverlaySet read_overlays(const TomlBlock& block, const toml::node& node) {
    OverlaySet overlays;
    block.for_each_text(node, overlay_count, [&](const std::string& name) {
        const std::optional<Overlay> overlay = value_of_word<Overlay>(name);
        if (!overlay) throw UsageError(no_such_name("overlay", name, overlays_and_none()));
        overlays.set(*overlay, true);
    });
    return overlays;
}

std::vector<std::string> texts_of(const OverlaySet& overlays) {
    std::vector<std::string> names;
    for (const OverlayInfo& info : overlay_list()) {
        if (overlays.has(info.overlay)) names.emplace_back(info.name);
    }
    return names;
}

} // namespace

ViewField overlays_field() {
    ViewForm<OverlaySet> form{&ViewState::overlays};
    form.read = read_overlays;
    form.toml = [](const OverlaySet& overlays) { return toml_list(texts_of(overlays)); };
    form.read_session = [](const Session& session) {
        return session.overlays.empty() ? std::nullopt : std::optional(session.overlays);
    };
    form.show = [](const auto& overlays, Session& session) {
        session.overlays = overlays.value_or(OverlaySet{});
    };
    const ViewOption option{"overlay", "NAME",
                            "Drawn over the picture: " + one_of(enum_words<Overlay>) +
                                "; repeatable; none for no overlay",
                            true};
    ViewField field = make_field("overlays", ViewPart::panel, option, form);
    field.parse = [](const GivenOption& given, ViewState& state) {
        OverlaySet overlays;
        for (const std::string& word : given.words) {
            if (word == no_value) {
                overlays = {};
            } else {
                overlays.set(static_cast<Overlay>(option_index(given, enum_words<Overlay>, word)),
                             true);
            }
        }
        state.overlays = overlays;
    };
    field.words = [](const ViewChange& change) -> std::vector<std::string> {
        if (change.to.overlays == change.from.overlays) return {};
        if (!change.to.overlays) return {std::string(no_value)};
        return texts_of(*change.to.overlays);
    };
    // Each link lays one more over the picture.
    field.link = word_link(
        "overlay", "overlay", overlays_and_none(), [](Session& session, const std::string& name) {
            if (const std::optional<Overlay> overlay = value_of_word<Overlay>(name)) {
                session.overlays.set(*overlay, true);
            } else {
                session.overlays = {};
            }
        });
    return field;
}

ViewField depth_range_field() {
    ViewForm<DepthInterval> form{&ViewState::depth_range};
    form.read = [](const TomlBlock& block, const toml::node& node) {
        const std::optional<DepthInterval> range = parse_depth_range(block.text(node));
        if (!range) {
            block.input().fail(node, "a range of depths is needed here, the smaller first, like "
                                     "\"0.2,0.8\".");
        }
        return *range;
    };
    form.toml = [](const DepthInterval& range) { return toml_text(to_text(range)); };
    form.parse = [](const GivenOption& given, const std::string& word) {
        const std::optional<DepthInterval> range = parse_depth_range(word);
        if (!range && word != no_value) {
            refuse_option(given, "a range of depths, the smaller first, like 0.2,0.8, or none",
                          word);
        }
        return range;
    };
    form.word = [](const auto& range) { return range ? to_text(*range) : std::string(no_value); };
    form.read_session = [](const Session& session) {
        const std::optional<DepthInterval>& range = session.depth_range;
        return range && range->smallest <= range->largest ? range : std::nullopt;
    };
    form.show = [](const auto& range, Session& session) { session.depth_range = range; };
    const ViewOption option{"depth-range", "SMALLER,LARGER",
                            "Range of 1/z, or of whatever the depth buffer holds, that the depth "
                            "view colours; if not given, the whole range"};
    ViewField field = make_field("depth_range", ViewPart::plane, option, form);
    field.is_of_scene = true;
    return field;
}

ViewField point_at_field() {
    ViewForm<std::string> form{&ViewState::point_at};
    form.read = [](const TomlBlock& block, const toml::node& node) {
        check_widget_name(block.text(node));
        return block.text(node);
    };
    return make_field("point_at", ViewPart::panel, {}, form);
}

ViewField plane_field() {
    ViewField field =
        enum_field("view", ViewPart::plane, {"view", "PLANE", "Plane: " + one_of(enum_words<View>)},
                   "view", &ViewState::view, &Session::view, false);
    field.link = word_link("view", "view", {enum_words<View>.begin(), enum_words<View>.end()},
                           [](Session& session, const std::string& view) {
                               session.view = *value_of_word<View>(view);
                           });
    return field;
}

ViewField page_field() {
    const ViewOption option{"page", "NAME",
                            "What you read next to the picture: " + one_of(enum_words<SidePage>)};
    return enum_field("page", ViewPart::panel, option, "page", &ViewState::page, &Session::page,
                      false);
}

} // namespace rasterwalk
