#include "lessons/lesson_link.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/quoted.h"
#include "laboratory/bug.h"
#include "settings/preset.h"
#include "view/view_table.h"
#include "view/widget_names.h"

namespace rasterwalk {

namespace {

using LinkKind = LessonLink::Kind;

/// The links that do not belong to a field of the view.
constexpr std::array<std::pair<std::string_view, LinkKind>, 4> kinds{{
    {"show", LinkKind::show},
    {"preset", LinkKind::preset},
    {"bug", LinkKind::bug},
    {"term", LinkKind::term},
}};

/// What a link can begin with, the most common first.
std::vector<std::string_view> link_names() {
    std::vector<std::string_view> names{"set", "cursor", "show", "compare"};
    const auto add = [&](std::string_view name) {
        if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) {
            names.push_back(name);
        }
    };
    for (const ViewField& field : view_table())
        add(field.link.name);
    for (const auto& [name, kind] : kinds)
        add(name);
    return names;
}

[[noreturn]] void refuse_target(std::string_view target) {
    std::string known;
    for (const std::string_view name : link_names())
        known.append(name).append(": ");
    throw UsageError(fmt::format("the link {} leads nowhere. Links begin with {}or name another "
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

/// Checks what can be known from the argument alone.
void check_argument(const LessonLink& link) {
    switch (link.kind) {
    case LinkKind::field:
        link.field->link.check(link.argument);
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

/// The meaning of the word before the colon; throws UsageError if there is none.
void find_kind(std::string_view target, std::string_view name, LessonLink& link) {
    const auto found = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const auto& kind) { return kind.first == name; });
    if (found != kinds.end()) {
        link.kind = found->second;
        return;
    }
    for (const ViewField& field : view_table()) {
        if (name.empty() || field.link.name != name) continue;
        link.kind = LinkKind::field;
        link.field = &field;
        return;
    }
    refuse_target(target);
}

} // namespace

bool LessonLink::is_of(std::string_view field_key) const {
    return field != nullptr && field->key == field_key;
}

bool LessonLink::changes_settings() const {
    if (kind == LinkKind::field)
        return field->part == ViewPart::drawn || field->part == ViewPart::runs;
    return kind == LinkKind::preset || kind == LinkKind::bug;
}

LessonLink parse_lesson_link(std::string_view target) {
    LessonLink link;
    if (names_lesson(target)) {
        link.kind = LinkKind::lesson;
        link.argument = std::string(target.substr(0, target.size() - 3));
        return link;
    }
    const std::size_t colon = target.find(':');
    find_kind(target, target.substr(0, colon), link);
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
    case LinkKind::field:
        link.field->link.follow(session, frame, link.argument);
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
