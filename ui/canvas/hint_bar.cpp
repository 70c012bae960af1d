#include "ui/canvas/hint_bar.h"

#include <algorithm>

#include "settings/setting_table.h"
#include "ui/canvas/notice_bar.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

bool is_hidden(const Ui& ui, const VisibilityHint& hint) {
    const HiddenHints& hidden = ui.canvas.hidden_hints;
    return hidden.scene.lock() == ui.session.scene &&
           std::find(hidden.in_short.begin(), hidden.in_short.end(), hint.in_short) !=
               hidden.in_short.end();
}

void hide(Ui& ui, const VisibilityHint& hint) {
    HiddenHints& hidden = ui.canvas.hidden_hints;
    if (hidden.scene.lock() != ui.session.scene) hidden = {ui.session.scene, {}};
    hidden.in_short.push_back(hint.in_short);
}

} // namespace

void draw_hint_bar(Ui& ui) {
    const PictureHints& hints = ui.results.hints;
    if (hides_settings(ui.session) || hints.scene != ui.session.scene) return;
    const auto first =
        std::find_if(hints.found.begin(), hints.found.end(),
                     [&](const VisibilityHint& hint) { return !is_hidden(ui, hint); });
    if (first == hints.found.end()) return;
    // Another remedy for the same problem.
    const auto other = std::find_if(first + 1, hints.found.end(), [&](const VisibilityHint& hint) {
        return hint.finding == first->finding;
    });
    const NoticeButton act{"canvas.hint_act", first->act, first->help};
    const NoticeButton no{"canvas.hint_hide", "hide", "Hides this hint for this model."};
    std::vector<NoticeButton> buttons{act, no};
    if (other != hints.found.end())
        buttons.insert(buttons.begin() + 1, {"canvas.hint_other", other->act, other->help});
    const std::string without_numbers = first->finding.substr(0, first->finding.find(','));
    const std::string_view clicked =
        draw_notice_bar(ui, "canvas.hint", {first->finding, without_numbers, first->in_short},
                        first->finding + ".\n" + first->help, !hints.are_due, buttons);
    const auto set = [&](const VisibilityHint& hint) {
        for (const std::string& assignment : hint.settings)
            set_from_text(ui.session.a.settings, assignment);
    };
    if (clicked == act.name) set(*first);
    if (clicked == no.name) hide(ui, *first);
    if (clicked == "canvas.hint_other") set(*other);
}

} // namespace rasterwalk
