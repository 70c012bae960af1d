#pragma once

// The same number in the code and in the row table: pointing at one lights the other.

#include <string_view>
#include <vector>

#include "code/code_machine.h"

namespace rasterwalk {

struct CodeEntry;
struct Ui;

/// The entries of the row table that a line reads or writes: leftPixels[row] is one if `row` is
/// known.
std::vector<CodeEntry> entries_in(std::string_view line, const std::vector<CodeShown>& variables);

/// Is the row of the entry under the pointer in the table, and is it the triangle that the code is
/// at?
bool is_pointed_in_table(const Ui& ui, const CodeEntry& entry);

/// Is this entry of the table in the line of the code that is under the pointer?
/// @param row of the picture
bool is_pointed_in_code(const Ui& ui, int row, bool is_left);

} // namespace rasterwalk
