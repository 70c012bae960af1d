#pragma once

// How the rows of view_table() are made: a value's form as text and its place in the session are
// given once, and all functions of a field follow from them.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/enum_words.h"
#include "view/view_table.h"

namespace rasterwalk {

/// A field whose value is an optional member of ViewState.
template <class T>
struct ViewForm {
    std::optional<T> ViewState::*member;
    std::function<T(const TomlBlock&, const toml::node&)> read{};
    std::function<std::string(const T&)> toml{}; ///< missing: a saved view cannot hold it
    /// From one word of an option; none clears it. Missing: see ViewField::parse.
    std::function<std::optional<T>(const GivenOption&, const std::string&)> parse{};
    std::function<std::string(const std::optional<T>&)> word{};     ///< what parse() reads again
    std::function<std::optional<T>(const Session&)> read_session{}; ///< none: as in a fresh session
    std::function<void(const std::optional<T>&, Session&)> show{};
};

/// "--zoom is a number from 0.25 to 64 or fit, not 'x'."
[[noreturn]] void refuse_option(const GivenOption& option, std::string_view takes,
                                const std::string& word);

/// "colour, depth or triangle", as help and messages list the choices.
std::string one_of(std::span<const std::string_view> words);

/// The index of an option's word in a list. Throws UsageError that names them all.
std::size_t option_index(const GivenOption& option, std::span<const std::string_view> words,
                         const std::string& word);

/// As TOML values: text in quotes; a list, one line per entry.
std::string toml_text(std::string_view text);
std::string toml_list(const std::vector<std::string>& entries);

/// Settings, name=value, one by one; each must be one.
std::vector<std::string> read_assignments(const TomlBlock& block, const toml::node& node);

/// What `to` sets differently from `from`.
std::vector<std::string> assignments_between(const Settings& from, const Settings& to);

/// With this word an option clears its field.
inline constexpr std::string_view no_value = "none";

template <class T>
ViewField make_field(std::string_view key, ViewPart part, ViewOption option, ViewForm<T> form) {
    ViewField field;
    field.key = key;
    field.part = part;
    field.option = std::move(option);
    const auto member = form.member;
    field.take = [member](const ViewState& over, ViewState& state) {
        if (over.*member) state.*member = over.*member;
    };
    field.clear = [member](ViewState& state) { state.*member = std::nullopt; };
    if (form.read) {
        field.read = [member, read = std::move(form.read)](
                         const TomlBlock& block, const toml::node& node, ViewState& state) {
            state.*member = read(block, node);
        };
    }
    if (form.toml) {
        field.write = [member, toml = std::move(form.toml)](const ViewState& state) {
            return state.*member ? toml(*(state.*member)) : std::string();
        };
    }
    if (form.parse) {
        field.parse = [member, parse = std::move(form.parse)](const GivenOption& given,
                                                              ViewState& state) {
            state.*member = parse(given, given.words.back());
        };
    }
    if (form.word) {
        field.words = [member, word = std::move(form.word)](const ViewChange& change) {
            std::vector<std::string> words;
            if (change.to.*member != change.from.*member) words.push_back(word(change.to.*member));
            return words;
        };
    }
    if (form.read_session) {
        field.read_session = [member, read_session = std::move(form.read_session)](
                                 const Session& session, const Scene&, ViewState& state) {
            state.*member = read_session(session);
        };
    }
    if (form.show) {
        field.show = [member, show = std::move(form.show)](const ViewState& state,
                                                           Session& session) {
            show(state.*member, session);
        };
    }
    return field;
}

/// One of several values that have a word each.
/// @param what its name in messages
/// @param shown the function that finds it in a session
/// @param keeps_last if not given, it stays as it was; otherwise it becomes the usual one
template <class Enum, class Shown>
ViewField word_field(std::string_view key, ViewPart part, const ViewOption& option,
                     const char* what, std::optional<Enum> ViewState::*member, Shown shown,
                     bool keeps_last) {
    ViewForm<Enum> form{member};
    const auto usual = [shown] {
        const Session session{};
        return Enum{shown(session)};
    };
    form.read = [what](const TomlBlock& block, const toml::node& node) {
        return *value_of_word<Enum>(block.word(node, what, enum_words<Enum>));
    };
    form.toml = [](Enum value) { return toml_text(word_of(value)); };
    form.parse = [](const GivenOption& given, const std::string& word) {
        return static_cast<Enum>(option_index(given, enum_words<Enum>, word));
    };
    form.word = [usual](const auto& value) {
        return std::string(word_of(value.value_or(usual())));
    };
    form.read_session = [shown, usual](const Session& session) {
        const Enum value = shown(session);
        return value != usual() ? std::optional(value) : std::nullopt;
    };
    form.show = [shown, usual, keeps_last](const auto& value, Session& session) {
        shown(session) = value.value_or(keeps_last ? shown(session) : usual());
    };
    return make_field(key, part, option, form);
}

/// The same for a member of the session.
template <class Enum>
ViewField enum_field(std::string_view key, ViewPart part, const ViewOption& option,
                     const char* what, std::optional<Enum> ViewState::*member,
                     std::type_identity_t<Enum> Session::*shown, bool keeps_last) {
    return word_field(
        key, part, option, what, member, [shown](auto& session) -> auto& { return session.*shown; },
        keeps_last);
}

} // namespace rasterwalk
