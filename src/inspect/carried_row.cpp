#include "inspect/carried_row.h"

namespace rasterwalk {

namespace {

/// The settings with light per vertex, which is carried in every stage. The sampling stays that of
/// the given stage, because ends and samples are those of the frame.
Settings settings_with_light(const Settings& given) {
    Settings settings = given;
    settings.hidden = hidden_rule(given);
    settings.draw_order = draw_order_rule(given);
    if (sampling_rule(given) == Sampling::centre) settings.samples = settings.supersample = 1;
    set_step(settings, StripStep::vertex_light);
    return settings;
}

} // namespace

std::span<const QuantityInfo> quantity_list() {
    static const std::vector<QuantityInfo> list = [] {
        std::vector<QuantityInfo> made{
            {Quantity::zinv,
             {"zinv", "1/z", "1/z",
              "1/z in camera space. It changes in equal steps along a row and is correct "
              "everywhere."}},
            {Quantity::z,
             {"z", "z", "1/z", "Depth in camera space, interpolated as it is, or as 1 / (1/z)."}}};
        for (int v = 0; v < varying_count; ++v) {
            const VaryingInfo& varying = varying_list[static_cast<std::size_t>(v)];
            for (int c = 0; c < varying.count; ++c) {
                made.push_back(
                    {quantity_of(v, c), varying.components[static_cast<std::size_t>(c)], v, c});
            }
        }
        return made;
    }();
    return list;
}

QuantityInfo quantity_in(const Frame& frame, Quantity quantity) {
    QuantityInfo info = quantity_info(quantity);
    const std::string_view weight = weight_name(frame);
    if (is_varying(quantity) || weight == info.words.carried_name) return info;
    info.words.carried_name = weight;
    if (quantity == Quantity::zinv) {
        info.words.name = weight;
        info.words.help = "One over w. It changes in equal steps along a row, and not at all if "
                          "the rays are parallel.";
    } else {
        info.words.help = "Depth in camera space, interpolated as it is, or from 1/w.";
    }
    return info;
}

std::string carried_name_in(const Frame& frame, Quantity quantity) {
    std::string name(quantity_in(frame, quantity).words.carried_name);
    const std::size_t at = name.rfind("/z");
    if (weight_name(frame) == "1/w" && at != std::string::npos) name.replace(at, 2, "/w");
    return name;
}

std::vector<QuantityInfo> shown_quantities(const Frame& frame) {
    const VaryingSet shown = carried_varyings(frame) | varyings_with(VaryingUse::listed);
    std::vector<QuantityInfo> list;
    for (const QuantityInfo& info : quantity_list()) {
        if (!is_varying(info.quantity) || shown.has(info.varying))
            list.push_back(quantity_in(frame, info.quantity));
    }
    return list;
}

float part_of(const Varyings& varyings, Quantity quantity) {
    const QuantityInfo& info = quantity_info(quantity);
    return varying_list[static_cast<std::size_t>(info.varying)].component(varyings, info.component);
}

void CarriedRow::walk_from(Interpolation mode, int first, std::span<LineSample> result) const {
    const auto i = static_cast<std::size_t>(mode);
    const Row ends_of_row{under(mode).left, under(mode).right, row, count, &tested[i]};
    stages[i].row_fragments(stages[i], ends_of_row, first, VaryingSet::all(), result);
}

std::vector<Fragment> CarriedRow::fragments(Interpolation mode) const {
    std::vector<LineSample> samples(static_cast<std::size_t>(count));
    walk_from(mode, 0, samples);
    std::vector<Fragment> fragments;
    fragments.reserve(samples.size());
    for (const LineSample& sample : samples)
        fragments.push_back(sample.fragment);
    return fragments;
}

Fragment CarriedRow::at(Interpolation mode, int step) const {
    LineSample sample;
    walk_from(mode, step, {&sample, 1});
    return sample.fragment;
}

std::optional<CarriedRow> carried_row(const Frame& frame, int triangle, int index) {
    CarriedRow row;
    row.triangle = triangle;
    row.index = index;
    row.walk = frame.settings.line_walk;
    const EdgeRules edges = edge_rules(frame.settings);
    for (const Interpolation mode : all_interpolations) {
        Settings settings = settings_with_light(frame.settings);
        settings.interpolation = mode;
        PolygonRows rows;
        const Stages stages = stages_for(settings, *frame.scene, frame.replace);
        stages.compute_polygon_rows(polygon_under(frame, triangle, settings), edges, stages, rows,
                                    nullptr);
        if (index < 0 || index >= rows.size() || rows.is_empty_row(index)) return std::nullopt;
        const auto i = static_cast<std::size_t>(index);
        row.stages[static_cast<std::size_t>(mode)] = stages;
        row.ends[static_cast<std::size_t>(mode)] = {rows.left[i], rows.right[i]};
        row.tested[static_cast<std::size_t>(mode)] = rows.tested;
        row.row = rows.first_row + index;
        row.row_count = rows.size();
        row.count = row_span(stages, rows, index).count;
    }
    const RowHistory history = row_history(frame, triangle);
    if (index < history.rows.size()) {
        row.left_by = history.left_by[static_cast<std::size_t>(index)];
        row.right_by = history.right_by[static_cast<std::size_t>(index)];
    }
    return row;
}

} // namespace rasterwalk
