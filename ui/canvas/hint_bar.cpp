#include "ui/canvas/hint_bar.h"

#include <algorithm>

#include "settings/setting_table.h"
#include "ui/canvas/notice_bar.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

bool is_hidden(const Ui& ui, const SeenHint& hint) {
    const HiddenHints& hidden = ui.canvas.hidden_hints;
    return hidden.scene.lock() == ui.session.scene &&
           std::find(hidden.acts.begin(), hidden.acts.end(), hint.act) != hidden.acts.end();
}

void hide(Ui& ui, const SeenHint& hint) {
    HiddenHints& hidden = ui.canvas.hidden_hints;
    if (hidden.scene.lock() != ui.session.scene) hidden = {ui.session.scene, {}};
    hidden.acts.push_back(hint.act);
}

} // namespace

void draw_hint_bar(Ui& ui) {
    const PictureHints& hints = ui.results.hints;
    if (hides_settings(ui.session) || hints.scene != ui.session.scene) return;
    const auto shown = std::find_if(hints.found.begin(), hints.found.end(),
                                    [&](const SeenHint& hint) { return !is_hidden(ui, hint); });
    if (shown == hints.found.end()) return;
    const SeenHint& hint = *shown;
    const NoticeButton act{"canvas.hint_act", hint.act, hint.help};
    const NoticeButton no{"canvas.hint_hide", "hide", "Stops showing this for this model."};
    const std::string without_numbers = hint.seen.substr(0, hint.seen.find(','));
    const std::string_view clicked =
        draw_notice_bar(ui, "canvas.hint", {hint.seen, without_numbers, hint.in_short, ""},
                        hint.seen + ".\n" + hint.help, !hints.are_due, std::vector{act, no});
    if (clicked == act.name) {
        for (const std::string& assignment : hint.settings)
            set_from_text(ui.session.a.settings, assignment);
    }
    if (clicked == no.name) hide(ui, hint);
}

} // namespace rasterwalk
