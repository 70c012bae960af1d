#include "mine/functions/check_parts.h"
#include "mine/functions/light_rules.h"
#include "mine/functions/projection_rules.h"
#include "mine/functions/vertex_carry.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

using rasterwalk_kit::PixelValues;

/// A word of vertex_rounding, and what it means in a program.
struct VertexRoundingWords {
    std::string_view name, formula;
};

constexpr VertexRoundingWords vertex_roundings[] = {
    {"truncate", "int(f x/z) + W/2"},
    {"truncate_sum", "int(f x/z + W/2)"},
    {"floor", "floor(f x/z) + W/2"},
    {"round", "f x/z + W/2, rounded to the nearest"},
};

/// The vertices as our stages see them.
struct AskedVertices {
    const Questions& questions;
    const std::vector<PixelValues>& answers;

    int count() const { return static_cast<int>(answers.size()); }
};

/// Does a coordinate agree? Where the value before rounding is so close to the next pixel that
/// float decides, either is right. f x/z takes a subtraction, three products and a division: the
/// bound is 16 times half a unit in the last place of the numbers involved.
bool is_same_coordinate(double theirs, int ours, double before_rounding, double middle,
                        std::string_view rounding) {
    if (theirs == ours) return true;
    const double tolerance = 0x1p-20 * (std::abs(before_rounding) + std::abs(middle) + 1.0);
    const double shifted = rounding == "round" ? before_rounding + 0.5 : before_rounding;
    const bool is_on_border = std::abs(shifted - std::round(shifted)) <= tolerance;
    return is_on_border && std::abs(theirs - ours) <= 1.0;
}

bool has_same_pixel(const ProjectionRule& rule, std::string_view rounding, std::size_t index,
                    const AskedVertices& asked) {
    ProjectionRule rounded = rule;
    set_value(rounded.chosen, *find_setting("vertex_rounding"), rounding);
    const ShadedVertex ours = shade_by(rounded, index, asked.questions);
    // It is so far out that programs differ in what they do.
    if (!ours.has_pixel) return true;
    const PixelValues& theirs = asked.answers[index];
    const glm::ivec2 middle(asked.questions.program.viewport.width / 2,
                            asked.questions.program.viewport.height / 2);
    return is_same_coordinate(theirs.x, ours.pixel.column, double{ours.pixel.position.x}, middle.x,
                              rounding) &&
           is_same_coordinate(theirs.y, ours.pixel.row, double{ours.pixel.position.y}, middle.y,
                              rounding);
}

/// Programs may keep the fractions of a position.
bool has_same_position(const ProjectionRule& rule, std::size_t index, const AskedVertices& asked) {
    const ShadedVertex ours = shade_by(rule, index, asked.questions);
    if (!ours.has_pixel) return true;
    const glm::vec2& at = ours.pixel.position;
    const PixelValues& theirs = asked.answers[index];
    const auto tolerance = [](float value) { return 0x1p-20 * (std::abs(double{value}) + 500.0); };
    return is_close(theirs.x, double{at.x}, tolerance(at.x)) &&
           is_close(theirs.y, double{at.y}, tolerance(at.y));
}

template <class IsSame>
bool are_all_same(IsSame is_same, const AskedVertices& asked) {
    for (std::size_t i = 0; i < asked.answers.size(); ++i) {
        if (!is_same(i)) return false;
    }
    return true;
}

bool explains_vertices(const ProjectionRule& rule, std::string_view rounding,
                       const AskedVertices& asked) {
    return are_all_same([&](std::size_t i) { return has_same_pixel(rule, rounding, i, asked); },
                        asked);
}

/// A rule that leaves nearly every vertex without a pixel explains nothing.
bool sees_vertices(const ProjectionRule& rule, const AskedVertices& asked) {
    int seen = 0;
    for (std::size_t i = 0; i < asked.answers.size(); ++i)
        seen += shade_by(rule, i, asked.questions).has_pixel ? 1 : 0;
    return 2 * seen > asked.count();
}

std::string vertex_name(std::size_t index, const Questions& questions) {
    const std::size_t of_room = questions.vertices.size() - 200;
    if (index < of_room) return fmt::format("vertices[{}] of triangles[{}]", index % 3, index / 3);
    const glm::vec3& p = questions.vertices[index].position;
    return fmt::format("the point ({:.4g}, {:.4g}, {:.4g})", p.x, p.y, p.z);
}

