#include "compare/divergence_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/element_names.h"
#include "base/numbers.h"
#include "inspect/clip_history.h"
#include "inspect/pixel_tests.h"
#include "inspect/row_history.h"
#include "picture/view_image.h"

namespace rasterwalk {

namespace {

std::string number(float value, int digits) {
    return significant(static_cast<double>(value), digits);
}

/// Enough digits to tell two numbers apart.
int digits_for(float a, float b) {
    int digits = 6;
    while (digits < 9 && a != b && number(a, digits) == number(b, digits))
        ++digits;
    return digits;
}

int digits_for(const glm::vec3& a, const glm::vec3& b) {
    return std::max({digits_for(a.x, b.x), digits_for(a.y, b.y), digits_for(a.z, b.z)});
}

std::string triple(const glm::vec3& v, int digits) {
    return fmt::format("({:.{}g}, {:.{}g}, {:.{}g})", v.x, digits, v.y, digits, v.z, digits);
}

std::string pixel_text(int column, int row) {
    return fmt::format("pixel ({}, {})", column, row);
}

std::string_view stage_name(const Frame& frame) {
    return stage_info(frame.settings).name;
}

std::string_view rounding_word(Rounding rounding) {
    switch (rounding) {
    case Rounding::truncate:
        return "cut";
    case Rounding::floor:
        return "rounded down";
    case Rounding::round:
        return "rounded";
    }
    return "rounded";
}

std::string_view rounding_word(VertexRounding rounding) {
    if (rounding == VertexRounding::truncate_sum) return "counted from the border and cut";
    return rounding_word(static_cast<Rounding>(rounding));
}

/// Why a triangle is not drawn, with a typographic minus sign.
std::string rejection_text(Rejection rejection) {
    std::string text(words(rejection).sentence);
    if (const std::size_t at = text.find('-'); at != std::string::npos) text.replace(at, 1, "−");
    return text;
}

std::string left_out_sentence(std::string_view run, Rejection rejection) {
    return fmt::format("{} leaves the triangle out: {}.", run, rejection_text(rejection));
}

/// The sentence for a moment that only one run has because the other stops before it.
std::string stage_sentence(const Frame& a, const Frame& b, std::string_view what) {
    const bool only_a = a.settings.stage > b.settings.stage;
    return only_a ? fmt::format("only A has {}, because its stage is {} and B's is {}.", what,
                                stage_name(a), stage_name(b))
                  : fmt::format("only B has {}, because its stage is {} and A's is {}.", what,
                                stage_name(b), stage_name(a));
}

std::string mark_sentence(const Frame& a, const Frame& b, DivergenceKind kind) {
    return fmt::format("only {} puts a mark on the picture; the stages are {} and {}.",
                       kind == DivergenceKind::missing ? "A" : "B", stage_name(a), stage_name(b));
}

/// The sentence for a mark that only one run puts on the picture, though both reach it.
template <class Pixel>
std::string outside_sentence(DivergenceKind kind, const Pixel& in_a, const Pixel& in_b) {
    const bool only_a = kind == DivergenceKind::missing;
    const Pixel& other = only_a ? in_b : in_a;
    return fmt::format("only {} puts a mark on the picture; in {} {} lies outside the part that is "
                       "drawn.",
                       only_a ? "A" : "B", only_a ? "B" : "A", pixel_text(other.column, other.row));
}

ShadedVertex shade(const Frame& frame, const Cursor& cursor) {
    const Vertex& vertex = frame.scene->corner(cursor.triangle, cursor.index);
    const VertexRules rules = vertex_rules(frame.settings, frame.scene->space);
    return shade_vertex(vertex, camera_rotation(rules.camera), rules, frame.stages);
}

/// How a run gets from the projected position to the pixel.
std::string projection(const Frame& frame, const ShadedVertex& shaded, const ScreenVertex& pixel,
                       int digits) {
    const bool from_middle = frame.scene->space == SceneSpace::world;
    const glm::vec3 projected = shaded.in("projected");
    return fmt::format("projected to ({}, {}){}, {} to {}", number(projected.x, digits),
                       number(projected.y, digits), from_middle ? " from the middle" : "",
                       rounding_word(frame.settings.vertex_rounding),
                       pixel_text(pixel.column, pixel.row));
}

/// The first varying carried by both runs that differs: "its light is (1, 1, 1) in A, ...".
std::string varying_text(const Varyings& a, const Varyings& b, VaryingSet compared) {
    for (int v = 0; v < varying_count; ++v) {
        const VaryingInfo& varying = varying_list[static_cast<std::size_t>(v)];
        int digits = 0;
        bool differs = false;
        for (int i = 0; compared.has(v) && i < varying.count; ++i) {
            const float p = varying.component(a, i), q = varying.component(b, i);
            digits = std::max(digits, digits_for(p, q));
            differs = differs || p != q;
        }
        if (!differs) continue;
        const auto values = [&](const Varyings& of) {
            std::string text;
            for (int i = 0; i < varying.count; ++i)
                text += (i > 0 ? ", " : "") + number(varying.component(of, i), digits);
            return text;
        };
        return fmt::format("its {} is ({}) in A, ({}) in B.", varying.word, values(a), values(b));
    }
    return "the runs differ.";
}

/// The quantity that is the depth in both runs: 1/z in the lab.
std::string_view depth_word(const Frame& a, const Frame& b) {
    return depth_kind(a) == depth_kind(b) ? depth_words(a).name : "the depth value";
}

std::string vertex_text(const Frame& a, const Frame& b, const PairMoment& moment) {
    const std::string vertex = vertex_name(moment.cursor.index);
    const ProjectedVertex &in_a = moment.a.vertex->vertex, &in_b = moment.b.vertex->vertex;
    if (in_a.has_pixel != in_b.has_pixel) {
        return fmt::format("{} has no pixel in {}: {}.", vertex, in_a.has_pixel ? "B" : "A",
                           rejection_text((in_a.has_pixel ? in_b : in_a).rejection));
    }
    const bool differs = in_a.pixel.column != in_b.pixel.column || in_a.pixel.row != in_b.pixel.row;
    if (differs) {
        const ShadedVertex p = shade(a, moment.cursor), q = shade(b, moment.cursor);
        const int digits = std::max(digits_for(p.in("projected").x, q.in("projected").x),
                                    digits_for(p.in("projected").y, q.in("projected").y));
        return fmt::format("{}: in A {}; in B {}.", vertex, projection(a, p, in_a.pixel, digits),
                           projection(b, q, in_b.pixel, digits));
    }
    if (in_a.pixel.depth != in_b.pixel.depth) {
        const int digits = digits_for(in_a.pixel.depth, in_b.pixel.depth);
        return fmt::format("{}: {} is {} in A, {} in B.", vertex, depth_word(a, b),
                           number(in_a.pixel.depth, digits), number(in_b.pixel.depth, digits));
    }
    return fmt::format("{}: {}", vertex,
                       varying_text(moment.a.vertex->varyings, moment.b.vertex->varyings,
                                    carried_varyings(a) & carried_varyings(b)));
}

/// What one run does with an edge at a plane; `other` decides how many digits are needed.
std::string clip_side(const ClipEvent* event, const ClipEvent* other) {
    if (event == nullptr) return "does nothing";
    const ClipStep& step = event->step;
    const std::string kept =
        fmt::format("{} corner {}", step.keeps_from ? "keeps" : "leaves out", step.from);
    if (!step.is_cut) return kept;
    const glm::vec4& p = step.cut.position_clip;
    int digits = 4;
    if (other != nullptr && other->step.is_cut) {
        const glm::vec4& q = other->step.cut.position_clip;
        digits = std::max({digits_for(step.t, other->step.t), digits_for(p.x, q.x),
                           digits_for(p.y, q.y), digits_for(p.w, q.w)});
    }
    return fmt::format("{} and cuts at t = {}, ({}, {}, {}, {}) in clip space", kept,
                       number(step.t, digits), number(p.x, digits), number(p.y, digits),
                       number(p.z, digits), number(p.w, digits));
}

/// "near plane, edge 1: A does nothing; B keeps corner 1 and cuts at t = 0.3, ..."
std::string clip_text(const PairMoment& moment) {
    return fmt::format("{}, {}: A {}; B {}.", plane_name(moment.cursor.index),
                       edge_name(moment.cursor.step), clip_side(moment.a.clip, moment.b.clip),
                       clip_side(moment.b.clip, moment.a.clip));
}

/// "A does not cull; B culls: dot(n, p - C) = 0.7, the normal points away from the camera."
std::string cull_text(const PairMoment& moment) {
    const auto side = [](const CullEvent* event) {
        return event == nullptr ? std::string("does not cull") : culling_text(event->test);
    };
    return fmt::format("A {}; B {}.", side(moment.a.cull), side(moment.b.cull));
}

/// One coordinate of a sample on its way to a pixel: "y = 0.999842 is cut to 0".
std::string coordinate_text(const Frame& frame, char axis, float place, int pixel, int digits) {
    const std::string at = fmt::format("{} = {}", axis, number(place, digits));
    if (static_cast<float>(pixel) == place) return at;
    // In a walk without error, the position shown can itself be off by a rounding error.
    const Rounding rounding = sample_rounding(frame.settings);
    const bool by_fraction =
        frame.settings.line_walk == LineWalk::exact && to_pixel(place, rounding) != pixel;
    if (by_fraction) return fmt::format("{}, exactly {}", at, pixel);
    return fmt::format("{} is {} to {}", at, rounding_word(rounding), pixel);
}

std::string sample_side(const Frame& frame, const SampleEvent& event, bool with_x, bool with_y,
                        int digits) {
    const EdgeSample& sample = event.sample;
    std::string text;
    if (with_x) text = coordinate_text(frame, 'x', sample.x, sample.fragment.column, digits);
    if (with_y) {
        text += (with_x ? ", " : "") +
                coordinate_text(frame, 'y', sample.y, sample.fragment.row, digits);
    }
    if (sample.write.inside) return text;
    const TableRows rows = table_rows(frame, event.cursor.triangle);
    const bool above = sample.fragment.row < rows.first;
    return above ? fmt::format("{}, above the first row {}", text, rows.first)
                 : fmt::format("{}, below the last row {}", text, rows.last);
}

int sample_count(const Frame& frame, const Cursor& cursor) {
    const std::vector<int> samples = row_history(frame, cursor.triangle).edge_samples;
    const auto edge = static_cast<std::size_t>(cursor.index);
    return edge < samples.size() ? samples[edge] : 0;
}

std::string sample_text(const Frame& a, const Frame& b, const PairMoment& moment) {
    const Cursor& cursor = moment.cursor;
    const int count_a = sample_count(a, cursor), count_b = sample_count(b, cursor);
    if (moment.a.sample == nullptr || moment.b.sample == nullptr) {
        return fmt::format("{} has {} in A and {} in B.", edge_name(cursor.index),
                           counted(count_a, "sample", "samples"), count_b);
    }
    const EdgeSample &p = moment.a.sample->sample, &q = moment.b.sample->sample;
    const bool with_y = p.fragment.row != q.fragment.row || p.write.inside != q.write.inside;
    const bool with_x = p.fragment.column != q.fragment.column || !with_y;
    const int digits = std::max(digits_for(p.x, q.x), digits_for(p.y, q.y));
    return fmt::format("{}, {}. A: {}. B: {}.", edge_name(cursor.index),
                       element_name_of(sample_form, cursor.step, count_a),
                       sample_side(a, *moment.a.sample, with_x, with_y, digits),
                       sample_side(b, *moment.b.sample, with_x, with_y, digits));
}

/// "box row 3, pixel 7. A: pixel (7, 5), E = 48, 27, 33: inside. B: ..."
std::string test_text(const PairMoment& moment) {
    const auto side = [](const TestEvent* event) {
        if (event == nullptr) return std::string("no pixel is tested");
        return fmt::format("{}, {}", pixel_text(event->test.column, event->test.row),
                           pixel_test_text(event->test));
    };
    return fmt::format("{}, {}. A: {}. B: {}.", element_name(box_row_form, moment.cursor.index),
                       element_name(box_pixel_form, moment.cursor.step), side(moment.a.test),
                       side(moment.b.test));
}

/// What a run's row table has in the row of a moment: "has row 3 from column 12 to 40".
std::string row_ends(const Frame& frame, const Cursor& cursor) {
    PolygonRows rows;
    compute_rows(frame, cursor.triangle, rows);
    if (cursor.index >= rows.size()) {
        return fmt::format("has only {}", counted(rows.size(), "row", "rows"));
    }
    const int row = rows.first_row + cursor.index;
    if (rows.is_empty_row(cursor.index)) return fmt::format("has nothing in row {}", row);
    return fmt::format("has row {} from column {} to {}", row, rows.left[cursor.index].column,
                       rows.right[cursor.index].column);
}

std::string fate_text(const Frame& frame, const FragmentEvent& event, int digits) {
    const std::string depth = number(event.depth, digits);
    if (event.fate == Fate::back_facing) return depth + " is left out because it faces away";
    if (event.fate == Fate::cut_out) {
        return fmt::format("{} is cut out because the alpha of its texture is {}, below 1/2", depth,
                           number(event.alpha, 3));
    }
    if (depth_rule(frame.settings) == DepthTest::off) return depth + " is written without a test";
    return fmt::format("{} is {} {}", depth,
                       event.fate == Fate::written ? "written over" : "hidden by",
                       number(event.stored, digits));
}

std::string colour_text(const FragmentEvent& p, const FragmentEvent& q) {
    static constexpr std::array<std::string_view, 3> channels{"red", "green", "blue"};
    std::size_t worst = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        const auto apart = [&](std::size_t k) {
            return std::abs(p.after[static_cast<int>(k)] - q.after[static_cast<int>(k)]);
        };
        if (apart(i) > apart(worst)) worst = i;
    }
    const int digits = digits_for(p.after, q.after);
    const int channel = static_cast<int>(worst);
    return fmt::format("the colour is {} in A, {} in B; {} differs by {}", triple(p.after, digits),
                       triple(q.after, digits), channels[worst],
                       number(q.after[channel] - p.after[channel], 3));
}

/// The same colour, but shown differently.
std::string shown_text(const Frame& a, const Frame& b, const glm::vec3& colour) {
    const glm::vec3 in_a = shown_colour(colour, a.stages.screen);
    const glm::vec3 in_b = shown_colour(colour, b.stages.screen);
    return fmt::format("the colour {} is shown as {} in A, {} in B.", triple(colour, 6),
                       triple(in_a, 6), triple(in_b, 6));
}

/// For light per pixel: where in the room each run thinks the fragment is.
std::string place_text(const Frame& a, const Frame& b, const FragmentEvent& p,
                       const FragmentEvent& q) {
    if (shading_rule(a.settings) != Shading::phong || shading_rule(b.settings) != Shading::phong)
        return "";
    const glm::vec3 in_a = recover_varyings(p.fragment, a.stages).position_world;
    const glm::vec3 in_b = recover_varyings(q.fragment, b.stages).position_world;
    const float apart = glm::distance(in_a, in_b);
    if (!(apart > 0.0f)) return "";
    const int digits = digits_for(in_a, in_b);
    return fmt::format("; its position in the room is {} in A and {} in B, {} apart",
                       triple(in_a, digits), triple(in_b, digits), number(apart, 3));
}

std::string fragment_text(const Frame& a, const Frame& b, const FragmentEvent& p,
                          const FragmentEvent& q) {
    if (p.fragment.column != q.fragment.column || p.fragment.row != q.fragment.row) {
        return fmt::format("A {}, B {}.", row_ends(a, p.cursor), row_ends(b, q.cursor));
    }
    std::string text = pixel_text(p.fragment.column, p.fragment.row) + ": ";
    const int digits = std::max(digits_for(p.depth, q.depth), digits_for(p.stored, q.stored));
    if (p.fate != q.fate) {
        return text + fmt::format("{} = {} in A; {} in B.", depth_word(a, b),
                                  fate_text(a, p, digits), fate_text(b, q, digits));
    }
    const bool colours_differ = p.fate == Fate::written && p.after != q.after;
    if (p.depth != q.depth) {
        text += fmt::format("the depth value is {} in A, {} in B{}", number(p.depth, digits),
                            number(q.depth, digits), colours_differ ? "; " : ".");
    }
    const bool shown_otherwise = a.stages.screen != b.stages.screen;
    if (!colours_differ && p.depth == q.depth && shown_otherwise) {
        return text + shown_text(a, b, p.after);
    }
    if (!colours_differ) return text;
    return text + colour_text(p, q) + place_text(a, b, p, q) + ".";
}

std::string row_text(const Frame& a, const Frame& b, const PairMoment& moment) {
    const std::size_t count = std::min(moment.a.fragments.size(), moment.b.fragments.size());
    if (moment.a.fragments.size() != moment.b.fragments.size()) {
        if (has_fragments(a.settings.stage) != has_fragments(b.settings.stage)) {
            return mark_sentence(a, b,
                                 moment.a.fragments.size() > count ? DivergenceKind::missing
                                                                   : DivergenceKind::extra);
        }
        const bool only_a = moment.a.fragments.size() > count;
        const FragmentEvent& one = (only_a ? moment.a : moment.b).fragments[count];
        const std::string ends_a = row_ends(a, moment.cursor), ends_b = row_ends(b, moment.cursor);
        const std::string text = fmt::format("only {} draws {}: ", only_a ? "A" : "B",
                                             pixel_text(one.fragment.column, one.fragment.row));
        if (ends_a == ends_b) return text + "both " + ends_a + ", but not all of it is drawn.";
        return fmt::format("{}A {}, B {}.", text, ends_a, ends_b);
    }
    // Both ends of a row are one moment: the first that differs is reported.
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const FragmentEvent &p = moment.a.fragments[i], &q = moment.b.fragments[i];
        if (p.fragment.column != q.fragment.column || p.fragment.row != q.fragment.row ||
            p.fate != q.fate || p.after != q.after) {
            return fragment_text(a, b, p, q);
        }
    }
    return fragment_text(a, b, moment.a.fragments.back(), moment.b.fragments.back());
}

} // namespace

