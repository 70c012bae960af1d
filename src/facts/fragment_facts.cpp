#include "facts/fact_groups.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/limits.h"

namespace rasterwalk {

namespace {

const ValueRange place = whole(0, largest_viewport - 1); ///< column or row of the picture

const PixelHistory* history_of(const Facts& facts) {
    const std::optional<PixelHistory>& history = facts.results().history;
    return history ? &*history : nullptr;
}

/// What the picked pixel finally shows, if its z is known.
const PixelEntry* winner_in_front(const Facts& facts) {
    const PixelEntry* const winner = facts.winner();
    return winner != nullptr && winner->zinv > 0.0f ? winner : nullptr;
}

/// Pixels of the picked pixel's column that show the same part of the scene as it does.
std::optional<std::ptrdiff_t> part_in_column(const Facts& facts) {
    const PixelEntry* const winner = facts.winner();
    if (winner == nullptr) return std::nullopt;
    const Scene& scene = *facts.results().a.frame.scene;
    const int part = part_of(scene, winner->cursor.triangle);
    const std::vector<int>& owners = facts.column_owners();
    return std::count_if(owners.begin(), owners.end(),
                         [&](int owner) { return owner >= 0 && part_of(scene, owner) == part; });
}

/// An end of the selected row; none if no sample reached it.
std::optional<int> row_end(const Facts& facts, int end) {
    const std::optional<int> row = facts.table_row();
    if (!row || facts.table()->rows.is_empty_row(*row)) return std::nullopt;
    const PolygonRows& rows = facts.table()->rows;
    return (end == 0 ? rows.left : rows.right)[static_cast<std::size_t>(*row)].column;
}

/// Pixels from end to end of a row of the table, as the frame counts them.
std::int64_t count_row(const Facts& facts, int row) {
    const Stages& stages = facts.results().a.frame.stages;
    // Mistake B7 can count less than none.
    return std::max(row_span(stages, facts.table()->rows, row).count, 0);
}

std::optional<std::int64_t> table_count(const Facts& facts) {
    const std::optional<int> row = facts.table_row();
    return row ? std::optional(count_row(facts, *row)) : std::nullopt;
}

std::optional<std::int64_t> table_fragments(const Facts& facts) {
    const RowHistory* const table = facts.table();
    if (table == nullptr) return std::nullopt;
    std::int64_t sum = 0;
    for (int row = 0; row < table->rows.size(); ++row)
        sum += count_row(facts, row);
    return sum;
}

/// What the picked pixel takes from its texture.
void add_texture_facts(std::vector<Fact>& table) {
    const FactAdder<&Facts::texture> add(table);
    using Texels = const TextureReport&;
    // Below 0 only with mistake B67.
    const ValueRange texel = whole(1 - largest_texture_side, largest_texture_side - 1);
    add("pixel.u",
        "u of what the picked pixel finally shows: its position in the texture, from the left, 0 "
        "to 1.",
        real(), [](Texels t) { return t.place.texcoord.x; });
    add("pixel.v",
        "v of what the picked pixel finally shows: its position in the texture, from the top, 0 to "
        "1.",
        real(), [](Texels t) { return t.place.texcoord.y; });
    add("pixel.footprint",
        "How far the picked pixel reaches in the texture along its longer side, in texels.",
        real(0), [](Texels t) { return std::max(t.right, t.down); });
    add("pixel.level",
        "Level of the mip chain that matches the picked pixel, whether or not the filter uses it.",
        real(0), [](Texels t) { return t.level; });
    add("pixel.texels", "Number of texels that the picked pixel is mixed from: 1, 4 or 8.",
        whole(1, 8), [](Texels t) { return t.taken.count; });
    add("pixel.texel.column", "Column of the texel with the largest weight in the picked pixel.",
        texel, [](Texels t) { return t.heaviest().column; });
    add("pixel.texel.row", "Row of the texel with the largest weight in the picked pixel.", texel,
        [](Texels t) { return t.heaviest().row; });
    add("pixel.texel.level",
        "Level in the mip chain of the texel with the largest weight in the picked pixel.",
        natural(), [](Texels t) { return t.heaviest().level; });
}

/// How many fragments on a pixel meet this fate.
std::ptrdiff_t fragments_of_fate(const PixelHistory& history, Fate fate) {
    return std::count_if(history.entries.begin(), history.entries.end(),
                         [&](const PixelEntry& entry) { return entry.fate == fate; });
}

} // namespace

void add_pixel_facts(std::vector<Fact>& table) {
    const FactAdder<history_of> add(table);
    const FactAdder<&Facts::winner> add_winner(table);
    const FactAdder<winner_in_front> add_in_front(table);
    const FactAdder<&Facts::interpolation_error> add_error(table);
    const FactAdder<everything> add_any(table);
    using History = const PixelHistory&;
    using Entry = const PixelEntry&;
    add("pixel.column", "Column of the picked pixel.", place,
        [](History history) { return history.pixel.x; });
    add("pixel.row", "Row of the picked pixel.", place,
        [](History history) { return history.pixel.y; });
    add("pixel.fragments", "Fragments that fall on the picked pixel, drawn or not.", natural(),
        [](History history) { return history.entries.size(); });
    add("pixel.uncovered", "1 if nothing falls on the picked pixel.", yes_or_no(),
        [](History history) { return history.entries.empty(); });
    add("pixel.losers", "Fragments on the picked pixel that fail the depth test.", natural(),
        [](History history) { return fragments_of_fate(history, Fate::depth_failed); });
    add("pixel.cut_out", "Fragments on the picked pixel that the alpha of their texture cuts out.",
        natural(), [](History history) { return fragments_of_fate(history, Fate::cut_out); });
    add("pixel.owner", "Triangle that the picked pixel finally shows; -1 if none.",
        whole(-1, endless), [](History history) {
            const auto winner = static_cast<std::size_t>(history.winner);
            return history.winner < 0 ? -1 : history.entries[winner].cursor.triangle;
        });
    add_any("pixel.scene_triangle",
            "Triangle of the scene that the picked pixel finally shows, or a piece of it; none if "
            "it shows nothing.",
            natural(), [](const Facts& f) -> std::optional<int> {
                const std::optional<PixelHistory>& history = f.results().history;
                if (!history || history->winner < 0) return std::nullopt;
                const auto winner = static_cast<std::size_t>(history->winner);
                return scene_triangle(*f.results().a.frame.scene,
                                      history->entries[winner].cursor.triangle);
            });
    add_any("pixel.part_in_column",
            "Pixels of the picked pixel's column that show the same part of the scene.", natural(),
            [](const Facts& f) { return part_in_column(f); });
    add_winner("pixel.zinv",
               "1/z of what the picked pixel finally shows; 1/w under any other projection.",
               real(), [](Entry entry) { return entry.zinv; });
    add_winner("pixel.depth",
               "What the depth buffer holds, in the format of depth_format, for what the picked "
               "pixel finally shows.",
               real(), [](Entry entry) { return entry.depth; });
    add_in_front("pixel.z", "z of what the picked pixel finally shows.", real(),
                 [](Entry entry) { return entry.z; });
    add_any("pixel.z_ndc",
            "NDC z of what the picked pixel finally shows: 0 at the near plane, 1 at the far one.",
            real(), [](const Facts& f) {
                const PixelEntry* const entry = winner_in_front(f);
                return entry != nullptr ? z_ndc(f, entry->z) : Value();
            });
    for (int i = 0; i < 3; ++i) {
        add(
            "pixel." + channel_name(i),
            "The picked pixel's final " + channel_name(i) +
                ", linear, not clamped at 1 unless it is the mean of samples; 0 where nothing "
                "falls.",
            real(),
            [](History history, int channel) {
                const auto winner = static_cast<std::size_t>(history.winner);
                if (history.resolve) return history.resolve->colour[channel];
                return history.winner < 0 ? 0.0f : history.entries[winner].colour_after[channel];
            },
            i);
    }
    add_winner("pixel.alpha",
               "Alpha of the surface that the picked pixel finally shows; 1 if it is not blended.",
               real(0), [](Entry entry) { return entry.alpha; });
    add_error("pixel.light_error",
              "How far off the light is there with affine interpolation, in the channel that is "
              "off most; none for a pixel with several samples.",
              real(0), [](const InterpolationError& error) { return error.light; });
    add_error("pixel.position_error",
              "How far off the position is there with affine interpolation, in world units; none "
              "for a pixel with several samples.",
              real(0), [](const InterpolationError& error) { return error.position; });
    add_texture_facts(table);
}

void add_table_facts(std::vector<Fact>& table) {
    const FactAdder<&Facts::table> add(table);
    const FactAdder<everything> add_any(table);
    using Table = const RowHistory&;
    add("table.rows", "Rows of the row table of the triangle shown.", natural(),
        [](Table rows) { return rows.rows.size(); });
    add("table.first_row", "Row of the picture at which the table begins.",
        whole(-endless, endless), [](Table rows) { return rows.rows.first_row; });
    add("table.outside", "Edge samples that fall outside the table.", natural(),
        [](Table rows) { return rows.rows.outside; });
    add_any("table.fragments", "Pixels from end to end, over all rows of the table.", natural(),
            [](const Facts& f) { return table_fragments(f); });
    add_any(
        "table.left", "Left end of the selected row once the table is finished.",
        whole(-endless, endless), [](const Facts& f, int end) { return row_end(f, end); }, 0);
    add_any(
        "table.right", "Right end of the selected row once the table is finished.",
        whole(-endless, endless), [](const Facts& f, int end) { return row_end(f, end); }, 1);
    add_any("table.count", "Pixels of the selected row, both ends included.", natural(),
            [](const Facts& f) { return table_count(f); });
    for (int edge = 0; edge < triangle_corners; ++edge) {
        add(
            fmt::format("table.e{}.samples", edge),
            fmt::format("Number of samples of {} of the triangle shown.", edge_name(edge)),
            natural(),
            [](Table rows, int e) { return rows.edge_samples[static_cast<std::size_t>(e)]; }, edge);
    }
}

} // namespace rasterwalk
