#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/numbers.h"
#include "mine/checked_program.h"

namespace rasterwalk {

namespace {

/// The functions of the lab that a picture of each step needs, by their usual names. A program that
/// has one of them and does not call it has forgotten to, or has declared it where it meant to.
struct NeededFunction {
    std::string_view name;
    rasterwalk_kit::Part part;
    Stage from; ///< the first stage whose picture needs it
};
constexpr std::array<NeededFunction, 6> needed_functions{{
    {"VertexShader", rasterwalk_kit::part_vertex_shader, Stage::points},
    {"Interpolate", rasterwalk_kit::part_interpolate, Stage::edges},
    {"ComputePolygonRows", rasterwalk_kit::part_polygon_rows, Stage::fill},
    {"DrawPolygonRows", rasterwalk_kit::part_draw_rows, Stage::fill},
    {"DrawPolygonRows", rasterwalk_kit::part_depth_test, Stage::depth},
    {"PixelShader", rasterwalk_kit::part_pixel_shader, Stage::shade},
}};

bool is_written(const CheckedProgram& checked, rasterwalk_kit::Part part) {
    return std::any_of(checked.functions.begin(), checked.functions.end(),
                       [&](const FunctionCheck& check) {
                           return check.part == part && check.state != CheckState::not_written &&
                                  check.state != CheckState::not_asked;
                       });
}

/// A name without its namespace, in small letters without underscores: programs write VertexShader,
/// vertexShader and vertex_shader.
std::string plain_name(std::string_view function) {
    if (const std::size_t colons = function.rfind("::"); colons != std::string_view::npos)
        function.remove_prefix(colons + 2);
    std::string plain;
    for (const char c : function)
        if (c != '_') plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return plain;
}

bool is_called(const ProgramRun& run, std::string_view function) {
    return std::any_of(run.calls.begin(), run.calls.end(), [&](const FunctionCalls& calls) {
        return plain_name(calls.function) == plain_name(function);
    });
}

bool is_among(const std::vector<std::string>& names, std::string_view function) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return plain_name(name) == plain_name(function);
    });
}

void add_wrong_functions(const CheckedProgram& checked, std::vector<LikelyMistake>& mistakes) {
    for (const FunctionCheck& check : checked.functions) {
        if (check.state != CheckState::wrong) continue;
        LikelyMistake mistake;
        mistake.bugs = check.bugs.empty() ? check.together : check.bugs;
        mistake.sentence = fmt::format(
            "{} is wrong for {} of {} ({}). {}", check.function, check.asked - check.right,
            counted(check.asked, "question", "questions"), check.fed, check.first);
        for (const std::string& cause : check.causes)
            mistake.sentence += ' ' + cause;
        mistakes.push_back(std::move(mistake));
    }
}

void add_faults(const CheckedProgram& checked, std::vector<LikelyMistake>& mistakes) {
    for (const ProgramFault& fault : checked.run->faults)
        mistakes.push_back({{}, fault.sentence, fault.place, false});
}

/// Functions that are there, are needed for what is drawn, and are not called while it is.
void add_functions_not_called(const CheckedProgram& checked, std::vector<LikelyMistake>& mistakes) {
    const ProgramRun& run = *checked.run;
    if (run.calls.empty() || !run.has_frame()) return;
    if (checked.picture && checked.picture->is_right) return;
    for (const NeededFunction& needed : needed_functions) {
        if (!is_written(checked, needed.part) || !is_among(checked.defined, needed.name) ||
            is_called(run, needed.name))
            continue;
        if (checked.picture && checked.picture->reference.stage < needed.from) continue;
        // Only the first that is missing: those that it calls are not called either.
        mistakes.push_back(
            {{},
             fmt::format(
                 "{} is written, but your program drew its frame without calling it. The call may "
                 "still be missing, or be a line such as `void {}(...);`, which declares the "
                 "function once more and does not call it.",
                 needed.name, needed.name),
             {},
             true});
        return;
    }
}

