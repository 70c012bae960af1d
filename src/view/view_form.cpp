#include "view/view_form.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "base/enumerated.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/quoted.h"
#include "session/second_run.h"
#include "settings/setting_table.h"

namespace rasterwalk {

void refuse_option(const GivenOption& option, std::string_view takes, const std::string& word) {
    throw UsageError(fmt::format("{} must be {}, not {}.", option.name, takes, in_quotes(word)));
}

std::string one_of(std::span<const std::string_view> words) {
    return enumerated({words.begin(), words.end()}, "or");
}

std::size_t option_index(const GivenOption& option, std::span<const std::string_view> words,
                         const std::string& word) {
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    throw UsageError(fmt::format("{} must be {}, not {}.{}", option.name, one_of(words),
                                 in_quotes(word), did_you_mean(word, words)));
}

std::string toml_text(std::string_view text) {
    std::ostringstream out;
    const toml::value<std::string> value{std::string(text)};
    out << toml::node_view<const toml::node>(value);
    return out.str();
}

std::string toml_list(const std::vector<std::string>& entries) {
    if (entries.empty()) return "[]";
    std::string list = "[\n";
    for (const std::string& entry : entries)
        list += fmt::format("    {},\n", toml_text(entry));
    return list + "]";
}

std::vector<std::string> read_assignments(const TomlBlock& block, const toml::node& node) {
    constexpr std::size_t most = 100;
    std::vector<std::string> list;
    block.for_each_text(node, most, [&](const std::string& assignment) {
        Settings tried;
        set_from_text(tried, assignment);
        list.push_back(assignment);
    });
    return list;
}

std::vector<std::string> assignments_between(const Settings& from, const Settings& to) {
    std::vector<std::string> list;
    for (const RunDifference& difference : run_differences(from, to))
        list.push_back(fmt::format("{}={}", difference.setting, difference.b));
    return list;
}

} // namespace rasterwalk