/// @returns the vertices that are where the rule that comes closest has them
RightQuestions explain_pixels(const AskedVertices& asked, FunctionCheck& check) {
    RightQuestions placed;
    const ProjectionRule right = projection_with({}, {}, {});
    std::vector<ProjectionRule> rights = {right};
    // With a rotation of its own and no yaw, the side on which it is multiplied is not known.
    if (asked.questions.program.rotation)
        rights.push_back(projection_with("rotation", "transposed", {}));
    int most = -1;
    std::string_view closest;
    for (const ProjectionRule& rule : rights) {
        for (const VertexRoundingWords& rounding : vertex_roundings) {
            RightQuestions same;
            for (std::size_t i = 0; i < asked.answers.size(); ++i)
                same.push_back(has_same_pixel(rule, rounding.name, i, asked));
            if (count_right(same) > most) {
                most = count_right(same);
                placed = std::move(same);
                closest = rounding.name;
                check.rule = rounding.formula;
                check.rules = rule.settings;
                check.rules.emplace_back("vertex_rounding", rounding.name);
            }
        }
        if (are_all_same([&](std::size_t i) { return has_same_position(rule, i, asked); }, asked)) {
            most = asked.count();
            placed.assign(asked.answers.size(), true);
            check.rule = "f x/z + W/2, with its fraction";
        }
    }
    check.right = most;
    if (most == asked.count()) return placed;
    set_wrong(check);
    check.rule.clear();
    for (const ProjectionRule& rule : make_mistaken_projections()) {
        if (asked.questions.program.rotation && rule.bug == "B24") continue;
        bool explains = false;
        for (const VertexRoundingWords& rounding : vertex_roundings) {
            if (explains || !explains_vertices(rule, rounding.name, asked)) continue;
            explains = true;
        }
        explains =
            explains ||
            are_all_same([&](std::size_t i) { return has_same_position(rule, i, asked); }, asked);
        if (!explains || !sees_vertices(rule, asked)) continue;
        if (!rule.bug.empty()) add_once(rule.bug, check.bugs);
        if (!rule.cause.empty()) add_once(rule.cause, check.causes);
    }
    for (std::size_t i = 0; i < asked.answers.size(); ++i) {
        if (has_same_pixel(right, closest, i, asked)) continue;
        ProjectionRule rounded = right;
        set_value(rounded.chosen, *find_setting("vertex_rounding"), closest);
        const ScreenVertex ours = shade_by(rounded, i, asked.questions).pixel;
        const PixelValues& theirs = asked.answers[i];
        check.difference.question = static_cast<int>(i);
        check.difference.theirs = theirs;
        check.difference.ours.fields = rasterwalk_kit::field_xy | rasterwalk_kit::field_zinv;
        check.difference.ours.x = ours.column;
        check.difference.ours.y = ours.row;
        check.difference.ours.zinv = double{ours.depth};
        check.first =
            fmt::format("{}: {} where {} is right.", vertex_name(i, asked.questions),
                        pixel_text(theirs.x, theirs.y), pixel_text(ours.column, ours.row));
        break;
    }
    return placed;
}

/// What is carried as 1/z, or as a position.
struct CarriedPlace {
    std::string_view words;
    bool over_z;
    bool in_camera_space;
};

constexpr CarriedPlace carried_places[] = {
    {"carries the position in the world", false, false},
    {"carries the position in the world times 1/z", true, false},
    {"carries the position in camera space", false, true},
    {"carries the position in camera space times 1/z", true, true},
};

const ProjectionRule& lab_projection() {
    static const ProjectionRule rule = projection_with({}, {}, {});
    return rule;
}

/// Eight roundings of the largest coordinate.
double place_tolerance(const glm::vec3& place) {
    return 0x1p-20 *
           (double{std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)})} + 4.0);
}

bool carries(const CarriedPlace& carried, std::size_t index, const Questions& questions,
             const PixelValues& theirs) {
    const ShadedVertex ours = shade_by(lab_projection(), index, questions);
    glm::vec3 place = carried.in_camera_space ? ours.in("rotated") : ours.in("world");
    if (carried.over_z) place *= ours.pixel.depth;
    for (int i = 0; i < 3; ++i) {
        if (!is_close(theirs.place[i], double{place[i]}, place_tolerance(place))) return false;
    }
    return true;
}

const CarriedPlace* find_carried_place(const Questions& questions,
                                       const std::vector<PixelValues>& answers) {
    const AskedVertices asked{questions, answers};
    if (answers.empty() || !has_field(answers[0], rasterwalk_kit::field_place)) return nullptr;
    for (const CarriedPlace& carried : carried_places) {
        if (are_all_same([&](std::size_t i) { return carries(carried, i, questions, answers[i]); },
                         asked))
            return &carried;
    }
    return nullptr;
}

/// How the light that a vertex carries is found.
struct CarriedLight {
    const LightRule* rule;
    bool has_colour = true, over_z = false;
};

