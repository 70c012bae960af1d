#include <limits>
#include <optional>
#include <utility>

#include "mine/functions/check_parts.h"
#include "mine/functions/light_rules.h"
#include "mine/functions/vertex_carry.h"

namespace rasterwalk {

namespace {

struct AskedPoints {
    const Questions& questions;
    const std::vector<std::optional<DrawnPixel>>& answers;
};

/// A way to colour a pixel.
struct ShadeRule {
    std::string words; ///< of a rule that is right
    std::vector<std::string> bugs, causes;
    int mistakes = 0;
    RuleSettings settings;
    bool is_settled = true; ///< it needs no lamp
    LitColour (*colour)(const ShadeRule&, const ShaderQuestion&, const Light&) = nullptr;
    const LightRule* light = nullptr;
    int divisions = 0;       ///< of the carried value by 1/z
    bool has_colour = false; ///< the carried light is multiplied by the reflectance
};

LitColour plain(const glm::dvec3& colour) {
    // What a dozen float operations lose, and more.
    return {colour, 1e-4 * glm::dvec3(colour.r, colour.g, colour.b) + 1e-6};
}

LitColour own_colour(const ShadeRule&, const ShaderQuestion& question, const Light&) {
    return plain(glm::dvec3(question.colour));
}

double divisor(const ShadeRule& rule, const ShaderQuestion& question) {
    return std::pow(question.at.zinv, rule.divisions);
}

LitColour carried_light(const ShadeRule& rule, const ShaderQuestion& question, const Light&) {
    const double(&light)[3] = question.at.light;
    const glm::dvec3 colour = glm::dvec3(light[0], light[1], light[2]) / divisor(rule, question);
    return plain(rule.has_colour ? colour * glm::dvec3(question.colour) : colour);
}

LitColour light_of_pixel(const ShadeRule& rule, const ShaderQuestion& question,
                         const Light& light) {
    const double(&place)[3] = question.at.place;
    const glm::dvec3 position = glm::dvec3(place[0], place[1], place[2]) / divisor(rule, question);
    return lit_colour(*rule.light, glm::vec3(position), question.normal, question.colour, light);
}

/// All rules, those with fewer mistakes first.
/// @param carry what the vertices carry decides how often a value is to be divided
std::vector<ShadeRule> make_shade_rules(const VertexCarry& carry) {
    std::vector<ShadeRule> rules;
    ShadeRule own;
    own.words = "the colour of the surface, without light";
    own.colour = own_colour;
    rules.push_back(own);
    for (const bool has_colour : {false, true}) {
        for (const int divisions : {0, 1}) {
            ShadeRule& rule = rules.emplace_back();
            rule.words = "the light that the pixel carries";
            if (divisions == 1) rule.words += ", divided by 1/z";
            if (has_colour) rule.words += ", times the colour";
            rule.colour = carried_light;
            rule.divisions = divisions;
            rule.has_colour = has_colour;
            if (has_colour && carry.light_has_colour.value_or(false)) {
                rule.bugs.emplace_back("B78");
                ++rule.mistakes;
            }
        }
    }
    for (const LightRule& light : light_rules()) {
        for (const int divisions : {1, 0, 2}) {
            ShadeRule& rule = rules.emplace_back();
            rule.words = divisions == 0 ? "light from the position as it is carried"
                                        : "light from the position divided by 1/z";
            rule.is_settled = false;
            rule.colour = light_of_pixel;
            rule.light = &light;
            rule.divisions = divisions;
            rule.bugs = light.bugs;
            rule.causes = light.causes;
            rule.settings = light.settings;
            rule.mistakes = light.mistakes;
            if (divisions == 0 && carry.place_over_z.value_or(false)) {
                rule.bugs.emplace_back("B86");
                rule.settings.emplace_back("interpolation", "undivided");
                ++rule.mistakes;
            }
            if (divisions == 2) {
                rule.bugs.emplace_back("B87");
                rule.settings.emplace_back("interpolation", "divided_twice");
                ++rule.mistakes;
            }
        }
    }
    std::stable_sort(rules.begin(), rules.end(), [](const ShadeRule& a, const ShadeRule& b) {
        return a.mistakes < b.mistakes;
    });
    return rules;
}

bool is_shaded_by(const ShadeRule& rule, std::size_t index, const AskedPoints& asked) {
    const std::optional<DrawnPixel>& theirs = asked.answers[index];
    if (!theirs) return true; // the pixel is missing, which is judged by itself
    const ShaderQuestion& question = asked.questions.points[index];
    return is_same_colour(theirs->colour,
                          rule.colour(rule, question, asked.questions.program.light));
}

bool shades_all(const ShadeRule& rule, const AskedPoints& asked) {
    for (std::size_t i = 0; i < asked.answers.size(); ++i) {
        if (!is_shaded_by(rule, i, asked)) return false;
    }
    return true;
}

/// Checks where the pixels are. False: something is wrong.
bool check_places(const AskedPoints& asked, FunctionCheck& check) {
    bool are_exchanged = true;
    RightQuestions placed(asked.answers.size());
    std::size_t first = asked.answers.size();
    for (std::size_t i = asked.answers.size(); i-- > 0;) {
        const rasterwalk_kit::PixelValues& at = asked.questions.points[i].at;
        const std::optional<DrawnPixel>& theirs = asked.answers[i];
        placed[i] = theirs && theirs->x == at.x && theirs->y == at.y;
        if (!placed[i]) first = i;
        are_exchanged = are_exchanged && theirs && theirs->x == at.y && theirs->y == at.x;
    }
    if (first == asked.answers.size()) return true;
    set_wrong(check);
    check.right = count_right(placed);
    if (are_exchanged) check.causes.emplace_back("PixelShader exchanges x and y.");
    const rasterwalk_kit::PixelValues& at = asked.questions.points[first].at;
    check.difference.question = static_cast<int>(first);
    check.difference.ours = at;
    const std::string right = pixel_text(at.x, at.y);
    if (const std::optional<DrawnPixel>& theirs = asked.answers[first]) {
        check.first = fmt::format("A fragment at {} is drawn at {}.", right,
                                  pixel_text(theirs->x, theirs->y));
    } else {
        check.first = fmt::format("The fragment at {} with 1/z = {:.6g} is not drawn, although "
                                  "nothing is in front of it.",
                                  right, at.zinv);
    }
    return false;
}

/// The rule without mistakes that comes closest.
void say_first_colour(const std::vector<ShadeRule>& rules, const AskedPoints& asked,
                      FunctionCheck& check) {
    const ShadeRule* closest = &rules.front();
    double least = std::numeric_limits<double>::infinity();
    for (const ShadeRule& rule : rules) {
        if (rule.mistakes > 0) break;
        double sum = 0.0;
        for (std::size_t i = 0; i < asked.answers.size(); ++i) {
            if (!asked.answers[i]) continue;
            const glm::dvec3 ours =
                rule.colour(rule, asked.questions.points[i], asked.questions.program.light).colour;
            for (int c = 0; c < 3; ++c)
                sum += std::abs(ours[c] - asked.answers[i]->colour[c]);
        }
        if (sum < least) least = sum, closest = &rule;
    }
    bool is_said = false;
    check.right = 0;
    for (std::size_t i = 0; i < asked.answers.size(); ++i) {
        if (is_shaded_by(*closest, i, asked)) {
            ++check.right;
            continue;
        }
        if (is_said) continue;
        is_said = true;
        const ShaderQuestion& question = asked.questions.points[i];
        const glm::dvec3 ours =
            closest->colour(*closest, question, asked.questions.program.light).colour;
        const glm::dvec3& theirs = asked.answers[i]->colour;
        check.difference.question = static_cast<int>(i);
        check.difference.ours = question.at;
        check.first = fmt::format(
            "The point ({:.4g}, {:.4g}, {:.4g}) has the colour ({:.4g}, {:.4g}, {:.4g}) where "
            "({:.4g}, {:.4g}, {:.4g}) is right.",
            question.position.x, question.position.y, question.position.z, theirs.r, theirs.g,
            theirs.b, ours.r, ours.g, ours.b);
    }
}

void explain_colours(const AskedPoints& asked, const VertexCarry& carry, FunctionCheck& check) {
    const std::vector<ShadeRule> rules = make_shade_rules(carry);
    const ShadeRule* found = nullptr;
    for (const ShadeRule& rule : rules) {
        if (found != nullptr && rule.mistakes > found->mistakes) break;
        if (!shades_all(rule, asked)) continue;
        if (rule.mistakes == 0) {
            check.rule = rule.words;
            return;
        }
        if (rule.mistakes > 1 && found != nullptr) continue;
        if (found == nullptr) check.rules = rule.settings;
        found = &rule;
        for (const std::string& bug : rule.bugs)
            add_once(bug, rule.mistakes == 1 ? check.bugs : check.together);
        for (const std::string& cause : rule.causes)
            add_once(cause, check.causes);
    }
    // With the lab's lamp in place of an unknown one, nothing can be said against its light.
    if (!asked.questions.program.knows_light && (found == nullptr || !found->is_settled)) {
        check.bugs.clear();
        check.together.clear();
        check.causes.clear();
        check.rules.clear();
        check.notes.emplace_back(
            "Its light was not judged, because the program's lamp and indirect "
            "light are not known.");
        return;
    }
    set_wrong(check);
    say_first_colour(rules, asked, check);
}

} // namespace

FunctionCheck check_pixel_shader(const Questions& questions, const Answers& answers) {
    FunctionCheck check =
        begin_check("PixelShader", rasterwalk_kit::part_pixel_shader, questions, answers.points);
    if (!has_answers(check)) return check;
    const AskedPoints asked{questions, answers.points.answers};
    if (check.state == CheckState::died) {
        check.first =
            fmt::format("The program ended at point {} of {}.", asked.answers.size(), check.asked);
    }
    if (asked.answers.empty()) return check;
    const bool is_nothing_put =
        std::none_of(asked.answers.begin(), asked.answers.end(),
                     [](const std::optional<DrawnPixel>& drawn) { return drawn.has_value(); });
    if (is_nothing_put) {
        if (check.state == CheckState::right) {
            check.state = CheckState::not_written;
            check.notes.emplace_back(
                "Nothing is drawn: PixelShader does nothing, or its depth test "
                "lets nothing pass.");
        }
        return check;
    }
    check.right = static_cast<int>(asked.answers.size());
    if (check_places(asked, check))
        explain_colours(asked, find_vertex_carry(questions, answers), check);
    return check;
}

} // namespace rasterwalk
