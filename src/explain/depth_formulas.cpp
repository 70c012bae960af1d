#include "explain/depth_formulas.h"

#include <fmt/format.h>

#include "explain/formula_writer.h"
#include "explain/projection_formulas.h"
#include "explain/value_formulas.h"
#include "stages/orthographic.h"

namespace rasterwalk {

namespace {

/// The depth rounded to one of the values that the buffer has.
/// @param whole the depth before rounding
void round_depth(Formula& depth, float whole, const DepthRules& rules) {
    const ClipDepth kind = rules.projection.clip_depth;
    const int largest = (1 << rules.bits) - 1;
    // 1/z reaches up to 1/near.
    const bool is_scaled = kind == ClipDepth::inv_z;
    depth.expression = is_scaled ? "k / n / near" : "k / n";
    depth.inputs = {{"k",
                     {static_cast<float>(buffer_step(whole, rules)), true},
                     from_words(fmt::format("{} {} times {}, to the nearest whole number",
                                            depth_words(kind).name, shown({whole}),
                                            is_scaled ? "near times n" : "n"))},
                    {"n",
                     {static_cast<float>(largest), true},
                     from_words(fmt::format("2^{} − 1", rules.bits))}};
    if (is_scaled) depth.inputs.push_back({"near", {rules.near}, from_setting("near")});
}

/// Where a number tested at a sample comes from.
Source from_sample(int sample) {
    return from_words(
        fmt::format("interpolated as at the pixel's centre, but at sample {}", sample));
}

/// The depth of a z that was interpolated as if it changed in equal steps.
void add_linear_depth(Formula& depth, float z, const Source& source, const VertexRules& rules) {
    depth.help += " Computed from a z that was interpolated as if it changed in equal steps.";
    const FormulaInput input{"z", {z}, source};
    if (rules.projection.clip_depth == ClipDepth::inv_z) {
        depth.expression = "1 / z";
        depth.inputs = {input};
        return;
    }
    set_clip_depth(depth, rules, input);
    depth.expression += rules.projection.mix > 0.0f ? " / ((1 − mix) · z + mix)" : " / z";
}

} // namespace

std::string margin_limit(const DepthRules& rules) {
    return rules.epsilon > 0.0f ? "epsilon, " + shown({rules.epsilon}) + "," : "0";
}

void add_depth_test(FragmentReport& report, const Frame& frame) {
    const DepthRules rules = depth_rules(frame.settings, frame.scene->space);
    const ClipDepth kind = rules.projection.clip_depth;
    const DepthWords& words = depth_words(kind);
    const std::string name(words.name);
    Formula depth{"depth",
                  "new",
                  fmt::format("The fragment's value for the depth buffer, {}; {} is nearer.", name,
                              words.nearer),
                  "(1/z)",
                  {{"(1/z)", {report.fragment.depth}, from_formula("zinv")}},
                  {report.depth}};
    const bool is_elsewhere =
        report.covered != 0 && frame.settings.sample_rule != SampleRule::centre_depth;
    // Culled and cut-out fragments never reached the test.
    const bool is_tested = is_depth_tested(report.fate);
    if (is_tested && report.depth_test == DepthTest::linear_z) {
        add_linear_depth(depth, report.tested.z,
                         is_elsewhere ? from_sample(report.sample()) : from_formula("z.affine"),
                         vertex_rules(frame));
        depth.result = {depth_at(report.tested.z, rules)};
    } else if (kind != ClipDepth::inv_z) {
        report.formulas.push_back(along_row(
            report, "depth.carried", name,
            "Interpolated in equal steps. " + std::string(words.ends), report.interpolation,
            [](const RowEnd& end) { return end.depth; }, report.fragment.depth));
        depth.expression = "depth";
        depth.inputs = {{"depth", {report.fragment.depth}, from_formula("depth.carried")}};
    }
    if (is_tested && is_elsewhere && report.depth_test != DepthTest::linear_z) {
        // The weights of the corners are others there than at the centre.
        depth.inputs[0].number = {report.tested.depth};
        depth.inputs[0].source = from_sample(report.sample());
        depth.result = {report.tested.depth};
    }
    if (is_tested && rules.bits > 0) round_depth(depth, depth.result.value, rules);
    depth.result = {report.depth};
    report.formulas.push_back(depth);
    Source stored = report.stored_by
                        ? from_moment(in_pass(*report.stored_by, frame.pass))
                        : from_words("what the depth buffer starts with; nothing has been drawn "
                                     "here yet");
    if (!report.stored_by && report.stored != farthest_depth(kind))
        stored = from_setting("depth_clear");
    if (!report.has_cell) stored = from_words("this pixel has no cell in the depth buffer");
    std::string margin_help = "How much nearer the fragment is than the stored depth; ";
    if (report.depth_test == DepthTest::reversed)
        margin_help += "the test is the wrong way round, so below 0 the fragment is drawn.";
    else if (report.depth_test == DepthTest::or_equal)
        margin_help += "at 0 and above, the fragment is drawn.";
    else if (report.depth_test == DepthTest::raced)
        margin_help += "above 0, the fragment is drawn. So are some others, by a race of threads.";
    else
        margin_help += fmt::format("above {}, the fragment is drawn.", margin_limit(rules));
    FormulaWriter write(report.formulas);
    Formula& margin = write.add("margin", "margin", margin_help,
                                is_smaller_nearer(kind) ? "stored − new" : "new − stored",
                                {write.input("new", "depth"), {"stored", {report.stored}, stored}},
                                {depth_ahead(report.depth, report.stored, kind)});
    if (report.depth_test == DepthTest::off) return;
    margin.section = "depth";
    margin.label = "margin: " + margin.expression;
}

void add_resolve(FragmentReport& report, const Frame& frame) {
    if (!report.resolve) return;
    const bool is_late = frame.settings.sample_rule == SampleRule::late_clamp;
    FormulaWriter write(report.formulas, "resolve.");
    for (int i = 0; i < 3; ++i) {
        const std::string name = channel_name(i);
        FormulaInputs samples;
        for (int s = 0; s < sample_count; ++s) {
            const auto sample = static_cast<std::size_t>(s);
            samples.push_back({std::string(1, static_cast<char>('a' + s)),
                               {report.resolve->samples[sample][i]},
                               from_words(fmt::format("sample {} when everything is drawn", s))});
        }
        Formula& resolved = write.add(
            name, "resolved " + name,
            is_late ? "The mean of the pixel's samples. By mistake only the mean is clamped, so a "
                      "sample far above 1 outweighs all others."
                    : "The mean of the pixel's samples, each clamped to 0..1 first, so that none "
                      "counts for more than the screen can show.",
            is_late ? "clamp((a + b + c + d) / 4, 0, 1)"
                    : "(clamp(a, 0, 1) + clamp(b, 0, 1) + clamp(c, 0, 1) + clamp(d, 0, 1)) / 4",
            samples, {report.resolve->colour[i]});
        resolved.section = "resolve";
        resolved.label = name;
    }
}

void add_blend(FragmentReport& report, const Frame& frame) {
    if (!(report.alpha < 1.0f) || report.fate != Fate::written) return;
    const bool is_swapped = frame.settings.blend == Blend::swapped;
    FormulaWriter write(report.formulas, "blend.");
    for (int i = 0; i < 3; ++i) {
        const std::string name = channel_name(i);
        Formula& blended = write.add(
            name, "blended " + name,
            is_swapped ? "The surface blended over what was there, by mistake with the weights of "
                         "the surface and the pixel swapped."
                       : "The surface blended over what was there: a share α of the surface and "
                         "the rest of the pixel.",
            is_swapped ? "(1 − α) · S + α · D" : "α · S + (1 − α) · D",
            {{"α",
              {report.alpha},
              report.texture_alpha == TextureAlpha::blend
                  ? from_words("the alpha of the surface times the alpha of its texture here")
              : frame.settings.surface_alpha > 0.0f
                  ? from_setting("surface.alpha")
                  : from_words("the alpha of the surface, as the scene gives it")},
             {"S", {report.colour[i]}, from_words("the colour of the fragment by itself")},
             {"D", {report.before[i]}, from_words("what the pixel showed before")}},
            {report.after[i]});
        blended.section = "blend";
        blended.label = name;
    }
}

} // namespace rasterwalk
