#include "cli/shown_options.h"

#include <CLI/CLI.hpp>

namespace rasterwalk {

namespace {

ShownOption shown_option(const CLI::Option& option) {
    ShownOption shown{option.get_group(), {}, {}, option.get_description(), option.get_required()};
    for (const std::string& name : option.get_snames())
        shown.names.push_back('-' + name);
    for (const std::string& name : option.get_lnames())
        shown.names.push_back("--" + name);
    if (shown.names.empty())
        shown.value = option.get_name(true);
    else if (option.get_items_expected_max() > 0)
        shown.value = option.get_type_name();
    return shown;
}

} // namespace

std::vector<ShownOption> shown_options(const CLI::App& app) {
    std::vector<ShownOption> shown;
    for (const std::string& group : app.get_groups()) {
        if (group.empty()) continue;
        for (const CLI::Option* option : app.get_options())
            if (option->get_group() == group) shown.push_back(shown_option(*option));
    }
    return shown;
}

} // namespace rasterwalk
