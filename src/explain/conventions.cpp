#include "explain/conventions.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/enumerated.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

namespace {

constexpr unsigned all_convention_sets = 1u << convention_count;

/// How a sentence convention_names a choice.
constexpr std::array<std::string_view, convention_count> convention_words{
    "R v instead of v R",   "the transpose of R", "y up in the world",
    "z out of the picture", "−f instead of f",    "rows counted from the bottom"};

/// Points around the camera, so that a convention that happens to agree at one of them does not
/// count as the same.
std::array<glm::dvec3, 4> probes(const Camera& camera, const glm::dvec3& point) {
    const glm::dmat3 axes(camera_rotation(camera));
    const glm::dvec3 eye(camera.position);
    return {point, eye + axes * glm::dvec3(0.31, 0.23, 1.7),
            eye + axes * glm::dvec3(-0.7, 0.4, 2.9), eye + axes * glm::dvec3(0.2, -0.9, 3.3)};
}

bool is_same(const glm::dvec2& a, const glm::dvec2& b) {
    constexpr double tolerance = 1e-9;
    const double size = 1.0 + std::abs(b.x) + std::abs(b.y);
    return std::abs(a.x - b.x) <= tolerance * size && std::abs(a.y - b.y) <= tolerance * size;
}

/// The point in front of the camera, in the chosen axes.
/// @param rotation the lab's R
glm::dvec3 before_camera(const Camera& camera, const glm::dmat3& rotation, const glm::dvec3& point,
                         Conventions chosen) {
    const glm::dvec3 axes(1.0, has(chosen, Convention::y_up) ? -1.0 : 1.0,
                          has(chosen, Convention::z_backward) ? -1.0 : 1.0);
    // The world is written in other axes; R stays the program's.
    const glm::dvec3 d = axes * (point - glm::dvec3(camera.position));
    const glm::dmat3 r = has(chosen, Convention::transposed) ? glm::transpose(rotation) : rotation;
    return has(chosen, Convention::column_vectors) ? r * d : d * r;
}

glm::dvec2 in_picture(const Camera& camera, const glm::dvec3& before, Conventions chosen) {
    const double f = (has(chosen, Convention::negative_f) ? -1.0 : 1.0) *
                     static_cast<double>(camera.focal_length);
    const glm::dvec2 place = f * glm::dvec2(before) / before.z;
    return has(chosen, Convention::rows_up) ? glm::dvec2(place.x, -place.y) : place;
}

PictureChange change_of(const Camera& camera, const glm::dvec3& point, Conventions chosen) {
    constexpr std::array<glm::dvec2, 4> signs{glm::dvec2{1.0, 1.0}, glm::dvec2{-1.0, -1.0},
                                              glm::dvec2{1.0, -1.0}, glm::dvec2{-1.0, 1.0}};
    const glm::dmat3 rotation(camera_rotation(camera));
    std::array<bool, 4> fits{true, true, true, true};
    for (const glm::dvec3& probe : probes(camera, point)) {
        const auto seen = [&](Conventions under) {
            return in_picture(camera, before_camera(camera, rotation, probe, under), under);
        };
        const glm::dvec2 here = seen(chosen), lab = seen(0);
        for (std::size_t i = 0; i < signs.size(); ++i)
            fits[i] = fits[i] && is_same(here, signs[i] * lab);
    }
    const auto* const first = std::find(fits.begin(), fits.end(), true);
    return static_cast<PictureChange>(first - fits.begin());
}

std::string formula_of(Conventions chosen) {
    const bool is_column = has(chosen, Convention::column_vectors);
    const std::string r = has(chosen, Convention::transposed) ? "Rᵀ" : "R";
    return std::string(has(chosen, Convention::negative_f) ? "−" : "") + "f · (" +
           (is_column ? r + " d" : "d " + r) + ").x / (" + (is_column ? r + " d" : "d " + r) +
           ").z";
}

std::string sentence_of(Conventions chosen) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < convention_count; ++i) {
        if (has(chosen, static_cast<Convention>(i))) names.emplace_back(convention_words[i]);
    }
    std::string sentence = enumerated(names);
    sentence[0] = sentence[0] >= 'a' && sentence[0] <= 'z'
                      ? static_cast<char>(sentence[0] - 'a' + 'A')
                      : sentence[0];
    return sentence + (names.size() == 1 ? " changes nothing with this camera."
                                         : " cancel each "
                                           "other out.");
}

} // namespace

std::string_view change_words(PictureChange change) {
    constexpr std::array<std::string_view, enum_words<PictureChange>.size()> words{
        "the same picture", "rotated by half a turn", "upside down", "left and right swapped",
        "a different picture"};
    return words[static_cast<std::size_t>(change)];
}

const std::array<std::string_view, convention_count>& convention_names() {
    return convention_words;
}

ConventionPlace convention_place(const Camera& camera, const glm::dvec3& point,
                                 Conventions chosen) {
    const glm::dvec3 before =
        before_camera(camera, glm::dmat3(camera_rotation(camera)), point, chosen);
    return {chosen, formula_of(chosen), before, in_picture(camera, before, chosen),
            change_of(camera, point, chosen)};
}

ConventionReport convention_report(const Camera& camera, const glm::vec3& point) {
    const glm::dvec3 place(point);
    const auto place_under = [&](unsigned chosen) {
        return convention_place(camera, place, static_cast<Conventions>(chosen));
    };
    ConventionReport report;
    report.lab = place_under(0);
    for (unsigned i = 0; i < convention_count; ++i)
        report.alone[i] = place_under(1u << i);
    std::vector<unsigned> sets(all_convention_sets - 1);
    for (unsigned i = 0; i < sets.size(); ++i)
        sets[i] = i + 1;
    std::stable_sort(sets.begin(), sets.end(),
                     [](unsigned a, unsigned b) { return std::popcount(a) < std::popcount(b); });
    for (const unsigned set : sets) {
        const auto is_within = [set](const ConventionPlace& smaller) {
            return (smaller.chosen & set) == smaller.chosen;
        };
        if (std::any_of(report.cancelling.begin(), report.cancelling.end(), is_within)) continue;
        if (change_of(camera, place, static_cast<Conventions>(set)) != PictureChange::same)
            continue;
        ConventionPlace under = place_under(set);
        report.sentences.push_back(sentence_of(under.chosen));
        report.cancelling.push_back(std::move(under));
    }
    return report;
}

} // namespace rasterwalk
