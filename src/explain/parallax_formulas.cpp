#include "explain/parallax_formulas.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "explain/highlight_formulas.h"

namespace rasterwalk {

namespace {

constexpr const char* parallax_section = "parallax";

/// Makes the formulas of one fragment's shift, in order.
class ParallaxFormulas {
  public:
    ParallaxFormulas(const ParallaxReport& report, const Frame& frame, const SourcedVector& normal,
                     const SourcedVector& position, std::array<std::string, 2> coordinate_ids,
                     std::vector<Formula>& formulas)
        : report_(report), terms_(report.terms), frame_(frame), normal_(normal),
          position_(position), coordinate_ids_(std::move(coordinate_ids)),
          write_(formulas, "parallax.") {}

    void append() {
        add_height();
        if (report_.sign != 0.0f) {
            add_view();
            add_step();
            add_shift();
        }
        for (int i = 0; i < 2; ++i)
            add_coordinate(i);
    }

  private:
    void list(Formula& formula, const std::string& label) {
        formula.section = parallax_section;
        formula.label = label;
    }

    void add_height() {
        const TexelSum mean = texel_sum(report_.taken, 0, "height map");
        write_.add("stored", "texel", "The height map at the fragment's position, from 0 to 1.",
                   mean.expression, mean.inputs, {terms_.stored});
        list(write_.add("height", "h",
                        "How high above the surface it is thought to be there, in world units.",
                        "texel · scale + bias",
                        {write_.input("texel", "stored"),
                         {"scale",
                          {report_.heights.scale},
                          from_words("how much higher white is than black, from the scene")},
                         {"bias",
                          {report_.heights.bias},
                          from_words("the height of black, from the scene")}},
                        {terms_.height}),
             "height h");
    }

    /// The direction to the eye, in the world and along the axes.
    void add_view() {
        const SourcedVector way =
            append_to_eye(write_, "way", "q", position_, pixel_rules(frame_).rays);
        write_.add_length("distance", "|q|", "Its length.", "q", way, glm::length(way.value));
        const SourcedVector to_eye = write_.add_vector(
            "eye", "E", "The direction to the eye, of unit length.", "q / |q|", terms_.to_eye,
            [&](int i) {
                return FormulaInputs{write_.part("q", "way", i), write_.input("|q|", "distance")};
            });
        const FormulaWriter bump = write_.under("bump.");
        const std::array<SourcedVector, 3> axes{bump.vector("tangent"), bump.vector("bitangent"),
                                                normal_};
        for (int i = 0; i < 3; ++i) {
            const char* const axis = tangent_names[static_cast<std::size_t>(i)];
            list(write_.add_dot("view." + axis_name(i), "V." + axis_name(i),
                                std::string("The direction to the eye in tangent space: how much "
                                            "of it runs along ") +
                                    axis + ".",
                                "E", to_eye, axis, axes[static_cast<std::size_t>(i)],
                                terms_.view[i]),
                 "to the eye V." + axis_name(i));
        }
    }

    /// The step on the surface.
    void add_step() {
        const bool is_divided = frame_.settings.parallax == Parallax::divided;
        const bool is_back = !is_divided && terms_.view.z < 0.0f;
        const bool is_subtracted = frame_.settings.parallax_rule == ParallaxRule::subtracted;
        std::string help = is_divided
                               ? "How far the ray of sight goes along the surface until it "
                                 "is h above it: the step along "
                               : "The step on the surface, limited to the length of h: along ";
        for (int i = 0; i < 2; ++i) {
            const std::string axis = tangent_names[static_cast<std::size_t>(i)],
                              part = "V." + axis_name(i);
            std::string expression = is_divided ? "h · " + part + " / V.z"
                                     : is_back  ? "h · (0 − 1) · " + part
                                                : "h · " + part;
            FormulaInputs inputs{write_.input("h", "height"), write_.part(part, "view", i)};
            if (is_divided) inputs.push_back(write_.part("V.z", "view", 2));
            if (is_subtracted) expression = "(0 − 1) · (" + expression + ")";
            write_.add("step." + axis, "step." + axis,
                       help + axis + "." + (is_back ? " From behind, a bump is a dent." : "") +
                           (is_subtracted ? " By mistake it goes the other way." : ""),
                       expression, inputs, {terms_.step[i]});
        }
    }

