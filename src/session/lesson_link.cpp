#include "session/lesson_link.h"

#include <algorithm>
#include <optional>

#include "pipeline/timeline.h"
#include "scene/error.h"
#include "session/setting_table.h"
#include "session/walk.h"

namespace rasterwalk {

namespace {

/// The text as it can be quoted in a message: short, on one line.
std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 60;
    std::string result(text.substr(0, longest));
    std::replace_if(
        result.begin(), result.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
    return "'" + result + (text.size() > longest ? "...'" : "'");
}

void follow_cursor(Session& session, const Frame& frame, const std::string& text) {
    const std::optional<Cursor> cursor = parse_cursor(text);
    if (!cursor) {
        throw UsageError("the link names no moment: " + quoted(text) +
                         " is not of the form t12/e2/s14.");
    }
    if (!Timeline(frame).exists(*cursor)) {
        const Stage stage = frame.settings.stage;
        throw UsageError("there is no moment " + quoted(text) + " at stage " +
                         std::string(stage_list()[static_cast<std::size_t>(stage)].name) + ".");
    }
    session.selection.triangle = std::nullopt;
    go_to(session, *cursor);
}

} // namespace

LessonLink parse_lesson_link(std::string_view target) {
    const std::size_t colon = target.find(':');
    const std::string_view kind = target.substr(0, colon);
    LessonLink link;
    if (kind == "set") {
        link.kind = LessonLink::Kind::set;
    } else if (kind == "cursor") {
        link.kind = LessonLink::Kind::cursor;
    } else if (kind != "show") {
        throw UsageError("the link " + quoted(target) +
                         " leads nowhere: links begin with set:, cursor: or show:.");
    }
    if (colon != target.npos) link.argument = target.substr(colon + 1);
    if (link.argument.empty()) throw UsageError("the link " + quoted(target) + " is not complete.");
    return link;
}

void follow_lesson_link(Session& session, const Frame& frame, const LessonLink& link) {
    switch (link.kind) {
    case LessonLink::Kind::set: {
        Settings settings = session.settings;
        set_from_text(settings, link.argument);
        session.settings = settings;
        break;
    }
    case LessonLink::Kind::cursor:
        follow_cursor(session, frame, link.argument);
        break;
    case LessonLink::Kind::show:
        break;
    }
}

} // namespace rasterwalk
