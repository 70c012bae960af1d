// Pictures like those that students bring, drawn by a second rasterizer, so that their mistakes are
// known. The laboratory must name those, and nothing else.

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "laboratory/diagnose.h"
#include "laboratory/student_pictures.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace honest_diagnosis {

std::string_view name_of(StudentKind kind) {
    constexpr std::array<std::string_view, 5> names{"right", "equally right", "single", "pair",
                                                    "unknown"};
    return names[static_cast<std::size_t>(kind)];
}

bool is_named(const KnownMistake& mistake, const std::vector<std::string>& ids) {
    return std::any_of(ids.begin(), ids.end(), [&](const std::string& id) {
        return id == mistake.id ||
               std::find(mistake.same.begin(), mistake.same.end(), id) != mistake.same.end();
    });
}

/// Does the id only say how the picture was drawn? That is not an accusation.
bool is_choice_of_drawing(const std::string& id) {
    constexpr std::array<std::string_view, 10> choices{
        "stage",     "light_power",      "light.position", "light.indirect",     "camera",
        "rounding=", "vertex_rounding=", "line_rounding=", "line_walk=multiply", "line_walk=exact"};
    return std::any_of(choices.begin(), choices.end(),
                       [&](std::string_view choice) { return id.starts_with(choice); });
}

/// Does the picture have every mistake that the candidate names? If a mistake has several names,
/// one of them must be true.
bool is_true(const Candidate& candidate, const BroughtPicture& picture) {
    return std::all_of(
        candidate.mistakes.begin(), candidate.mistakes.end(), [&](const Suspect& suspect) {
            return std::any_of(suspect.ids.begin(), suspect.ids.end(), is_choice_of_drawing) ||
                   std::any_of(
                       picture.mistakes.begin(), picture.mistakes.end(),
                       [&](const KnownMistake& mistake) { return is_named(mistake, suspect.ids); });
        });
}

enum class Outcome { ok, missed, falsely_accused };

/// Whether the diagnosis is right.
Outcome outcome(const BroughtPicture& picture, const Diagnosis& diagnosis) {
    const Candidate* const likely = likely_candidate(diagnosis);
    if (likely != nullptr && !is_true(*likely, picture)) return Outcome::falsely_accused;
    if (picture.mistakes.empty()) {
        const bool is_right = picture.kind != StudentKind::unknown;
        return diagnosis.is_same() == is_right ? Outcome::ok : Outcome::missed;
    }
    const std::vector<std::string> first = diagnosis.candidates.empty()
                                               ? std::vector<std::string>{}
                                               : diagnosis.candidates.front().ids();
    const bool is_all_named =
        std::all_of(picture.mistakes.begin(), picture.mistakes.end(), [&](const KnownMistake& m) {
            // From the picture alone it cannot be distinguished from another lamp.
            return m.is_lamp || is_named(m, first);
        });
    return is_all_named ? Outcome::ok : Outcome::missed;
}

/// The settings that the laboratory compares with: its own, with the student's camera if given.
Settings reference_of(const BroughtPicture& picture, const Scene& scene, const Image& image) {
    Settings reference = fitted_to(default_settings(scene), image, SceneSpace::world);
    if (picture.is_camera_known) {
        reference.camera.position = picture.program.camera;
        reference.camera.yaw = picture.program.yaw;
        reference.camera.focal_length *= picture.program.zoom;
    }
    return reference;
}

struct Share {
    int missed = 0, all = 0;
};

TEST_CASE("A student's picture is never accused falsely, and most of its mistakes are named") {
    const Scene scene = lab_room();
    const std::vector<Bug> bugs = read_bugs();
    std::map<StudentKind, Share> shares;
    for (const BroughtPicture& picture : some_of(student_pictures(), 12)) {
        const Image image = draw(picture.program);
        const Diagnosis diagnosis =
            diagnose_picture(image, scene, reference_of(picture, scene, image), bugs);
        const Outcome found = outcome(picture, diagnosis);
        const std::vector<std::string> first = diagnosis.candidates.empty()
                                                   ? std::vector<std::string>{}
                                                   : diagnosis.candidates.front().ids();
        constexpr std::array<std::string_view, 3> words{"ok", "missed", "FALSE"};
        const std::string row = fmt::format(
            "{:<7} {:<13} {:<45} [{}] {}", words[static_cast<std::size_t>(found)],
            name_of(picture.kind), picture.name, fmt::join(first, " "), diagnosis.verdict);
        fmt::print("{}\n", row);
        INFO(row);
        CHECK(found != Outcome::falsely_accused);
        if (picture.mistakes.empty()) CHECK(found == Outcome::ok);
        Share& share = shares[picture.kind];
        share.missed += found == Outcome::ok ? 0 : 1;
        ++share.all;
    }
    // One in ten and one in five; in a small part, one.
    const Share single = shares[StudentKind::single], pair = shares[StudentKind::pair];
    CHECK(single.all > 0);
    CHECK(pair.all > 0);
    CHECK(single.missed <= std::max(single.all / 10, 1));
    CHECK(pair.missed <= std::max(pair.all / 5, 1));
}

} // namespace honest_diagnosis
} // namespace
