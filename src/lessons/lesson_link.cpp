#include "lessons/lesson_link.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "facts/facts.h"
#include "laboratory/bug.h"
#include "picture/view_image.h"
#include "pipeline/timeline.h"
#include "session/moments.h"
#include "session/second_run.h"
#include "session/tabs.h"
#include "session/walk.h"
#include "settings/preset.h"
#include "settings/setting_table.h"
#include "view/view_state.h"
#include "view/widget_names.h"

namespace rasterwalk {

namespace {

using LinkKind = LessonLink::Kind;

constexpr std::array<std::pair<std::string_view, LinkKind>, 14> kinds{{
    {"set", LinkKind::set},
    {"cursor", LinkKind::cursor},
    {"show", LinkKind::show},
    {"compare", LinkKind::compare},
    {"pixel", LinkKind::pixel},
    {"triangle", LinkKind::triangle},
    {"row", LinkKind::row},
    {"vertex", LinkKind::vertex},
    {"tab", LinkKind::tab},
    {"view", LinkKind::view},
    {"overlay", LinkKind::overlay},
    {"preset", LinkKind::preset},
    {"bug", LinkKind::bug},
    {"term", LinkKind::term},
}};

[[noreturn]] void refuse_target(std::string_view target) {
    std::string known;
    for (const auto& [name, kind] : kinds)
        known.append(name).append(": ");
    throw UsageError(fmt::format("the link {} leads nowhere: links begin with {}or name another "
                                 "lesson, NN-name.md.",
                                 in_quotes(target), known));
}

/// `10-per-pixel.md`: two digits, a name, no folder.
bool names_lesson(std::string_view target) {
    constexpr std::string_view ending = ".md";
    return target.size() > ending.size() + 3 && target.ends_with(ending) && target[2] == '-' &&
           target.find_first_not_of("0123456789") == 2 &&
           target.substr(0, target.size() - ending.size())
                   .find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == target.npos;
}

std::vector<std::string> assignments_of(std::string_view argument) {
    std::vector<std::string> parts;
    while (true) {
        const std::size_t end = std::min(argument.find('&'), argument.size());
        parts.emplace_back(argument.substr(0, end));
        if (end == argument.size()) return parts;
        argument.remove_prefix(end + 1);
    }
}

void require(bool is_good, const LessonLink& link, const char* what) {
    if (is_good) return;
    throw UsageError(
        fmt::format("the link cannot go to {}: it takes {}.", in_quotes(link.argument), what));
}

void require_word(const LessonLink& link, const char* what,
                  std::span<const std::string_view> words) {
    if (std::find(words.begin(), words.end(), link.argument) != words.end()) return;
    throw UsageError(no_such_name(what, link.argument, words));
}

std::vector<std::string_view> overlay_words() {
    std::vector<std::string_view> words{"none"};
    for (const OverlayInfo& info : overlay_list())
        words.push_back(info.name);
    return words;
}

/// What can be told from the argument alone.
void check_argument(const LessonLink& link) {
    const bool is_none = link.argument == "none";
    switch (link.kind) {
    case LinkKind::set:
    case LinkKind::compare:
        if (link.kind == LinkKind::compare && link.argument == "off") break;
        for (const std::string& assignment : assignments_of(link.argument)) {
            Settings tried;
            set_from_text(tried, assignment);
        }
        break;
    case LinkKind::cursor:
        if (!parse_cursor(link.argument)) {
            throw UsageError(
                fmt::format("the link names no moment: {} is not of the form t12/e2/s14.",
                            in_quotes(link.argument)));
        }
        break;
    case LinkKind::pixel:
        require(is_none || parse_pixel(link.argument), link, "a column and a row: 250,131");
        break;
    case LinkKind::triangle:
    case LinkKind::row:
    case LinkKind::vertex:
        require(is_none || parse_int(link.argument), link, "a whole number or none");
        break;
    case LinkKind::tab:
        require_word(link, "tab", tab_names());
        break;
    case LinkKind::view:
        require_word(link, "view", view_names());
        break;
    case LinkKind::overlay:
        require_word(link, "overlay", overlay_words());
        break;
    case LinkKind::bug:
        find_bug(read_bugs(), link.argument);
        break;
    case LinkKind::show:
        check_widget_name(link.argument);
        break;
    case LinkKind::preset:
    case LinkKind::term:
    case LinkKind::lesson:
        break;
    }
}

int checked(const LessonLink& link, const char* what, int count) {
    const int number = parse_int(link.argument).value_or(-1);
    if (number >= 0 && number < count) return number;
    throw UsageError(fmt::format("there is no {} {}: they are 0 to {}.", what,
                                 in_quotes(link.argument), count - 1));
}

/// The number that a link selects, or nothing.
std::optional<int> chosen(const LessonLink& link, const char* what, int count) {
    if (link.argument == "none") return std::nullopt;
    return checked(link, what, count);
}

void pick_pixel(Session& session, const LessonLink& link) {
    const std::optional<glm::ivec2> pixel = parse_pixel(link.argument);
    const Viewport& size = session.a.settings.viewport;
    if (pixel &&
        (pixel->x < 0 || pixel->y < 0 || pixel->x >= size.width || pixel->y >= size.height)) {
        throw UsageError(fmt::format("the pixel {} lies outside the picture of {} x {} pixels.",
                                     in_quotes(link.argument), size.width, size.height));
    }
    session.selection.pixel = pixel;
}

void follow_compare(Session& session, const LessonLink& link) {
    if (link.argument == "off") {
        stop_comparing(session);
    } else {
        compare_with(session, settings_with(session.a.settings, assignments_of(link.argument)));
    }
}

void toggle_overlay(Session& session, const LessonLink& link) {
    if (const std::optional<Overlay> overlay = find_overlay(link.argument)) {
        session.overlays.set(*overlay, true);
    } else {
        session.overlays = {};
    }
}

} // namespace

LessonLink parse_lesson_link(std::string_view target) {
    LessonLink link;
    if (names_lesson(target)) {
        link.kind = LinkKind::lesson;
        link.argument = std::string(target.substr(0, target.size() - 3));
        return link;
    }
    const std::size_t colon = target.find(':');
    const std::string_view name = target.substr(0, colon);
    const auto found = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const auto& kind) { return kind.first == name; });
    if (found == kinds.end()) refuse_target(target);
    link.kind = found->second;
    if (colon != target.npos) link.argument = target.substr(colon + 1);
    if (link.argument.empty())
        throw UsageError("the link " + in_quotes(target) + " is not complete.");
    for (std::size_t at = 0; (at = link.argument.find("%20", at)) != link.argument.npos; ++at)
        link.argument.replace(at, 3, " ");
    check_argument(link);
    return link;
}