void add_picture(const CheckedProgram& checked, std::vector<LikelyMistake>& mistakes) {
    if (!checked.run->has_frame()) return;
    if (!checked.picture) {
        if (!draws_nothing(*checked.run)) return;
        mistakes.push_back({{}, "Your program puts no pixel on the screen.", {}, false});
        return;
    }
    const PictureCheck& picture = *checked.picture;
    if (picture.is_right || !picture.is_judged) return;
    LikelyMistake mistake;
    mistake.sentence = fmt::format("{} of the picture {} from ours.",
                                   counted(picture.different, "pixel", "pixels"),
                                   picture.different == 1 ? "differs" : "differ");
    if (!picture.diagnosis.place.empty()) mistake.sentence += ' ' + picture.diagnosis.place;
    for (const std::string& finding : picture.diagnosis.findings)
        mistake.sentence += ' ' + finding;
    if (const Candidate* likely = likely_candidate(picture.diagnosis)) {
        if (likely->mistakes.size() == 1) {
            mistake.bugs = likely->mistakes.front().ids;
        } else {
            mistake.bugs = likely->ids();
            mistake.sentence += ' ' + picture.diagnosis.verdict;
        }
    }
    // A function that was named already explains the picture too.
    const bool is_explained =
        std::any_of(mistakes.begin(), mistakes.end(), [&](const LikelyMistake& known) {
            return std::any_of(known.bugs.begin(), known.bugs.end(), [&](const std::string& bug) {
                return std::find(mistake.bugs.begin(), mistake.bugs.end(), bug) !=
                       mistake.bugs.end();
            });
        });
    if (!is_explained) mistakes.push_back(std::move(mistake));
}

void add_key_faults(const CheckedProgram& checked, std::vector<LikelyMistake>& mistakes) {
    for (const KeyFault& fault : checked.key_faults) {
        const std::string when =
            fault.key.name.empty()
                ? "In the first frame"
                : fmt::format("While the key {} is held, in frame {}", fault.key.name, fault.frame);
        mistakes.push_back(
            {{}, fmt::format("{}: {}", when, fault.fault.sentence), fault.fault.place, false});
    }
}

} // namespace

std::string_view state_words(const CheckedProgram& checked, const FunctionCheck& check) {
    const bool is_drawn =
        checked.picture && std::any_of(needed_functions.begin(), needed_functions.end(),
                                       [&](const NeededFunction& needed) {
                                           return needed.part == check.part &&
                                                  checked.picture->reference.stage >= needed.from;
                                       });
    switch (check.state) {
    case CheckState::right:
        return "right";
    case CheckState::wrong:
        return "wrong";
    case CheckState::not_written:
        return is_drawn ? "not found" : "not written yet";
    case CheckState::not_asked:
        return "not asked";
    case CheckState::died:
        return "died";
    case CheckState::unreadable:
        return "unreadable";
    }
    return {};
}

std::string_view not_judged_words(const CheckedProgram& checked) {
    const bool is_wrong = std::any_of(
        checked.functions.begin(), checked.functions.end(), [](const FunctionCheck& check) {
            return check.state == CheckState::wrong || check.state == CheckState::died;
        });
    if (is_wrong)
        return "It is not judged while a function is wrong, because that alone may be the reason.";
    if (checked.picture && checked.picture->has_black_picture())
        return "A black picture is not judged, because many causes make it, and a lamp without "
               "power makes black of anything.";
    return "That may be right: too little is known about your program, because its functions or "
           "its lamp have names that are not known here.";
}

std::vector<LikelyMistake> likely_mistakes(const CheckedProgram& checked) {
    std::vector<LikelyMistake> mistakes;
    if (!checked.run) return mistakes;
    add_wrong_functions(checked, mistakes);
    add_faults(checked, mistakes);
    add_functions_not_called(checked, mistakes);
    add_picture(checked, mistakes);
    // A difference without a name may follow from one that has a name: DrawPolygonRows draws less
    // if the depth test in it is wrong.
    std::stable_partition(mistakes.begin(), mistakes.end(),
                          [](const LikelyMistake& mistake) { return !mistake.bugs.empty(); });
    add_key_faults(checked, mistakes);
    return mistakes;
}

} // namespace rasterwalk
