#include "text/style.h"

#include <algorithm>
#include <unordered_map>

#include "base/files.h"
#include "base/letter_case.h"
#include "base/quoted.h"
#include "base/text_parts.h"
#include "base/toml_input.h"

namespace rasterwalk {

namespace {

Phrase phrase_of(const std::string& text, const TomlInput& entry) {
    Phrase phrase;
    const std::string quoted = in_quotes(text);
    if (text != in_small_letters(text))
        entry.fail(quoted + " has a capital, but phrases are compared in small letters.");
    for (const std::string_view place : split(text, ' ')) {
        const std::vector<std::string_view> words = split(place, '|');
        phrase.emplace_back(words.begin(), words.end());
        if (std::find(words.begin(), words.end(), "") != words.end())
            entry.fail(quoted + " has an empty word; put one space between words.");
    }
    const std::vector<std::string>& first = phrase.front();
    if (std::find(first.begin(), first.end(), "*") != first.end())
        entry.fail(quoted + " begins with '*', so it would match everywhere.");
    return phrase;
}

/// Does the phrase begin at this word?
bool is_at(const Phrase& phrase, const std::vector<ProseWord>& words, std::size_t at) {
    if (words.size() - at < phrase.size()) return false;
    for (std::size_t i = 0; i < phrase.size(); ++i) {
        const ProseWord& word = words[at + i];
        if (i > 0 && !word.follows) return false;
        const bool fits = std::any_of(phrase[i].begin(), phrase[i].end(), [&](const auto& one) {
            return one == "*" || one == word.text;
        });
        if (!fits) return false;
    }
    return true;
}

} // namespace

StyleGuide parse_style(std::string_view text, const std::string& path) {
    const toml::table root = parse_toml(text, path);
    const TomlInput input(root, path, "the file of phrases");
    input.allow_only({"rule", "meant"});
    StyleGuide guide;
    for (const toml::node& node : input.list("rule")) {
        const TomlInput entry = input.table(node, "the rule");
        entry.allow_only({"phrases", "advice"});
        for (const toml::node& phrase : entry.list("phrases")) {
            if (!phrase.is_string()) entry.fail(phrase, "a phrase must be text in quotes.");
            guide.rules.push_back({phrase_of(**phrase.as_string(), entry), entry.text("advice")});
        }
    }
    for (const toml::node& phrase : input.list("meant")) {
        if (!phrase.is_string()) input.fail(phrase, "a phrase must be text in quotes.");
        guide.meant.push_back(phrase_of(**phrase.as_string(), input));
    }
    return guide;
}

StyleGuide read_style(const std::string& path) {
    return parse_style(read_file(path), path);
}

std::vector<Fault> style_faults(const std::vector<ProseWord>& words, const StyleGuide& guide) {
    std::unordered_map<std::string_view, std::vector<const StyleRule*>> rules;
    for (const StyleRule& rule : guide.rules) {
        for (const std::string& first : rule.phrase.front())
            rules[first].push_back(&rule);
    }
    std::vector<bool> is_meant(words.size(), false);
    for (std::size_t at = 0; at < words.size(); ++at) {
        for (const Phrase& phrase : guide.meant) {
            if (!is_at(phrase, words, at)) continue;
            std::fill_n(is_meant.begin() + static_cast<std::ptrdiff_t>(at), phrase.size(), true);
        }
    }
    std::vector<Fault> faults;
    for (std::size_t at = 0; at < words.size(); ++at) {
        const auto those = rules.find(words[at].text);
        if (those == rules.end()) continue;
        for (const StyleRule* rule : those->second) {
            if (!is_at(rule->phrase, words, at)) continue;
            if (faults.size() == static_cast<std::size_t>(most_faults)) return faults;
            const auto begin = is_meant.begin() + static_cast<std::ptrdiff_t>(at);
            const auto end = begin + static_cast<std::ptrdiff_t>(rule->phrase.size());
            if (std::find(begin, end, false) == end) continue;
            std::string found;
            for (std::size_t i = 0; i < rule->phrase.size(); ++i)
                found += (i > 0 ? " " : "") + words[at + i].text;
            faults.push_back({words[at].line, "\"" + found + "\": " + rule->advice});
        }
    }
    return faults;
}

} // namespace rasterwalk
