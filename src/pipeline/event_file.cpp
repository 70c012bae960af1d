#include "pipeline/event_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "base/text_parts.h"

namespace rasterwalk {

namespace {

constexpr std::string_view first_line = "rasterwalk events 1";
constexpr std::string_view last_line = "end";

/// The largest whole number of a field, either sign, and the largest number of a piece or a step.
constexpr int largest_whole = 1 << 24;
constexpr int most_pieces = 1 << 17;

/// The longest line of an event, bytes.
constexpr std::size_t longest_event_line = 10'000;

// The fields of each kind of event: what both the reader and the writer go through. `visit` takes a
// name and a value.

template <class Visit>
void each_varying(const std::string& prefix, Varyings& of, Visit& visit) {
    std::size_t i = 0;
    for_each_varying(
        [&](auto member) { visit(prefix + std::string(varying_list[i++].name), of.*member); });
}

/// Those that a vertex on the screen and a fragment have in common.
template <class Pixel, class Visit>
void each_field_of_pixel(Pixel& pixel, Visit& visit) {
    visit("column", pixel.column);
    visit("row", pixel.row);
    visit("carried_depth", pixel.depth);
    visit("inv_w", pixel.inv_w);
    visit("z", pixel.z);
    each_varying("carried_", pixel.varyings, visit);
}

template <class Visit>
void each_field(VertexEvent& event, Visit& visit) {
    visit("has_pixel", event.vertex.has_pixel);
    visit("rejection", event.vertex.rejection);
    visit("position", event.vertex.pixel.position);
    each_field_of_pixel(event.vertex.pixel, visit);
    each_varying("", event.varyings, visit);
}

template <class Visit>
void each_field(ClipEvent& event, Visit& visit) {
    ClipStep& step = event.step;
    visit("plane", step.plane);
    visit("from", step.from);
    visit("to", step.to);
    visit("d_from", step.d_from);
    visit("d_to", step.d_to);
    visit("is_from_inside", step.is_from_inside);
    visit("is_to_inside", step.is_to_inside);
    visit("keeps_from", step.keeps_from);
    visit("is_cut", step.is_cut);
    visit("t", step.t);
    visit("position_clip", step.cut.position_clip);
    each_varying("", step.cut.varyings, visit);
    visit("first_kept", step.first_kept);
}

template <class Visit>
void each_field(CullEvent& event, Visit& visit) {
    visit("measure", event.test.measure);
    visit("reason", event.test.reason);
    visit("values", event.test.values);
    visit("is_back", event.test.is_back);
}

template <class Visit>
void each_field(SampleEvent& event, Visit& visit) {
    EdgeSample& sample = event.sample;
    visit("edge", sample.edge);
    visit("sample", sample.sample);
    visit("x", sample.x);
    visit("y", sample.y);
    each_field_of_pixel(sample.fragment, visit);
    visit("decision_before", sample.decision.before);
    visit("decision_after", sample.decision.after);
    visit("decision", sample.decision.step);
    visit("inside", sample.write.inside);
    visit("left", sample.write.left);
    visit("right", sample.write.right);
}

template <class Visit>
void each_field(TestEvent& event, Visit& visit) {
    PixelTest& test = event.test;
    visit("triangle", test.triangle);
    visit("edges", test.edges);
    visit("column", test.column);
    visit("row", test.row);
    visit("e", test.e);
    visit("passes", test.passes);
    visit("weights", test.weights);
    visit("is_given_corner", test.is_given_corner);
    visit("is_inside", test.is_inside);
}

template <class Visit>
void each_field(FragmentEvent& event, Visit& visit) {
    each_field_of_pixel(event.fragment, visit);
    visit("fate", event.fate);
    visit("depth", event.depth);
    visit("stored", event.stored);
    visit("before", event.before);
    visit("after", event.after);
    visit("alpha", event.alpha);
}

// Values and their texts.

/// The words of an enum.
template <class Enum>
constexpr auto words_in_file = enum_words<Enum>;
template <>
constexpr auto words_in_file<Rejection> = [] {
    std::array<std::string_view, rejection_list.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = rejection_list[i].name;
    return names;
}();

/// Is it a vector or a list of numbers? Asked for anything but text.
template <class Value>
constexpr bool is_list = requires(Value value) {
    value[0];
};

template <class List>
std::size_t length_of(const List& list) {
    if constexpr (requires { list.size(); })
        return list.size();
    else
        return static_cast<std::size_t>(list.length());
}

template <class Value>
std::string text_in_file(const Value& value) {
    if constexpr (std::is_same_v<Value, std::string>) {
        return visible_line(value);
    } else if constexpr (is_list<Value>) {
        std::string text;
        for (std::size_t i = 0; i < length_of(value); ++i)
            text.append(i > 0 ? "," : "").append(text_in_file(value[static_cast<int>(i)]));
        return text;
    } else if constexpr (std::is_enum_v<Value>) {
        return std::string(words_in_file<Value>[static_cast<std::size_t>(value)]);
    } else if constexpr (std::is_floating_point_v<Value>) {
        return shortest(value);
    } else {
        return std::to_string(value);
    }
}

/// False: it is no such value.
template <class Value>
bool read_value(std::string_view text, Value& value) {
    if constexpr (std::is_same_v<Value, std::string>) {
        value = visible_line(text);
        return true;
    } else if constexpr (is_list<Value>) {
        std::vector<std::string_view> parts = split(text, ',');
        if (text.empty()) parts.clear();
        if constexpr (requires { value.resize(0); })
            value.resize(std::min(parts.size(), most_scene_corners));
        if (parts.size() != length_of(value)) return false;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (!read_value(parts[i], value[static_cast<int>(i)])) return false;
        return true;
    } else if constexpr (std::is_enum_v<Value>) {
        const auto& words = words_in_file<Value>;
        const auto found = std::find(words.begin(), words.end(), text);
        value = static_cast<Value>(found == words.end() ? 0 : found - words.begin());
        return found != words.end();
    } else if constexpr (std::is_same_v<Value, bool>) {
        value = text == "1";
        return value || text == "0";
    } else {
        const char* const last = text.data() + text.size();
        const auto [end, fault] = std::from_chars(text.data(), last, value);
        if (fault != std::errc() || end != last) return false;
        return !std::is_same_v<Value, int> || (value >= -largest_whole && value <= largest_whole);
    }
}

// Lines.

/// The kinds of events in the order of Event, which is that of the phases they happen in; that of
/// resolving has none.
constexpr std::array<std::string_view, std::variant_size_v<Event>> kinds{
    "vertex", "clip", "cull", "sample", "test", "fragment"};
static_assert(kinds.size() == static_cast<std::size_t>(Phase::resolve));

template <std::size_t... kind>
Event event_of_kind(std::size_t wanted, std::index_sequence<kind...> /*of Event*/) {
    Event event;
    ((kind == wanted ? void(event.emplace<kind>()) : void()), ...);
    return event;
}

/// Can an event of this kind have this moment? Marks are fragments of the moment they mark.
bool can_be_at(std::size_t kind, const Cursor& cursor) {
    const bool is_mark = kind + 1 == kinds.size() &&
                         (cursor.phase == Phase::vertices || cursor.phase == Phase::edges);
    return (is_mark || cursor.phase == static_cast<Phase>(kind)) && cursor.pass == 0 &&
           cursor.triangle >= 0 && cursor.triangle < max_triangles && cursor.index < most_pieces &&
           cursor.step < most_pieces &&
           (cursor.phase != Phase::vertices || cursor.index < triangle_corners) &&
           (cursor.phase != Phase::clip || cursor.index < static_cast<int>(clip_plane_count));
}

/// Reads the line of an event. Throws InputError without the line.
Event parse_event(std::string_view line) {
    if (line.size() > longest_event_line)
        throw InputError(fmt::format("a line of more than {} bytes.", longest_event_line));
    std::vector<std::string_view> fields = split(line, '\t');
    const auto kind = std::find(kinds.begin(), kinds.end(), fields[0]);
    if (kind == kinds.end()) throw InputError(in_quotes(fields[0]) + " is no kind of event.");
    fields.erase(fields.begin());
    const auto take = [&](std::string_view name) -> std::optional<std::string_view> {
        for (std::size_t i = 0; i < fields.size(); ++i) {
            if (!fields[i].starts_with(name) || fields[i].substr(name.size(), 1) != "=") continue;
            const std::string_view value = fields[i].substr(name.size() + 1);
            fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(i));
            return value;
        }
        return std::nullopt;
    };
    const std::string_view at = take("at").value_or("");
    const std::optional<Cursor> cursor = parse_cursor(at);
    const auto number = static_cast<std::size_t>(kind - kinds.begin());
    if (!cursor || !can_be_at(number, *cursor))
        throw InputError(fmt::format("at={} is not the moment of a {}.", in_quotes(at), *kind));
    Event event = event_of_kind(number, std::make_index_sequence<kinds.size()>());
    const auto read_field = [&](std::string_view name, auto& value) {
        const std::optional<std::string_view> text = take(name);
        if (text && !read_value(*text, value))
            throw InputError(fmt::format("{} is not a value of {}.", in_quotes(*text), name));
    };
    std::visit(
        [&](auto& of_kind) {
            of_kind.cursor = *cursor;
            each_field(of_kind, read_field);
        },
        event);
    if (!fields.empty())
        throw InputError(
            fmt::format("a {} has no field {}, or not twice.", *kind, in_quotes(fields[0])));
    return event;
}

} // namespace