void follow_lesson_link(Session& session, const Frame& frame, const LessonLink& link) {
    switch (link.kind) {
    case LinkKind::set:
        session.a.settings = settings_with(session.a.settings, assignments_of(link.argument));
        break;
    case LinkKind::cursor: {
        const Cursor cursor = moment_of(frame, link.argument);
        session.selection.triangle = std::nullopt;
        go_to(session, cursor);
        break;
    }
    case LinkKind::compare:
        follow_compare(session, link);
        break;
    case LinkKind::pixel:
        pick_pixel(session, link);
        break;
    case LinkKind::triangle:
        session.selection.triangle = chosen(link, "triangle", frame.triangle_count());
        break;
    case LinkKind::row:
        session.selection.row = chosen(link, "row", session.a.settings.viewport.height);
        break;
    case LinkKind::vertex:
        session.selection.vertex = chosen(link, "vertex", triangle_corners);
        break;
    case LinkKind::tab:
        session.tab = link.argument;
        break;
    case LinkKind::view:
        session.view = *find_view(link.argument);
        break;
    case LinkKind::overlay:
        toggle_overlay(session, link);
        break;
    case LinkKind::preset:
        apply_preset(find_preset(session.presets, link.argument), session.a.settings);
        break;
    case LinkKind::bug:
        open_bug(find_bug(read_bugs(), link.argument), session);
        break;
    case LinkKind::show:
    case LinkKind::term:
    case LinkKind::lesson:
        break;
    }
}

} // namespace rasterwalk