LitColour carried_colour(const CarriedLight& carried, std::size_t index,
                         const Questions& questions) {
    const VertexQuestion& question = questions.vertices[index];
    const glm::vec3 colour = carried.has_colour ? question.colour : glm::vec3(1.0f);
    LitColour lit = lit_colour(*carried.rule, question.position, question.normal, colour,
                               questions.program.light);
    if (carried.over_z) {
        const double zinv = double{shade_by(lab_projection(), index, questions).pixel.depth};
        lit.colour *= zinv;
        lit.tolerance *= zinv;
    }
    return lit;
}

bool carries_light(const CarriedLight& carried, std::size_t index, const Questions& questions,
                   const PixelValues& theirs) {
    return is_same_colour({theirs.light[0], theirs.light[1], theirs.light[2]},
                          carried_colour(carried, index, questions));
}

bool has_light(const std::vector<PixelValues>& answers) {
    for (const PixelValues& values : answers) {
        if (has_field(values, rasterwalk_kit::field_light) &&
            (values.light[0] != 0.0 || values.light[1] != 0.0 || values.light[2] != 0.0))
            return true;
    }
    return false;
}

/// All light rules with this many mistakes that explain the light.
std::vector<CarriedLight> find_carried_light(const Questions& questions,
                                             const std::vector<PixelValues>& answers,
                                             int mistakes) {
    const AskedVertices asked{questions, answers};
    std::vector<CarriedLight> found;
    for (const LightRule& rule : light_rules()) {
        if (rule.mistakes != mistakes || rule.gap == LightGap::no_colour) continue;
        for (const bool has_colour : {true, false}) {
            for (const bool over_z : {false, true}) {
                const CarriedLight carried{&rule, has_colour, over_z};
                if (are_all_same(
                        [&](std::size_t i) {
                            return carries_light(carried, i, questions, answers[i]);
                        },
                        asked))
                    found.push_back(carried);
            }
        }
    }
    return found;
}

/// @param right loses the vertices whose 1/z is wrong
void check_vertex_zinv(const AskedVertices& asked, RightQuestions& right, FunctionCheck& check) {
    if (!has_field(asked.answers[0], rasterwalk_kit::field_zinv)) return;
    RightQuestions close(asked.answers.size());
    bool holds_z = true, is_never_set = true;
    std::size_t first = asked.answers.size();
    for (std::size_t i = asked.answers.size(); i-- > 0;) {
        const double ours = double{shade_by(lab_projection(), i, asked.questions).pixel.depth};
        const double theirs = asked.answers[i].zinv;
        // z is a sum of three products less the camera's.
        close[i] = is_close(theirs, ours, 0x1p-19 * ours * (1.0 + 4.0 * ours));
        if (!close[i]) first = i;
        holds_z = holds_z && is_close(theirs, 1.0 / ours, 1e-4 / ours);
        is_never_set = is_never_set && theirs == 0.0;
    }
    if (first == asked.answers.size()) {
        check.rule += "; 1/z is carried";
        return;
    }
    if (is_never_set) {
        check.notes.emplace_back("VertexShader does not set 1/z yet.");
        return;
    }
    set_wrong(check);
    right = right_in_both(std::move(right), close);
    if (holds_z) check.causes.emplace_back("zinv holds z, and not 1/z.");
    if (!check.first.empty()) return;
    const double ours = double{shade_by(lab_projection(), first, asked.questions).pixel.depth};
    check.difference.question = static_cast<int>(first);
    check.difference.theirs = asked.answers[first];
    check.first = fmt::format("{}: 1/z is {:.6g} where {:.6g} is right.",
                              vertex_name(first, asked.questions), asked.answers[first].zinv, ours);
}

/// The vertices that have the light of this rule.
RightQuestions lit_by(const CarriedLight& carried, const AskedVertices& asked) {
    RightQuestions lit;
    for (std::size_t i = 0; i < asked.answers.size(); ++i)
        lit.push_back(carries_light(carried, i, asked.questions, asked.answers[i]));
    return lit;
}

/// The rule without mistakes that explains the light of most vertices.
CarriedLight closest_right_light(const AskedVertices& asked) {
    CarriedLight closest{&light_rules().front()};
    int most = -1;
    for (const LightRule& rule : light_rules()) {
        if (rule.mistakes != 0) continue;
        for (const bool has_colour : {true, false}) {
            for (const bool over_z : {false, true}) {
                const CarriedLight carried{&rule, has_colour, over_z};
                const int lit = count_right(lit_by(carried, asked));
                if (lit > most) most = lit, closest = carried;
            }
        }
    }
    return closest;
}

