#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "engines/program_drawing.h"
#include "session/moments.h"
#include "settings/setting_table.h"
#include "ui/actions/compare.h"
#include "ui/inspector/compare_parts.h"
#include "ui/inspector/history_parts.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/swatch.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// So many writes are listed; a program may put a pixel as often as it likes.
constexpr std::size_t most_listed_writes = 20;

void draw_write(Ui& ui, const ProgramWrite& write, std::size_t line) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float size = ImGui::GetTextLineHeight();
    draw_swatch(ui, at, size, write.colour, 1.0f, swatch_border);
    ImGui::SetCursorScreenPos({at.x + size + ImGui::GetStyle().ItemSpacing.x, at.y});
    const std::string text = fmt::format("pixel {} of the program: {:.3f} {:.3f} {:.3f}",
                                         grouped(static_cast<std::int64_t>(write.index)),
                                         write.colour.r, write.colour.g, write.colour.b);
    put_text(text);
    const std::string name = "history.program." + std::to_string(line);
    register_widget(ui, name,
                    "The number of the pixel in the order in which your program puts them, from "
                    "0, and its colour, which it has given to PutPixel.");
    register_text(ui, name, text);
}

} // namespace

void draw_program_run(Ui& ui) {
    const ProgramDrawing& program = *ui.session.b->program;
    wrapped_text(fmt::format("Run B is {}, as it was when it was last run. Run A is our picture, "
                             "by the rules that your program was found to have.",
                             program.name));
    register_widget(ui, "compare.program", "What is compared.");
    const std::vector<RunDifference> differences = run_differences(ui.session);
    for (const RunDifference& difference : differences)
        wrapped_text(fmt::format("{}: {} in run A, {} in your program",
                                 find_setting(difference.setting)->title, difference.a,
                                 difference.b));
}

void draw_program_parting(Ui& ui) {
    const Comparison& found = ui.results.comparison.whole();
    begin_card(ui);
    if (const std::optional<Divergence>& first = found.divergences.first) {
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
        if (button(ui, "compare.parting", moment_name(first->cursor), Look::link,
                   describe_moment(ui.results.a.frame, first->cursor) +
                       "\nClick to go there in both runs."))
            stand_at(ui, first->cursor);
        ImGui::PopStyleVar();
        wrapped_text(first->text);
        register_text(ui, "compare.parting", first->text);
    } else if (ui.session.b->program->parting) {
        wrapped_text("With these settings run A has other moments than your program's own rules "
                     "give it, so the order of the pixels is not compared.");
    } else {
        wrapped_text("Your program puts the same pixels as we do, in the same order.");
    }
    end_card(ui);
}

void draw_program_writes(Ui& ui) {
    const ProgramWrites& writes = ui.results.program_writes;
    if (writes.program == nullptr) return;
    begin_card(ui);
    const std::size_t count = writes.puts.size();
    wrapped_text(count == 0
                     ? writes.program->name + " never puts this pixel."
                     : fmt::format("{} puts this pixel {}.", writes.program->name,
                                   counted(static_cast<std::int64_t>(count), "time", "times")));
    register_widget(ui, "history.program", "What your program puts on this pixel.");
    for (std::size_t i = 0; i < std::min(writes.puts.size(), most_listed_writes); ++i)
        draw_write(ui, writes.puts[i], i);
    if (writes.puts.size() > most_listed_writes)
        put_text(fmt::format("and {} more", grouped(static_cast<std::int64_t>(
                                                writes.puts.size() - most_listed_writes))));
    end_card(ui);
}

} // namespace rasterwalk
