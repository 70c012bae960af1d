#include "facts/fact_groups.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/limits.h"

namespace rasterwalk {

namespace {

const ValueRange place = whole(0, largest_viewport - 1); ///< column or row of the picture

Value pixel_place(const Facts& facts, int axis) {
    const std::optional<PixelHistory>& history = facts.results().history;
    return history ? number(axis == 0 ? history->pixel.x : history->pixel.y) : Value();
}

Value pixel_channel(const Facts& facts, int channel) {
    if (!facts.results().history) return {};
    const PixelEntry* const winner = facts.winner();
    return winner != nullptr ? number(winner->colour_after[channel]) : number(0);
}

Value edge_samples(const Facts& facts, int edge) {
    const RowHistory* const table = facts.table();
    if (table == nullptr) return {};
    return number(table->edge_samples[static_cast<std::size_t>(edge)]);
}

/// Pixels of the picked pixel's column that show the same part of the scene as it does.
Value part_in_column(const Facts& facts, int) {
    const PixelEntry* const winner = facts.winner();
    if (winner == nullptr) return {};
    const Scene& scene = *facts.results().a.frame.scene;
    const int part = part_of(scene, winner->cursor.triangle);
    const std::vector<int>& owners = facts.column_owners();
    return number(std::count_if(owners.begin(), owners.end(), [&](int owner) {
        return owner >= 0 && part_of(scene, owner) == part;
    }));
}

/// A number of the texture that the picked pixel shows; none if it shows none.
template <auto read>
Value texture_number(const Facts& facts, int) {
    const TextureReport* const texture = facts.texture();
    return texture != nullptr ? number(read(*texture)) : Value();
}

/// An end of the selected row; none if no sample reached it.
Value row_end(const Facts& facts, int end) {
    const std::optional<int> row = facts.table_row();
    if (!row || facts.table()->rows.is_empty_row(*row)) return {};
    const PolygonRows& rows = facts.table()->rows;
    return number((end == 0 ? rows.left : rows.right)[static_cast<std::size_t>(*row)].column);
}

/// Pixels from end to end of a row of the table, as the frame counts them.
std::int64_t count_row(const Facts& facts, int row) {
    const Stages& stages = facts.results().a.frame.stages;
    // Mistake B7 can count less than none.
    return std::max(row_span(stages, facts.table()->rows, row).count, 0);
}

Value table_count(const Facts& facts, int) {
    const std::optional<int> row = facts.table_row();
    return row ? number(count_row(facts, *row)) : Value();
}

Value table_fragments(const Facts& facts, int) {
    const RowHistory* const table = facts.table();
    if (table == nullptr) return {};
    std::int64_t sum = 0;
    for (int row = 0; row < table->rows.size(); ++row)
        sum += count_row(facts, row);
    return number(sum);
}

/// What the picked pixel takes from its texture.
void add_texture_facts(std::vector<Fact>& table) {
    using Texels = const TextureReport&;
    // Below 0 only with mistake B67.
    const ValueRange texel = whole(1 - largest_texture_side, largest_texture_side - 1);
    table.push_back({"pixel.u",
                     "u of what the picked pixel finally shows: its position in the texture, "
                     "from the left, 0 to 1.",
                     real(), texture_number<[](Texels t) { return t.place.texcoord.x; }>});
    table.push_back({"pixel.v",
                     "v of what the picked pixel finally shows: its position in the texture, "
                     "from the top, 0 to 1.",
                     real(), texture_number<[](Texels t) { return t.place.texcoord.y; }>});
    table.push_back({"pixel.footprint",
                     "How far the picked pixel reaches in the texture along its longer side, in "
                     "texels.",
                     real(0), texture_number<[](Texels t) { return std::max(t.right, t.down); }>});
    table.push_back({"pixel.level",
                     "Level of the mip chain that matches the picked pixel, whether or not the "
                     "filter uses it.",
                     real(0), texture_number<[](Texels t) { return t.level; }>});
    table.push_back({"pixel.texels",
                     "Number of texels that the picked pixel is mixed from: 1, 4 "
                     "or 8.",
                     whole(1, 8), texture_number<[](Texels t) { return t.taken.count; }>});
    table.push_back({"pixel.texel.column",
                     "Column of the texel with the largest weight in the picked pixel.", texel,
                     texture_number<[](Texels t) { return t.heaviest().column; }>});
    table.push_back({"pixel.texel.row",
                     "Row of the texel with the largest weight in the picked "
                     "pixel.",
                     texel, texture_number<[](Texels t) { return t.heaviest().row; }>});
    table.push_back({"pixel.texel.level",
                     "Level in the mip chain of the texel with the largest weight in the picked "
                     "pixel.",
                     natural(), texture_number<[](Texels t) { return t.heaviest().level; }>});
}

/// How many fragments on the picked pixel meet this fate.
Value fragments_of_fate(const Facts& f, int fate) {
    const auto& history = f.results().history;
    if (!history) return {};
    return number(
        std::count_if(history->entries.begin(), history->entries.end(),
                      [&](const PixelEntry& e) { return static_cast<int>(e.fate) == fate; }));
}

} // namespace

void add_pixel_facts(std::vector<Fact>& table) {
    table.push_back({"pixel.column", "Column of the picked pixel.", place, pixel_place, 0});
    table.push_back({"pixel.row", "Row of the picked pixel.", place, pixel_place, 1});
    table.push_back({"pixel.fragments", "Fragments that fall on the picked pixel, drawn or not.",
                     natural(), [](const Facts& f, int) {
                         const auto& history = f.results().history;
                         return history ? number(static_cast<std::int64_t>(history->entries.size()))
                                        : Value();
                     }});
    table.push_back({"pixel.uncovered", "1 if nothing falls on the picked pixel.", yes_or_no(),
                     [](const Facts& f, int) {
                         const auto& history = f.results().history;
                         return history ? number(history->entries.empty() ? 1 : 0) : Value();
                     }});
    table.push_back({"pixel.losers", "Fragments on the picked pixel that fail the depth test.",
                     natural(), fragments_of_fate, static_cast<int>(Fate::depth_failed)});
    table.push_back({"pixel.cut_out",
                     "Fragments on the picked pixel that the alpha of their texture cuts out.",
                     natural(), fragments_of_fate, static_cast<int>(Fate::cut_out)});
    table.push_back({"pixel.owner", "Triangle that the picked pixel finally shows; -1 if none.",
                     whole(-1, endless), [](const Facts& f, int) {
                         if (!f.results().history) return Value();
                         const PixelEntry* const winner = f.winner();
                         return number(winner != nullptr ? winner->cursor.triangle : -1);
                     }});
    table.push_back({"pixel.part_in_column",
                     "Pixels of the picked pixel's column that show the same part of the scene.",
                     natural(), part_in_column});
    table.push_back({"pixel.zinv",
                     "1/z of what the picked pixel finally shows; 1/w under any other "
                     "projection.",
                     real(), [](const Facts& f, int) {
                         const PixelEntry* const winner = f.winner();
                         return winner != nullptr ? number(winner->zinv) : Value();
                     }});
    table.push_back({"pixel.depth",
                     "What the depth buffer holds, in the format of depth_format, for what the "
                     "picked pixel finally shows.",
                     real(), [](const Facts& f, int) {
                         const PixelEntry* const winner = f.winner();
                         return winner != nullptr ? number(winner->depth) : Value();
                     }});
    table.push_back(
        {"pixel.z", "z of what the picked pixel finally shows.", real(), [](const Facts& f, int) {
             const PixelEntry* const winner = f.winner();
             return winner != nullptr && winner->zinv > 0.0f ? number(winner->z) : Value();
         }});
    table.push_back({"pixel.z_ndc",
                     "NDC z of what the picked pixel finally shows: 0 at the near plane, 1 at "
                     "the far one.",
                     real(), [](const Facts& f, int) {
                         const PixelEntry* const winner = f.winner();
                         return winner != nullptr && winner->zinv > 0.0f ? z_ndc(f, winner->z)
                                                                         : Value();
                     }});
    constexpr std::array<const char*, 3> channels{"red", "green", "blue"};
    for (int i = 0; i < 3; ++i) {
        const std::string channel = channels[static_cast<std::size_t>(i)];
        table.push_back({"pixel." + channel,
                         "The picked pixel's final " + channel +
                             ", linear, not clamped at 1; 0 where nothing falls.",
                         real(), pixel_channel, i});
    }
    table.push_back(
        {"pixel.alpha",
         "Alpha of the surface that the picked pixel finally shows; 1 if it is not blended.",
         real(0), [](const Facts& f, int) {
             const PixelEntry* const winner = f.winner();
             return winner == nullptr ? Value() : number(winner->alpha);
         }});
    table.push_back({"pixel.light_error",
                     "How far off the light is there with affine interpolation, in the channel "
                     "that is off most.",
                     real(0), [](const Facts& f, int) {
                         const auto error = f.interpolation_error();
                         return error ? number(error->light) : Value();
                     }});
    table.push_back({"pixel.position_error",
                     "How far off the position is there with affine interpolation, in world units.",
                     real(0), [](const Facts& f, int) {
                         const auto error = f.interpolation_error();
                         return error ? number(error->position) : Value();
                     }});
    add_texture_facts(table);
}

void add_table_facts(std::vector<Fact>& table) {
    table.push_back({"table.rows", "Rows of the row table of the triangle shown.", natural(),
                     [](const Facts& f, int) {
                         return f.table() != nullptr ? number(f.table()->rows.size()) : Value();
                     }});
    table.push_back({"table.first_row", "Row of the picture at which the table begins.",
                     whole(-endless, endless), [](const Facts& f, int) {
                         return f.table() != nullptr ? number(f.table()->rows.first_row) : Value();
                     }});
    table.push_back({"table.outside", "Edge samples that fall outside the table.", natural(),
                     [](const Facts& f, int) {
                         return f.table() != nullptr ? number(f.table()->rows.outside) : Value();
                     }});
    table.push_back({"table.fragments", "Pixels from end to end, over all rows of the table.",
                     natural(), table_fragments});
    table.push_back({"table.left", "Left end of the selected row once the table is finished.",
                     whole(-endless, endless), row_end, 0});
    table.push_back({"table.right", "Right end of the selected row once the table is finished.",
                     whole(-endless, endless), row_end, 1});
    table.push_back(
        {"table.count", "Pixels of the selected row, both ends included.", natural(), table_count});
    for (int edge = 0; edge < triangle_corners; ++edge) {
        table.push_back(
            {fmt::format("table.e{}.samples", edge),
             fmt::format("Number of samples of {} of the triangle shown.", edge_name(edge)),
             natural(), edge_samples, edge});
    }
}

} // namespace rasterwalk
