#include "view/run_fields.h"

#include <algorithm>

#include "base/numbers.h"
#include "session/second_run.h"
#include "settings/setting_table.h"
#include "view/view_form.h"
#include "view/view_links.h"

namespace rasterwalk {

ViewField compare_field() {
    ViewForm<std::vector<std::string>> form{&ViewState::compare};
    form.read = read_assignments;
    form.toml = toml_list;
    form.tell = [](const Session& session) -> std::optional<std::vector<std::string>> {
        if (!session.b) return std::nullopt;
        return assignments_between(session.a.settings, session.b->settings);
    };
    form.show = [](const auto& compare, Session& session) {
        stop_comparing(session);
        if (compare) compare_with(session, settings_with(session.a.settings, *compare));
    };
    const ViewOption option{
        "b", "NAME=VALUE",
        "A second run that differs from the first in this setting; repeatable; none for no "
        "second run",
        true};
    ViewField field = make_field("compare", ViewPart::runs, option, form);
    field.parse = [](const GivenOption& given, ViewState& state) {
        state.compare = given.words;
        if (given.words.back() == no_value) state.compare = std::nullopt;
    };
    field.link = compare_link();
    field.words = [](const ViewChange& change) -> std::vector<std::string> {
        const Session& to = change.to_session;
        const Session& from = change.from_session;
        if (!to.b) {
            return from.b ? std::vector{std::string(no_value)} : std::vector<std::string>();
        }
        if (to.b == from.b && to.a == from.a) return {};
        if (to.a == *to.b) {
            // The option needs a word, so it gets the stage; then come values that setting the
            // stage would change.
            const std::string stage = "stage=" + value_text(*find_setting("stage"), to.a.settings);
            Settings said = to.a.settings;
            set_from_text(said, stage);
            std::vector<std::string> words = assignments_between(said, to.a.settings);
            words.insert(words.begin(), stage);
            return words;
        }
        return assignments_between(to.a.settings, to.b->settings);
    };
    return field;
}

ViewField wipe_field() {
    ViewForm<float> form{&ViewState::wipe};
    form.read = [](const TomlBlock& block, const toml::node& node) {
        return block.input().number(node, 0.0f, 1.0f, "the position of the divider");
    };
    form.toml = [](float wipe) { return number_text(wipe); };
    form.parse = [](const GivenOption& given, const std::string& word) {
        const std::optional<float> wipe = parse_number(word, 0.0f, 1.0f);
        if (!wipe) refuse_option(given, "a number from 0 to 1", word);
        return wipe;
    };
    form.word = [](const auto& wipe) { return number_text(wipe.value_or(Session().wipe)); };
    form.tell = [](const Session& session) {
        return session.wipe != Session().wipe ? std::optional(std::clamp(session.wipe, 0.0f, 1.0f))
                                              : std::nullopt;
    };
    form.show = [](const auto& wipe, Session& session) {
        session.wipe = wipe.value_or(session.wipe);
    };
    const ViewOption option{"wipe", "NUMBER", "Position of the divider between them, 0 to 1"};
    return make_field("wipe", ViewPart::runs, option, form);
}

ViewField compare_view_field() {
    return enum_field(
        "compare_view", ViewPart::runs,
        {"compare-view", "NAME", "How two runs are shown: " + one_of(enum_words<CompareView>)},
        "way to compare", &ViewState::compare_view, &Session::compare_view, true);
}

} // namespace rasterwalk