    /// The same step in the texture.
    void add_shift() {
        const FormulaWriter bump = write_.under("bump.");
        const SourcedVector along_u = bump.vector("along_u"), along_v = bump.vector("along_v"),
                            tangent = bump.vector("tangent"), bitangent = bump.vector("bitangent");
        write_.add_dot("v_b", "W · b", "How far the surface runs along b while v grows by 1.", "W",
                       along_v, "b", bitangent,
                       glm::dot(report_.uv.along_v, report_.axes.bitangent));
        write_.add_dot("v_t", "W · t", "How far the surface runs along t while v grows by 1.", "W",
                       along_v, "t", tangent, glm::dot(report_.uv.along_v, report_.axes.tangent));
        write_.add_dot("u_t", "U · t", "How far the surface runs along t while u grows by 1.", "U",
                       along_u, "t", tangent, glm::dot(report_.uv.along_u, report_.axes.tangent));
        list(write_.add("shift.v", "dv", "The shift of v: the step along b, made by v alone.",
                        "step.b / (W · b)",
                        {write_.input("step.b", "step.b"), write_.input("(W · b)", "v_b")},
                        {terms_.shift.y}),
             "shift of v");
        list(write_.add("shift.u", "du",
                        "The shift of u: what is left of the step along t when v has moved.",
                        "(step.t − dv · (W · t)) / (U · t)",
                        {write_.input("step.t", "step.t"), write_.input("dv", "shift.v"),
                         write_.input("(W · t)", "v_t"), write_.input("(U · t)", "u_t")},
                        {terms_.shift.x}),
             "shift of u");
    }

    void add_coordinate(int i) {
        const std::string name = i == 0 ? "u" : "v";
        const FormulaInput carried{name + "0",
                                   {report_.carried.texcoord[i]},
                                   from_formula(coordinate_ids_[static_cast<std::size_t>(i)])};
        if (report_.sign == 0.0f) {
            list(write_.add(name, name,
                            "Not shifted, because the triangle has no area in the texture and so "
                            "u has no direction on it.",
                            name + "0 + 0", {carried}, {report_.texcoord[i]}),
                 name + " in the texture");
            return;
        }
        list(write_.add(name, name, "Where the texture is read, after the shift.",
                        name + "0 + d" + name, {carried, write_.input("d" + name, "shift." + name)},
                        {report_.texcoord[i]}),
             name + " in the texture");
    }

    const ParallaxReport& report_;
    const ParallaxTerms& terms_;
    const Frame& frame_;
    const SourcedVector& normal_;
    const SourcedVector& position_;
    std::array<std::string, 2> coordinate_ids_;
    FormulaWriter write_;
};

} // namespace

std::optional<ParallaxReport> parallax_report(const Fragment& fragment, const Surface& surface,
                                              const Frame& frame) {
    if (surface.heights.map == nullptr) return std::nullopt;
    const PixelRules rules = pixel_rules(frame);
    ParallaxReport report{
        axes_report(surface, surface_normal(fragment, surface, rules.camera, frame.stages), frame)};
    report.heights = surface.heights;
    report.carried = carried_place(fragment, surface, frame.stages);
    report.terms = parallax_terms(fragment, surface, rules, frame.stages, &report.taken);
    report.texcoord = report.carried.texcoord + report.terms.shift;
    return report;
}

void append_parallax_formulas(const ParallaxReport& report, const Frame& frame, int triangle,
                              const SourcedVector& normal, const SourcedVector& position,
                              const std::string& u_id, const std::string& v_id,
                              std::vector<Formula>& formulas) {
    append_axes_formulas(report, frame, triangle, normal, formulas);
    ParallaxFormulas(report, frame, normal, position, {u_id, v_id}, formulas).append();
}

} // namespace rasterwalk
