#include "pipeline/event_file.h"

#include <limits>
#include <string>

#include "base/error.h"
#include "base/files.h"
#include "support/cut_frames.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/temporary_folder.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace event_files {

const std::string head = "rasterwalk events 1\n";

/// What a fault in the file says, behind its name.
std::string fault_of(const std::string& text) {
    try {
        parse_recording(text, "told.txt");
    } catch (const InputError& error) {
        const std::string sentence = error.what();
        REQUIRE(sentence.starts_with("told.txt:"));
        return sentence.substr(std::string("told.txt:").size());
    }
    return "none";
}

std::string fault_of_line(const std::string& line) {
    return fault_of(head + line + "\nend\n");
}

} // namespace event_files
} // namespace

TEST_CASE("A recording comes back from its file to the last bit") {
    using namespace event_files;
    const TemporaryFolder folder;
    const auto check = [&](const Frame& frame) {
        const std::string text = recording_text(record(frame));
        write_file(folder.file("told.txt"), text);
        // The text has every field, and numbers in the fewest digits that name them.
        REQUIRE(recording_text(read_recording(folder.file("told.txt"))) == text);
    };
    for_each_frame(small_scene(), check);
    for_each_cut_frame(cut_scene(), 2, check);
}

TEST_CASE("Numbers that are not finite come back too") {
    FragmentEvent event;
    event.depth = std::numeric_limits<float>::infinity();
    event.stored = -std::numeric_limits<float>::infinity();
    event.fragment.z = std::numeric_limits<float>::quiet_NaN();
    const std::string text = recording_text({event});
    CHECK(recording_text(parse_recording(text, "")) == text);
}

TEST_CASE("A student's program need not write all fields") {
    using namespace event_files;
    const std::vector<Event> events = parse_recording(
        head + "fragment\tat=t0/r3/c5\tcolumn=12\trow=9\tafter=1,0.5,0\nend\n", "told.txt");
    REQUIRE(events.size() == 1);
    const auto& event = std::get<FragmentEvent>(events[0]);
    CHECK(event.cursor == Cursor{0, Phase::rows, 3, 5});
    CHECK(event.fragment.column == 12);
    CHECK(event.after == glm::vec3{1.0f, 0.5f, 0.0f});
    CHECK(event.fate == Fate::written);
}

TEST_CASE("A fault in a recording is named with its line") {
    using namespace event_files;
    CHECK(fault_of("") == "1: the first line is not \"rasterwalk events 1\".");
    CHECK(fault_of("rasterwalk events 2\nend\n") ==
          "1: the first line is not \"rasterwalk events 1\".");
    CHECK(fault_of(head) == "1: the recording stops here, without a line \"end\".");
    CHECK(fault_of(head + "end\ncull\tat=t0/k\n") == "2: text after the end.");
    CHECK(fault_of_line("") == "2: '' is no kind of event.");
    CHECK(fault_of_line("pixel\tat=t0/r0/c0") == "2: 'pixel' is no kind of event.");
    CHECK(fault_of_line("fragment\tcolumn=1") == "2: at='' is not the moment of a fragment.");
    for (const std::string at :
         {"end", "t0/p0/s0", "p1:t0/r0/c0", "t1000000/r0/c0", "t0/r131072/c0", "t0/r0/c131072",
          "t0/v3", "t-1/r0/c0", "t99999999999/r0/c0", "?"})
        CHECK(fault_of_line("fragment\tat=" + at) ==
              "2: at='" + at + "' is not the moment of a fragment.");
    CHECK(fault_of_line("clip\tat=t0/p6/s0") == "2: at='t0/p6/s0' is not the moment of a clip.");
    const std::string fragment = "fragment\tat=t0/r0/c0\t";
    for (const std::string value : {"x", "", "1.5", "16777217", "99999999999", "1 "})
        CHECK(fault_of_line(fragment + "column=" + value) ==
              "2: '" + value + "' is not a value of column.");
    CHECK(fault_of_line(fragment + "fate=lost") == "2: 'lost' is not a value of fate.");
    CHECK(fault_of_line(fragment + "after=1,2") == "2: '1,2' is not a value of after.");
    CHECK(fault_of_line(fragment + "after=1,2,3,4") == "2: '1,2,3,4' is not a value of after.");
    CHECK(fault_of_line(fragment + "colour=1") ==
          "2: a fragment has no field 'colour=1', or not twice.");
    CHECK(fault_of_line(fragment + "row=1\trow=1") ==
          "2: a fragment has no field 'row=1', or not twice.");
    CHECK(fault_of_line("cull\tat=t0/k\tvalues=" + std::string(9'000, ',')).starts_with("2: "));
    CHECK(fault_of_line(std::string(10'001, '\t')) == "2: a line of more than 10000 bytes.");
    CHECK(fault_of_line("cull\tat=t1/k\ncull\tat=t0/k") ==
          "3: t0/k comes after a later moment: not in order of time.");
}

TEST_CASE("No part of a recording, and none with a wrong byte, does harm") {
    using namespace event_files;
    const Scene scene = small_scene();
    const Frame frame = frame_of(scene, Stage::depth, rule_variants().front());
    const std::string text = recording_text(record(frame));
    for (std::size_t length = 0; length < text.size(); length += 97)
        REQUIRE(fault_of(text.substr(0, length)) != "none");
    Random random(7);
    for (int i = 0; i < rounds(300, 20); ++i) {
        std::string changed = text;
        const auto at = static_cast<std::size_t>(
            random.integer(0, static_cast<int>(std::min<std::size_t>(text.size(), 20'000)) - 1));
        changed[at] = static_cast<char>(random.integer(0, 255));
        fault_of(changed);
    }
}

TEST_CASE("A recording of other triangles is refused") {
    using namespace event_files;
    const Scene scene = small_scene();
    const Frame frame = frame_of(scene, Stage::depth, rule_variants().front());
    const auto refusal = [&](const FragmentEvent& event) -> std::string {
        try {
            const EventSource source(frame, {event});
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    FragmentEvent event;
    event.cursor = {frame.triangle_count(), Phase::rows, 0, 0};
    CHECK(refusal(event).ends_with("and the scene only " + std::to_string(frame.triangle_count()) +
                                   " triangles"));
    int left_out = 0;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        event.cursor.triangle = t;
        CHECK(refusal(event).empty() == frame.is_drawn(t));
        left_out += frame.is_drawn(t) ? 0 : 1;
    }
    CHECK(left_out > 0);
}
