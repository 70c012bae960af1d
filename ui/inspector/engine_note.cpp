#include <string>

#include <fmt/format.h>

#include "settings/value_words.h"
#include "ui/inspector/inspector_parts.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

void draw_engine_note(Ui& ui) {
    const RunResults& run = ui.results.a;
    if (run.engine == Engine::steps) return;
    const std::string words =
        fmt::format("The picture is drawn by {}. These are the numbers of the steps.",
                    value_words(*find_setting("engine"), run.frame.settings));
    wrapped_text_in(palette(ui.options.theme).dim, words, ui.fonts.small);
    register_widget(ui, "inspector.engine",
                    "Only the steps have fragments. The colour in the status line is the one in "
                    "the picture.",
                    words);
}

} // namespace rasterwalk
