#include "explain/projection_formulas.h"

#include <fmt/format.h>

#include "explain/light_formulas.h"
#include "stages/orthographic.h"

namespace rasterwalk {

namespace {

constexpr const char* minus_sign = "−";

/// The coordinate of camera space along this axis of the picture; by mistake the other one.
int source_axis(const Settings& settings, int i) {
    return settings.image_axes == ImageAxes::exchanged ? 1 - i : i;
}

FormulaInput mix_of(float mix) {
    return {"mix", {mix}, from_setting("projection_mix")};
}

} // namespace

void add_mixed_w(VertexFormulaBuilder& made) {
    const ShadedVertex& shaded = made.report.shaded;
    Formula& w = made.write.add(
        "clip.w", "w",
        "What x and y are divided by: z under perspective, 1 under orthographic projection.",
        "(1 − mix) · z + mix",
        {mix_of(made.frame.settings.projection_mix), made.write.input("z", "rotated.z")},
        {shaded.position_clip.w});
    if (made.is_by_matrices()) {
        w.expression = "w";
        w.inputs = {by_matrix("w", shaded.position_clip.w, "Tp · Tv · P")};
    }
    if (!shaded.has_pixel) return;
    made.write.add("zinv", "1/w",
                   "The weight used for interpolation; it is the same at all vertices if the rays "
                   "are parallel.",
                   "1 / w", {made.write.input("w", "clip.w")}, {shaded.pixel.inv_w});
}

void set_clip_depth(Formula& formula, const VertexRules& rules, const FormulaInput& z) {
    const bool is_ndc = rules.projection.clip_depth == ClipDepth::ndc;
    const bool is_mixed = rules.projection.mix > 0.0f, is_flat = rules.near == rules.far;
    const std::string plane = is_ndc ? "far" : "near";
    formula.expression = fmt::format(
        "{} · (({}) / {})", is_mixed ? "((1 − mix) · " + plane + " + mix)" : plane,
        is_ndc ? z.symbol + " − near" : "far − " + z.symbol, is_flat ? "length" : "(far − near)");
    formula.inputs = {
        {"near", {rules.near}, from_setting("near")}, {"far", {rules.far}, from_setting("far")}, z};
    if (is_mixed) formula.inputs.push_back(mix_of(rules.projection.mix));
    if (is_flat) {
        formula.inputs.push_back({"length",
                                  {view_length(rules)},
                                  from_words("used instead of far − near, which is 0 and cannot be "
                                             "divided by")});
    }
}

void add_clip_depth(VertexFormulaBuilder& made) {
    const ShadedVertex& shaded = made.report.shaded;
    const DepthWords& words = depth_words(made.frame);
    Formula& clip = made.write.add(
        "clip.z", "z'",
        fmt::format("This becomes {} when it is divided by w. {}", words.name, words.ends), "", {},
        {shaded.position_clip.z});
    set_clip_depth(clip, vertex_rules(made.frame), made.write.input("z", "rotated.z"));
    if (made.is_by_matrices()) {
        clip.expression = "z'";
        clip.inputs = {by_matrix("z'", shaded.position_clip.z, "Tp · Tv · P")};
    }
    if (!shaded.has_pixel) return;
    made.write.add(
        "depth", std::string(words.name),
        fmt::format("What the depth buffer holds, {}; {} is nearer.", words.name, words.nearer),
        "z' · (1/w)", {made.write.input("z'", "clip.z"), made.write.input("(1/w)", "zinv")},
        {shaded.pixel.depth});
}

void add_clip_place(VertexFormulaBuilder& made, int i) {
    const ShadedVertex& shaded = made.report.shaded;
    const Settings& settings = made.frame.settings;
    const std::string axis = axis_name(i);
    const int from = source_axis(settings, i);
    const std::string source = axis_name(from);
    Formula& formula = made.write.add(
        "clip." + axis, axis + "'",
        "In clip space: pixels from the middle of the picture, times w.",
        "f · ((1 − mix) · d + mix) / d · " + source,
        {{"f", {settings.camera.focal_length}, from_setting("camera.focal_length")},
         mix_of(settings.projection_mix),
         {"d",
          {orthographic_depth_rule(settings)},
          settings.orthographic_depth > 0.0f ? from_setting("orthographic_depth")
                                             : from_words("the depth of the world's origin")},
         made.write.part(source, "rotated", from)},
        {shaded.position_clip[i]});
    if (settings.image_axes == ImageAxes::mirrored) formula.expression.insert(0, minus_sign);
    if (made.is_by_matrices()) {
        formula.expression = axis + "'";
        formula.inputs = {by_matrix(axis + "'", shaded.position_clip[i], "Ts · Tp · Tv · P")};
    }
}

void add_projected(VertexFormulaBuilder& made, int i) {
    const ShadedVertex& shaded = made.report.shaded;
    const Settings& settings = made.frame.settings;
    const std::string axis = axis_name(i);
    const std::string word(rounding_function(settings.vertex_rounding));
    const bool is_bench = made.is_bench();
    const int from = source_axis(settings, i);
    const std::string source = axis_name(from);
    Formula& projected = made.write.add(
        "projected." + axis, axis,
        "Pixels from the middle of the picture, before rounding. The program multiplies by 1/z.",
        "f · " + source + " · 1/z",
        {{"f", {settings.camera.focal_length}, from_setting("camera.focal_length")},
         made.write.part(source, "rotated", from),
         made.write.input("1/z", "zinv")},
        {i == 0 ? shaded.in("projected").x : shaded.in("projected").y});
    if (settings.image_axes == ImageAxes::mirrored) projected.expression.insert(0, minus_sign);
    if (made.is_by_matrices() || made.is_mixed()) {
        projected.help = "Pixels from the middle of the picture, before rounding.";
        projected.expression = axis + "' · (1/w)";
        projected.inputs = {made.write.part(axis + "'", "clip", i),
                            made.write.input("(1/w)", "zinv")};
    }
    if (is_bench) {
        projected.help = "The bench gives its vertices in pixels.";
        projected.expression = axis;
        projected.inputs = {made.write.part(axis, "rotated", i)};
    }
    const std::string name = i == 0 ? "column" : "row";
    Formula& pixel =
        made.write.add("pixel." + name, name, how_rounded(settings, made.frame.scene->space),
                       word + "(" + projected.expression + ")", projected.inputs,
                       {static_cast<float>(i == 0 ? shaded.pixel.column : shaded.pixel.row), true});
    if (!is_bench && settings.image_axes != ImageAxes::uncentred) {
        const int side = i == 0 ? settings.viewport.width : settings.viewport.height;
        const int middle = side / 2;
        const std::string half = i == 0 ? "W/2" : "H/2";
        if (settings.vertex_rounding == VertexRounding::truncate_sum) {
            pixel.expression.insert(pixel.expression.size() - 1, " + " + half);
        } else {
            pixel.expression += " + " + half;
        }
        pixel.inputs.push_back(
            {half, {static_cast<float>(middle), true}, from_setting("viewport.size")});
    }
    if (settings.outside_picture == OutsidePicture::clamped) {
        const Viewport& size = settings.viewport;
        const std::string side = i == 0 ? "W" : "H";
        pixel.expression = "clamp(" + pixel.expression + ", 0, " + side + " − 1)";
        pixel.inputs.push_back({side,
                                {static_cast<float>(i == 0 ? size.width : size.height), true},
                                from_setting("viewport.size")});
    }
}

} // namespace rasterwalk
