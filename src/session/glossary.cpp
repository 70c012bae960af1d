#include "session/glossary.h"

#include "base/files.h"
#include "base/toml_input.h"

namespace rasterwalk {

std::vector<Term> parse_glossary(std::string_view text, const std::string& path) {
    const toml::table root = parse_toml(text, path);
    const TomlInput input(root, path, "the glossary");
    input.allow_only({"term"});
    std::vector<Term> terms;
    for (const toml::node& node : input.list("term")) {
        const TomlInput entry = input.table(node, "term " + std::to_string(terms.size() + 1));
        entry.allow_only({"word", "sentence", "section"});
        Term term{entry.text("word"), entry.text("sentence"), entry.text("section")};
        if (!terms.empty() && term.word <= terms.back().word) {
            entry.fail("the term '" + term.word + "' stands behind '" + terms.back().word +
                       "': terms are sorted, and each stands once.");
        }
        terms.push_back(std::move(term));
    }
    return terms;
}

std::vector<Term> read_glossary(const std::string& path) {
    return parse_glossary(read_file(path), path);
}

} // namespace rasterwalk
