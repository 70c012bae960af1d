#include "ui/widgets/code_entries.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// The index in brackets: a number, or a variable.
std::optional<int> value_of_index(std::string_view index, const std::vector<CodeShown>& variables) {
    const auto known = std::find_if(variables.begin(), variables.end(),
                                    [&](const CodeShown& one) { return one.name == index; });
    if (known != variables.end()) index = known->value;
    int value = 0;
    const auto [end, error] = std::from_chars(index.data(), index.data() + index.size(), value);
    if (error != std::errc() || end != index.data() + index.size()) return std::nullopt;
    return value;
}

bool is_table_of_code(const Ui& ui) {
    return ui.code.is_ready && ui.results.a.triangle == ui.code.place.cursor.triangle;
}

int first_row(const Ui& ui) {
    return ui.results.a.rows.rows.first_row;
}

} // namespace

std::vector<CodeEntry> entries_in(std::string_view line, const std::vector<CodeShown>& variables) {
    struct Array {
        std::string_view name;
        bool is_left;
    };
    constexpr std::array arrays{Array{"leftPixels[", true}, Array{"rightPixels[", false}};
    std::vector<CodeEntry> entries;
    for (const Array& array : arrays) {
        const std::size_t at = line.find(array.name);
        if (at == line.npos) continue;
        std::string_view index = line.substr(at + array.name.size());
        index = index.substr(0, index.find(']'));
        if (const std::optional<int> value = value_of_index(index, variables))
            entries.push_back({*value, array.is_left});
    }
    return entries;
}

bool is_pointed_in_table(const Ui& ui, const CodeEntry& entry) {
    return is_table_of_code(ui) && ui.canvas.hovered_row == first_row(ui) + entry.index;
}

bool is_pointed_in_code(const Ui& ui, int row, bool is_left) {
    const auto is_it = [&](const CodeEntry& entry) {
        return entry.is_left == is_left && first_row(ui) + entry.index == row;
    };
    const std::vector<CodeEntry>& pointed = ui.code.pointed;
    return is_table_of_code(ui) && std::any_of(pointed.begin(), pointed.end(), is_it);
}

} // namespace rasterwalk
