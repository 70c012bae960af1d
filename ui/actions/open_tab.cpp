#include "ui/actions/open_tab.h"

#include "ui/ui.h"

namespace rasterwalk {

void open_tab(Ui& ui, std::string_view name) {
    ui.lesson.covers_inspector = name == lesson_tab_name;
    if (name != lesson_tab_name) ui.session.tab = name;
}

} // namespace rasterwalk
