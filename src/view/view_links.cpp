#include "view/view_links.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "session/moments.h"
#include "session/second_run.h"
#include "session/shown_pass.h"
#include "session/walk.h"
#include "settings/setting_table.h"
#include "view/view_form.h"

namespace rasterwalk {

namespace {

std::vector<std::string> assignments_of(std::string_view argument) {
    std::vector<std::string> parts;
    while (true) {
        const std::size_t end = std::min(argument.find('&'), argument.size());
        parts.emplace_back(argument.substr(0, end));
        if (end == argument.size()) return parts;
        argument.remove_prefix(end + 1);
    }
}

void check_assignments(const std::string& argument) {
    for (const std::string& assignment : assignments_of(argument)) {
        Settings tried;
        set_from_text(tried, assignment);
    }
}

void require(bool is_good, const std::string& argument, const char* what) {
    if (is_good) return;
    throw UsageError(
        fmt::format("the link cannot go to {}; it takes {}.", in_quotes(argument), what));
}

void pick_pixel(Session& session, const std::string& argument) {
    const std::optional<glm::ivec2> pixel = parse_pixel(argument);
    const Viewport size = shown_size(session);
    if (pixel &&
        (pixel->x < 0 || pixel->y < 0 || pixel->x >= size.width || pixel->y >= size.height)) {
        throw UsageError(fmt::format("the pixel {} is outside the picture of {} x {} pixels.",
                                     in_quotes(argument), size.width, size.height));
    }
    session.selection.pixel = pixel;
}

/// The number that a link selects, or nothing.
std::optional<int> chosen(const std::string& argument, std::string_view what, int count) {
    if (argument == no_value) return std::nullopt;
    const int number = parse_int(argument).value_or(-1);
    if (number >= 0 && number < count) return number;
    throw UsageError(fmt::format("there is no {} {}; the numbers are 0 to {}.", what,
                                 in_quotes(argument), count - 1));
}

} // namespace

ViewLink settings_link() {
    return {"set", check_assignments,
            [](Session& session, const Frame&, const std::string& argument) {
                session.a.settings = settings_with(session.a.settings, assignments_of(argument));
            }};
}

ViewLink compare_link() {
    static constexpr std::string_view off = "off";
    return {"compare",
            [](const std::string& argument) {
                if (argument != off) check_assignments(argument);
            },
            [](Session& session, const Frame&, const std::string& argument) {
                if (argument == off) {
                    stop_comparing(session);
                } else {
                    compare_with(session,
                                 settings_with(session.a.settings, assignments_of(argument)));
                }
            }};
}

ViewLink cursor_link() {
    return {"cursor",
            [](const std::string& argument) {
                if (parse_cursor(argument)) return;
                throw UsageError("the link names no moment: " + in_quotes(argument) +
                                 " is not of the form t12/e2/s14.");
            },
            [](Session& session, const Frame& frame, const std::string& argument) {
                // Only another pass than the frame's has to be prepared.
                const int pass = std::min(parse_cursor(argument)->pass, 0);
                const Cursor cursor = pass == frame.pass
                                          ? moment_of(frame, argument)
                                          : moment_of(*session.scene, session.a.settings, argument);
                session.selection.triangle = std::nullopt;
                go_to(session, cursor);
            }};
}

ViewLink pixel_link() {
    return {"pixel",
            [](const std::string& argument) {
                require(argument == no_value || parse_pixel(argument), argument,
                        "a column and a row: 250,131");
            },
            [](Session& session, const Frame&, const std::string& argument) {
                pick_pixel(session, argument);
            }};
}

ViewLink number_link(std::string_view name, int (*count)(const Session&),
                     std::optional<int> Selection::*selected) {
    return {name,
            [](const std::string& argument) {
                require(argument == no_value || parse_int(argument), argument,
                        "a whole number or none");
            },
            [=](Session& session, const Frame&, const std::string& argument) {
                session.selection.*selected = chosen(argument, name, count(session));
            }};
}

ViewLink word_link(std::string_view name, std::string_view what,
                   std::vector<std::string_view> words,
                   std::function<void(Session&, const std::string&)> show) {
    return {name,
            [what, words = std::move(words)](const std::string& argument) {
                if (std::find(words.begin(), words.end(), argument) != words.end()) return;
                throw UsageError(no_such_name(what, argument, words));
            },
            [show = std::move(show)](Session& session, const Frame&, const std::string& argument) {
                show(session, argument);
            }};
}

} // namespace rasterwalk