std::vector<Event> record(const EventSource& source, const DrawWindow& window) {
    std::vector<Event> events;
    source.play(window, observe_all([&](const auto& event) {
                    if (events.size() == most_recorded_events)
                        throw UsageError(fmt::format("more than {} events are not recorded",
                                                     most_recorded_events));
                    events.emplace_back(event);
                }));
    std::stable_sort(events.begin(), events.end(),
                     [](const Event& a, const Event& b) { return cursor_of(a) < cursor_of(b); });
    return events;
}

std::string recording_text(const std::vector<Event>& events) {
    std::string text(first_line);
    for (Event event : events) {
        text.append("\n").append(kinds[event.index()]).append("\tat=");
        text += to_text(cursor_of(event));
        const auto write_field = [&](std::string_view name, const auto& value) {
            text.append("\t").append(name).append("=").append(text_in_file(value));
        };
        std::visit([&](auto& of_kind) { each_field(of_kind, write_field); }, event);
    }
    return text.append("\n").append(last_line).append("\n");
}

std::vector<Event> parse_recording(std::string_view text, const std::string& path) {
    std::vector<Event> events;
    int number = 1;
    if (take_part(text, '\n') != first_line)
        throw InputError(path, number, fmt::format("the first line is not \"{}\".", first_line));
    while (!text.empty()) {
        const std::string_view line = take_part(text, '\n');
        ++number;
        if (line == last_line) {
            if (!text.empty()) throw InputError(path, number, "text after the end.");
            return events;
        }
        if (events.size() == most_recorded_events)
            throw InputError(path, number,
                             fmt::format("more than {} events.", most_recorded_events));
        try {
            events.push_back(parse_event(line));
        } catch (const InputError& fault) {
            throw InputError(path, number, fault.what());
        }
        const Cursor& cursor = cursor_of(events.back());
        if (events.size() > 1 && cursor < cursor_of(events[events.size() - 2]))
            throw InputError(path, number,
                             to_text(cursor) +
                                 " comes after a later moment: not in order of time.");
    }
    throw InputError(path, number, "the recording stops here, without a line \"end\".");
}

std::vector<Event> read_recording(const std::string& path) {
    return parse_recording(read_file(path, largest_recording), path);
}

} // namespace rasterwalk