/// @param right loses the vertices whose light is wrong
void check_vertex_light(const AskedVertices& asked, RightQuestions& right, FunctionCheck& check) {
    if (!has_light(asked.answers)) return;
    if (!find_carried_light(asked.questions, asked.answers, 0).empty()) {
        check.rule += "; light is computed as in the lab";
        return;
    }
    // What is stored there may be the colour of the vertex itself.
    const bool is_colour = are_all_same(
        [&](std::size_t i) {
            const glm::vec3& colour = asked.questions.vertices[i].colour;
            const double(&light)[3] = asked.answers[i].light;
            return is_close(light[0], double{colour.r}, 1e-6) &&
                   is_close(light[1], double{colour.g}, 1e-6) &&
                   is_close(light[2], double{colour.b}, 1e-6);
        },
        asked);
    if (is_colour) {
        check.rule += "; the colour is carried";
        return;
    }
    if (!asked.questions.program.knows_light) {
        check.notes.emplace_back(
            "Its light was not judged, because the program's lamp and indirect "
            "light are not known.");
        return;
    }
    set_wrong(check);
    for (int mistakes = 1; mistakes <= 2; ++mistakes) {
        const std::vector<CarriedLight> found =
            find_carried_light(asked.questions, asked.answers, mistakes);
        for (const CarriedLight& carried : found) {
            for (const std::string& bug : carried.rule->bugs)
                add_once(bug, mistakes == 1 ? check.bugs : check.together);
            for (const std::string& cause : carried.rule->causes)
                add_once(cause, check.causes);
            if (mistakes == 2) break;
        }
        if (!found.empty()) break;
    }
    const CarriedLight closest = closest_right_light(asked);
    const RightQuestions lit = lit_by(closest, asked);
    right = right_in_both(std::move(right), lit);
    for (std::size_t i = 0; i < asked.answers.size() && check.first.empty(); ++i) {
        if (lit[i]) continue;
        const glm::dvec3 ours = carried_colour(closest, i, asked.questions).colour;
        const double(&theirs)[3] = asked.answers[i].light;
        check.difference.question = static_cast<int>(i);
        check.difference.theirs = asked.answers[i];
        check.first =
            fmt::format("{}: its light is ({:.4g}, {:.4g}, {:.4g}) where ({:.4g}, {:.4g}, "
                        "{:.4g}) is right.",
                        vertex_name(i, asked.questions), theirs[0], theirs[1], theirs[2], ours.r,
                        ours.g, ours.b);
    }
}

} // namespace

VertexCarry find_vertex_carry(const Questions& questions, const Answers& answers) {
    VertexCarry carry;
    const std::vector<PixelValues>& vertices = answers.vertices.answers;
    if (const CarriedPlace* const place = find_carried_place(questions, vertices))
        carry.place_over_z = place->over_z;
    if (!has_light(vertices)) return carry;
    for (int mistakes = 0; mistakes <= 1; ++mistakes) {
        const std::vector<CarriedLight> found = find_carried_light(questions, vertices, mistakes);
        if (found.empty()) continue;
        carry.light_over_z = found[0].over_z;
        carry.light_has_colour = found[0].has_colour;
        break;
    }
    return carry;
}

FunctionCheck check_vertex_shader(const Questions& questions, const Answers& answers) {
    FunctionCheck check = begin_check("VertexShader", rasterwalk_kit::part_vertex_shader, questions,
                                      answers.vertices);
    if (!has_answers(check)) return check;
    const AskedVertices asked{questions, answers.vertices.answers};
    if (check.state == CheckState::died) {
        check.first =
            fmt::format("The program ended at vertex {} of {}.", asked.count(), check.asked);
    }
    if (asked.answers.empty()) return check;
    const bool does_nothing = are_all_same(
        [&](std::size_t i) {
            const PixelValues& values = asked.answers[i];
            return values.x == 0.0 && values.y == 0.0 && values.zinv == 0.0;
        },
        asked);
    if (does_nothing) {
        if (check.state == CheckState::right) check.state = CheckState::not_written;
        return check;
    }
    RightQuestions right = explain_pixels(asked, check);
    if (check.state == CheckState::wrong) return check;
    check_vertex_zinv(asked, right, check);
    if (has_field(asked.answers[0], rasterwalk_kit::field_place)) {
        const CarriedPlace* const place = find_carried_place(questions, asked.answers);
        if (place != nullptr)
            check.rule += fmt::format("; {}", place->words);
        else
            check.notes.emplace_back("What it carries as a position was not understood.");
    }
    check_vertex_light(asked, right, check);
    check.right = count_right(right);
    return check;
}

} // namespace rasterwalk
