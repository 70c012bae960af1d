#pragma once

#include <span>
#include <string_view>

namespace rasterwalk {

/// The widgets of the window that a lesson can point at. In these patterns `#` stands for a number,
/// `{stage}`, `{tab}`, `{setting}` and `{overlay}` for one of their names.
std::span<const std::string_view> widget_patterns();

/// Does the window have a widget of this name, at one time or another?
bool is_widget_name(std::string_view name);

/// Throws UsageError with a sentence, and the name that comes near, if it has none.
void check_widget_name(std::string_view name);

} // namespace rasterwalk
