#include "cli/spaces_report.h"

#include <cmath>
#include <ostream>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "explain/conventions.h"
#include "explain/vertex_spaces.h"

namespace rasterwalk {

namespace {

SpacesOfVertex spaces_as_set(const Frame& frame, int triangle, int vertex) {
    return spaces_of_vertex(frame, triangle, vertex, frame.settings.matrix_order);
}

ConventionReport conventions_of(const Frame& frame, int triangle) {
    return convention_report(frame.settings.camera, frame.scene->corner(triangle, 0).position);
}

template <int size>
Json numbers_json(const glm::vec<size, double, glm::defaultp>& vector) {
    Json array = Json::array();
    for (int i = 0; i < size; ++i)
        array.push_back(vector[i]);
    return array;
}

Json matrix_json(const glm::dmat4& matrix, MatrixOrder order) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row) {
        Json entries = Json::array();
        for (int column = 0; column < 4; ++column)
            entries.push_back(entry(matrix, order, row, column));
        rows.push_back(std::move(entries));
    }
    return rows;
}

Json to_json(const SpacePlace& place, MatrixOrder order) {
    Json object{{"place", numbers_json(place.place)}, {"space", place.space}};
    if (!place.formulas[0].empty()) object["formulas"] = place.formulas;
    if (!place.matrix) return object;
    object["matrix"] = matrix_json(*place.matrix, order);
    object["matrix_name"] = place.matrix_name;
    return object;
}

Json to_json(const ConventionPlace& place) {
    Json chosen = Json::array();
    for (std::size_t i = 0; i < convention_count; ++i) {
        if (has(place.chosen, static_cast<Convention>(i)))
            chosen.push_back(enum_words<Convention>[i]);
    }
    return {{"camera", numbers_json(place.camera)},
            {"change", word_of(place.change)},
            {"chosen", std::move(chosen)},
            {"formula", place.formula},
            {"picture", numbers_json(place.picture)}};
}

/// A number that is shown as zero has no sign.
std::string cell(double value) {
    const std::string size = decimals(std::abs(value), 4);
    return (value < 0.0 && size != "0.0000" ? "-" : "") + size;
}

void print_matrix(std::ostream& out, const SpacePlace& place, MatrixOrder order) {
    out << fmt::format("  {}, to {} space\n", place.matrix_name, place.space);
    for (int row = 0; row < 4; ++row) {
        out << "   ";
        for (int column = 0; column < 4; ++column)
            out << fmt::format(" {:>11}", cell(entry(*place.matrix, order, row, column)));
        out << '\n';
    }
}

void print_place(std::ostream& out, const SpacePlace& place) {
    out << fmt::format("  {:<8}", place.space);
    for (int i = 0; i < 4; ++i)
        out << fmt::format(" {:>11}", cell(place.place[i]));
    out << '\n';
    if (place.formulas[0].empty()) return;
    for (const std::string& formula : place.formulas)
        out << "             " << formula << '\n';
}

void print_convention(std::ostream& out, std::string_view name, const ConventionPlace& place) {
    out << fmt::format("  {:<16} {:>11} {:>11}   {}\n", name, cell(place.picture.x),
                       cell(place.picture.y), change_words(place.change));
}

} // namespace

Json spaces_json(const Frame& frame, int triangle) {
    Json vertices = Json::array();
    for (int v = 0; v < triangle_corners; ++v) {
        const SpacesOfVertex spaces = spaces_as_set(frame, triangle, v);
        Json places = Json::array();
        for (const SpacePlace& place : spaces.places)
            places.push_back(to_json(place, spaces.order));
        vertices.push_back({{"matrix_order", word_of(spaces.order)},
                            {"normal",
                             {{"as_point", numbers_json(spaces.normal.as_point)},
                              {"object", numbers_json(spaces.normal.object)},
                              {"world", numbers_json(spaces.normal.world)}}},
                            {"spaces", std::move(places)}});
    }
    return vertices;
}

Json conventions_json(const Frame& frame, int triangle) {
    const ConventionReport report = conventions_of(frame, triangle);
    Json alone = Json::array(), cancelling = Json::array();
    for (const ConventionPlace& place : report.alone)
        alone.push_back(to_json(place));
    for (const ConventionPlace& place : report.cancelling)
        cancelling.push_back(to_json(place));
    return {{"alone", std::move(alone)},
            {"cancelling", std::move(cancelling)},
            {"lab", to_json(report.lab)}};
}

void print_spaces(std::ostream& out, const Frame& frame, int triangle) {
    const SpacesOfVertex first = spaces_as_set(frame, triangle, 0);
    if (first.chain.empty()) return;
    out << "\nSpaces: " << first.chain << '\n';
    for (const SpacePlace& place : first.places) {
        if (place.matrix) print_matrix(out, place, first.order);
    }
    for (int v = 0; v < triangle_corners; ++v) {
        const SpacesOfVertex spaces = spaces_as_set(frame, triangle, v);
        out << fmt::format("\n  {:<8} {:>11} {:>11} {:>11} {:>11}\n", vertex_name(v), "x", "y", "z",
                           "w");
        for (const SpacePlace& place : spaces.places)
            print_place(out, place);
    }
}

void print_conventions(std::ostream& out, const Frame& frame, int triangle) {
    const ConventionReport report = conventions_of(frame, triangle);
    out << fmt::format("\nConventions: {} by the lab's projection, f x/z and f y/z, in pixels from "
                       "the middle\n",
                       vertex_name(0));
    print_convention(out, "the lab's", report.lab);
    for (std::size_t i = 0; i < convention_count; ++i)
        print_convention(out, enum_words<Convention>[i], report.alone[i]);
    for (const std::string& sentence : report.sentences)
        out << "  " << sentence << '\n';
}

} // namespace rasterwalk