std::string divergence_text(const Frame& a, const Frame& b, const PairMoment& moment,
                            DivergenceKind kind) {
    const Cursor& cursor = moment.cursor;
    const int t = cursor.triangle;
    if (a.has_moments(t) != b.has_moments(t))
        return left_out_sentence(a.has_moments(t) ? "B" : "A",
                                 (a.has_moments(t) ? b : a).rejection(t));
    // If clip or cull removes the triangle, that is a separate moment.
    const bool shows_it =
        cursor.phase > Phase::cull || moment.a.fragments.size() != moment.b.fragments.size();
    if (shows_it && a.is_drawn(t) != b.is_drawn(t))
        return left_out_sentence(a.is_drawn(t) ? "B" : "A", (a.is_drawn(t) ? b : a).rejection(t));
    const bool one_is_idle = moment.a.is_nothing() || moment.b.is_nothing();
    const Stage first = std::min(a.settings.stage, b.settings.stage);
    switch (cursor.phase) {
    case Phase::vertices:
        if (moment.a.vertex == nullptr || moment.b.vertex == nullptr)
            return fmt::format("only {} has {}.", moment.b.vertex == nullptr ? "A" : "B",
                               vertex_name(cursor.index));
        if (moment.a.fragments.size() != moment.b.fragments.size()) {
            if (step_of(a.settings) != step_of(b.settings) || one_is_idle) {
                return mark_sentence(a, b, kind);
            }
            return outside_sentence(kind, moment.a.vertex->vertex.pixel,
                                    moment.b.vertex->vertex.pixel);
        }
        return vertex_text(a, b, moment);
    case Phase::clip:
        return clip_text(moment);
    case Phase::cull:
        return cull_text(moment);
    case Phase::edges:
        if (one_is_idle && first < Stage::edges) return stage_sentence(a, b, "edges");
        if (walks_edges(a.stages) != walks_edges(b.stages)) return mark_sentence(a, b, kind);
        if (moment.a.sample != nullptr && moment.b.sample != nullptr &&
            moment.a.fragments.size() != moment.b.fragments.size() &&
            moment.a.sample->sample.fragment.column == moment.b.sample->sample.fragment.column &&
            moment.a.sample->sample.fragment.row == moment.b.sample->sample.fragment.row) {
            return step_of(a.settings) != step_of(b.settings)
                       ? mark_sentence(a, b, kind)
                       : outside_sentence(kind, moment.a.sample->sample.fragment,
                                          moment.b.sample->sample.fragment);
        }
        return sample_text(a, b, moment);
    case Phase::tests:
        return test_text(moment);
    case Phase::rows:
        if (one_is_idle && first < Stage::rows) return stage_sentence(a, b, "rows");
        return row_text(a, b, moment);
    case Phase::resolve:
        break; // such runs are not compared moment by moment
    }
    return "";
}

} // namespace rasterwalk
