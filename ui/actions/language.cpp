#include "ui/actions/language.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/language_files.h"
#include "session/content.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"

namespace rasterwalk {

namespace {

/// English comes first. A language whose texts cannot be read goes by its code: choosing it says
/// what is wrong.
std::vector<LanguageChoice> read_choices(const std::string& folder) {
    std::vector<LanguageChoice> choices{{english().code, english().name}};
    for (const std::string& code : language_codes(folder)) {
        LanguageChoice& choice = choices.emplace_back(LanguageChoice{code, code});
        try {
            choice.name = read_language(folder, code).name;
        } catch (const Error&) {
            continue;
        }
    }
    return choices;
}

void read_chosen_language(Ui& ui) {
    Language language;
    try {
        if (!ui.options.language.empty())
            language = read_language(lessons_folder(), ui.options.language);
    } catch (const Error& fault) {
        ui.session.notice = fault.what();
        ui.refused_language = ui.options.language;
    }
    language.asked = ui.language.asked;
    ui.language = std::move(language);
    ui.lesson.lessons.set_language(ui.language.code);
}

} // namespace

void renew_language(Ui& ui) {
    if (ui.language_choices.empty()) {
        ui.language_choices = {{english().code, english().name}};
        ui.language_choices = read_choices(lessons_folder());
    }
    const std::string& wished = ui.options.language;
    const bool is_refused = !wished.empty() && wished == ui.refused_language;
    if (wished != ui.language.code && !is_refused) read_chosen_language(ui);
    use_language(ui.language);
}

void choose_language(Ui& ui, const std::string& code) {
    ui.options.language = code;
    ui.refused_language.clear();
}

const LanguageChoice& next_language(const Ui& ui) {
    const std::vector<LanguageChoice>& choices = ui.language_choices;
    const auto now =
        std::find_if(choices.begin(), choices.end(),
                     [&](const LanguageChoice& choice) { return choice.code == ui.language.code; });
    return now == choices.end() || now + 1 == choices.end() ? choices.front() : *(now + 1);
}

} // namespace rasterwalk
