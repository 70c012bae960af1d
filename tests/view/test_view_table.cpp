// Every field of view_table() survives wherever a view is kept.

#include "view/view_table.h"

#include <map>
#include <string>

#include "lessons/lesson_link.h"
#include "opening/command_line_text.h"
#include "opening/opened_view.h"
#include "session/bench.h"
#include "support/effort.h"
#include "support/random_session.h"
#include "support/temporary_folder.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "view/state_file.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// What a session shows of each field, as text by its key.
using Shown = std::map<std::string, std::string>;
using Words = std::vector<std::string>;

Shown shown_of(const Session& session) {
    const ViewState state = state_of(session, scene_in_file(session));
    Shown shown;
    for (const ViewField& field : view_table()) {
        if (field.write && field.read_session) shown[std::string(field.key)] = field.write(state);
    }
    return shown;
}

/// The scene of the session, as first opened.
Session fresh_of(const Session& session) {
    return open_session(session.scene->path);
}

Session from_file(const Session& session) {
    const TemporaryFolder folder;
    ViewOptions options;
    options.file = folder.file("view.walk.toml");
    write_view(session, options.file);
    return open_view(options);
}

/// What Ctrl+C copies is given to the command line.
Session from_copied_line(const Session& session) {
    std::vector<std::string> words = command_line_words(session);
    words.erase(words.begin());
    return run(words).request.session;
}

/// Through `combined` and show_state(), as a lesson's step does.
Session from_state(const Session& session) {
    ViewState state = combined({}, state_of(session, scene_in_file(session)));
    state.scene = session.scene->path;
    Session again = fresh_of(session);
    again.a.settings = settings_with(again.a.settings, state.set);
    CHECK(show_on_scene(again, state).empty());
    return again;
}

/// The text after the colon in the links that show a field; none if there is none.
Words link_arguments(const ViewField& field, const ViewState& state, const ViewChange& change) {
    std::vector<std::string> words = field.key == "set" ? state.set
                                     : field.words      ? field.words(change)
                                                        : Words{};
    if (field.key != "set" && field.key != "compare") return words;
    if (words == Words{"none"}) return {"off"};
    std::string argument;
    for (const std::string& assignment : words)
        argument.append(argument.empty() ? "" : "&").append(assignment);
    return argument.empty() ? Words{} : Words{argument};
}

/// Opened by links of a lesson; fields without a link are as in `session`.
Session from_links(const Session& session) {
    Session again = fresh_of(session);
    const ViewState state = state_of(session, scene_in_file(session));
    for (const ViewField* field : view_table_drawn_first()) {
        const ViewState before = state_of(again, scene_in_file(again));
        if (field->link.name.empty()) {
            if (field->show) field->show(state, again);
            continue;
        }
        for (const std::string& argument :
             link_arguments(*field, state, {again, session, before, state})) {
            const LessonLink link =
                parse_lesson_link(std::string(field->link.name).append(":").append(argument));
            CHECK(link.is_of(field->key));
            follow_lesson_link(again, prepare_frame(*again.scene, again.a.settings), link);
        }
    }
    return again;
}

void check_shown(const Session& session, const Shown& expected, const char* way) {
    const Shown shown = shown_of(session);
    for (const auto& [key, text] : expected) {
        INFO(key << ", " << way);
        CHECK(shown.at(key) == text);
    }
}

} // namespace

TEST_CASE("Every field of the view survives a file, a copied line, a lesson's step and links") {
    Random random(31);
    std::map<std::string, int> tried;
    for (int i = 0; i < rounds(200, 60); ++i) {
        Session session = random_session(random);
        session.lesson.clear();
        session.step = 0;
        const Shown shown = shown_of(session);
        const Shown fresh = shown_of(fresh_of(session));
        for (const auto& [key, text] : shown)
            tried[key] += text != fresh.at(key) ? 1 : 0;
        INFO("session " << i << "\n" << command_line_text(session));
        check_shown(from_file(session), shown, "by a file");
        check_shown(from_copied_line(session), shown, "by a copied line");
        check_shown(from_state(session), shown, "by a lesson's step");
        check_shown(from_links(session), shown, "by links");
    }
    for (const auto& [key, count] : tried) {
        INFO(key << " is always the same as in a fresh session, so random_session() leaves it out");
        CHECK(count > 0);
    }
}

TEST_CASE("Every view field that the student sets is undone, and every place is found again") {
    Random random(32);
    for (int i = 0; i < rounds(100, 30); ++i) {
        const Session wanted = random_session(random);
        const ViewState state = state_of(wanted, scene_in_file(wanted));
        Session session = fresh_of(wanted);
        record_undo_step(session);
        record_visit(session);
        for (const ViewField* field : view_table_drawn_first()) {
            if (!field->read_session) continue;
            INFO("session " << i << ", " << field->key);
            const Choices choices = session;
            const Place place = session;
            if (field->show) {
                field->show(state, session);
            } else {
                session.a.settings = settings_with(session.a.settings, state.set);
            }
            const Choices& new_choices = session;
            const Place& new_place = session;
            const Shown shown = shown_of(session);
            const bool is_undone = !(new_choices == choices);
            const bool is_place = !(new_place == place) && !is_undone;
            if (is_undone) {
                record_undo_step(session);
                CHECK(undo(session));
                const Choices& undone = session;
                CHECK(undone == choices);
                CHECK(redo(session));
            } else {
                const std::size_t past = session.undo.past.size();
                record_undo_step(session);
                CHECK(session.undo.past.size() == past);
            }
            if (is_place) {
                ++session.jumps;
                record_visit(session);
                CHECK(go_back(session));
                const Place& back = session;
                CHECK(back == place);
                CHECK(go_forward(session));
            } else {
                record_visit(session);
            }
            CHECK(shown_of(session) == shown);
        }
    }
}
