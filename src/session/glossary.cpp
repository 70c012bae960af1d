#include "session/glossary.h"

#include "base/files.h"
#include "base/letter_case.h"
#include "base/toml_input.h"

namespace rasterwalk {

namespace {

/// Alphabetical order, in which a capital is next to its lower-case letter.
bool comes_before(std::string_view a, std::string_view b) {
    return in_small_letters(a) < in_small_letters(b);
}

bool is_marked_everyday(const TomlInput& entry) {
    const toml::node* const node = entry.find("everyday");
    if (node == nullptr) return false;
    const toml::value<bool>* const value = node->as_boolean();
    if (value == nullptr) entry.fail(*node, "'everyday' must be true or false.");
    return value->get();
}

} // namespace

std::vector<Term> parse_glossary(std::string_view text, const std::string& path) {
    const auto read = [](const TomlInput& entry, const std::vector<Term>& terms) {
        entry.allow_only({"word", "sentence", "section", "everyday"});
        Term term{entry.text("word"), entry.text("sentence"), entry.text("section"),
                  is_marked_everyday(entry)};
        if (!terms.empty() && !comes_before(terms.back().word, term.word)) {
            entry.fail("the term '" + term.word + "' comes after '" + terms.back().word +
                       "', but terms must be sorted and must not repeat.");
        }
        return term;
    };
    return parse_tables<Term>(text, path, "term", "the glossary", read);
}

std::vector<Term> read_glossary(const std::string& path) {
    return parse_glossary(read_file(path), path);
}

std::string section_words(std::string_view section, const Language& language) {
    const bool is_beyond = section.starts_with("Beyond the lab");
    return is_beyond ? std::string(section) : tr(language, "lab: {}", section);
}

} // namespace rasterwalk
