#include "ui/actions/actions.h"

#include "ui/actions/action_menus.h"

namespace rasterwalk {

std::span<const Action> action_table() {
    static const std::vector<Action> table = [] {
        std::vector<Action> all;
        for (const auto menu : {file_actions, edit_actions, view_actions, stage_actions,
                                compare_actions, walk_actions, lesson_actions, help_actions}) {
            for (Action& action : menu())
                all.push_back(std::move(action));
        }
        return all;
    }();
    return table;
}

} // namespace rasterwalk
