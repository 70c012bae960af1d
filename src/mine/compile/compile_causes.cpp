#include "mine/compile/compile_messages.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include <fmt/format.h>

#include "base/text_parts.h"

namespace rasterwalk {

namespace {

constexpr std::size_t longest_type = 40;

using Names = std::vector<std::string>;

bool has(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

bool has_any(std::string_view text, std::initializer_list<std::string_view> parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [text](std::string_view part) { return has(text, part); });
}

/// Does the compiler tell of several functions why they cannot be meant?
bool has_candidates(std::string_view text) {
    return text.find("candidate") != text.rfind("candidate");
}

/// The text without what a type is an alias of: {aka '...'} and (aka '...').
std::string without_aliases(std::string_view text) {
    std::string plain(text);
    for (const auto& [open, close] : {std::pair{" {aka ", '}'}, std::pair{" (aka ", ')'}}) {
        for (std::size_t at = plain.find(open); at != std::string::npos; at = plain.find(open)) {
            // The quotes may hold brackets themselves.
            const std::size_t quote = plain.find('\'', at);
            const std::size_t quote_end =
                quote == std::string::npos ? quote : plain.find('\'', quote + 1);
            const std::size_t end =
                quote_end == std::string::npos ? quote_end : plain.find(close, quote_end);
            if (end == std::string::npos) return plain;
            plain.erase(at, end + 1 - at);
        }
    }
    return plain;
}

/// What is in quotes, as a student writes it: vec3 for const glm::vec3&.
Names quoted_names(std::string_view text) {
    Names names;
    const std::string plain = without_aliases(text);
    std::size_t at = 0;
    while ((at = plain.find('\'', at)) != std::string::npos) {
        const std::size_t end = plain.find('\'', at + 1);
        if (end == std::string::npos) break;
        std::string name = plain.substr(at + 1, end - at - 1);
        // What a pointer points to stays const.
        const bool is_plain = name.find('*') == std::string::npos && !name.ends_with(']');
        for (const std::string_view part : {"glm::", "struct ", "class ", "const "}) {
            if (part == "const " && !is_plain) continue;
            for (std::size_t found = name.find(part); found != std::string::npos;
                 found = name.find(part)) {
                name.erase(found, part.size());
            }
        }
        while (name.size() > 1 && (name.back() == '&' || name.back() == ' '))
            name.pop_back();
        // clang leaves the names of GLM's types out when it compares them.
        if (name == "vec<3, float, [...]>") name = "vec3";
        if (name == "vec<4, float, [...]>") name = "vec4";
        if (name == "vec<2, int, [...]>" || name == "vec<2, int, packed_highp>") name = "ivec2";
        names.push_back(name);
        at = end + 1;
    }
    return names;
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_standard_name(std::string_view name) {
    return is_one_of(name, {"cout", "cin", "cerr", "endl", "string", "vector", "array", "pair",
                            "map", "swap", "sort", "ofstream", "ifstream", "numeric_limits"});
}

bool is_glm_name(std::string_view name) {
    return is_one_of(name, {"vec2", "vec3", "vec4", "ivec2", "ivec3", "mat3", "mat4", "normalize",
                            "cross", "dot", "inverse", "transpose", "glm"});
}

bool is_number_type(std::string_view name) {
    return is_one_of(name, {"int", "float", "double", "unsigned int", "long", "size_t", "bool"});
}

bool is_vector_type(std::string_view name) {
    return name.starts_with("vec") || name.starts_with("mat");
}

/// The name that the compiler suggests; empty: none.
std::string suggestion(std::string_view text) {
    const std::size_t at = text.find("did you mean '");
    if (at == std::string_view::npos) return {};
    const Names names = quoted_names(text.substr(at));
    return names.empty() ? std::string() : names.front();
}

std::string cause_of_unknown_name(std::string_view text) {
    const bool is_type = has_any(text, {"does not name a type", "unknown type name"});
    if (!is_type && !has_any(text, {"was not declared in this scope", "use of undeclared id"})) {
        return {};
    }
    const Names names = quoted_names(text);
    if (names.empty()) return {};
    const std::string& name = names.front();
    const auto is_strange = [](char letter) { return static_cast<unsigned char>(letter) > 127; };
    if (std::any_of(name.begin(), name.end(), is_strange)) return {};
    const std::string better = suggestion(text);
    if (better == "std::" + name || is_standard_name(name)) {
        return fmt::format("{0} belongs to the standard library: include its header, and write "
                           "std::{0}, or \"using namespace std;\" at the top.",
                           name);
    }
    if (is_glm_name(name)) {
        return fmt::format("{} belongs to GLM: include <glm/glm.hpp>, and write \"using namespace "
                           "glm;\" below it, or glm:: before the name.",
                           name);
    }
    if (!better.empty()) {
        return fmt::format("Nothing named {} is known here, but the similar name {} is.", name,
                           better);
    }
    if (has(text, "does not name a type")) {
        return fmt::format("No type named {} is known here. Outside of functions each line "
                           "declares something and so begins with a type; other statements belong "
                           "inside a function.",
                           name);
    }
    return fmt::format("Nothing named {} is known here: it is spelled differently, is declared "
                       "only further down or inside other braces, or its header is missing.",
                       name);
}

std::string cause_of_semicolon(std::string_view text) {
    const bool is_wanted = has_any(text, {"expected ';'", "expected ',' or ';'"});
    if (!is_wanted) return {};
    if (has_any(text, {"after struct", "after class", "after enum"})) {
        return "A struct, class or enum ends with a semicolon after its closing brace.";
    }
    const std::size_t before = text.find("before '");
    if (before == std::string_view::npos) {
        if (has_any(text, {"end of declaration", "after expression", "after return",
                           "after do/while", "after break", "after continue"})) {
            return "A semicolon is missing here, at the end of a statement.";
        }
        return {};
    }
    const Names names = quoted_names(text.substr(before));
    // Before an operator or a bracket something else may be wrong as well.
    if (names.empty() || names.front().empty()) return {};
    const auto first = static_cast<unsigned char>(names.front().front());
    if (std::isalpha(first) == 0 && first != '}' && first != '_') return {};
    return fmt::format("A semicolon is missing before {}, often at the end of the previous line.",
                       names.front());
}

/// "requires 2 arguments, but 1 was provided" of clang.
std::string cause_of_count(std::string_view text) {
    constexpr std::string_view few =
        "The function has more parameters than there are arguments here.";
    constexpr std::string_view many =
        "The function has fewer parameters than there are arguments here.";
    if (has(text, "too few arguments to function")) return std::string(few);
    if (has(text, "too many arguments to function")) return std::string(many);
    const std::size_t at = text.find("requires ");
    const std::size_t but = text.find(", but ");
    if (at == std::string_view::npos || but == std::string_view::npos || but < at) return {};
    // Of several functions of one name, none is the one that was meant.
    if (has_candidates(text)) return {};
    int wanted = 0, given = 0;
    const char* end = text.data() + text.size();
    if (std::from_chars(text.data() + at + 9, end, wanted).ec != std::errc{} ||
        std::from_chars(text.data() + but + 6, end, given).ec != std::errc{}) {
        return {};
    }
    return std::string(given < wanted ? few : many);
}

std::string cause_of_operator(std::string_view text) {
    if (!has_any(text, {"no match for 'operator", "invalid operands to binary expression"})) {
        return {};
    }
    // The types are the last two names of the first line.
    const Names names = quoted_names(text.substr(0, text.find('\n')));
    if (names.size() < 2) return {};
    const std::string& left = names[names.size() - 2];
    const std::string& right = names.back();
    if (has(left, "ostream")) {
        return fmt::format("<< cannot print a {}: print its members one by one.", right);
    }
    // The name of a type inside a library means nothing to a beginner.
    if (std::max(left.size(), right.size()) > longest_type) return {};
    const bool is_mixed = (is_number_type(left) && is_vector_type(right)) ||
                          (is_vector_type(left) && is_number_type(right));
    return fmt::format("This operator is not defined between {} and {}{}", left, right,
                       is_mixed && left != "float" && right != "float"
                           ? ": vectors of GLM go with floats only, as in float(n) or 2.0f."
                           : ".");
}

std::string cause_of_type(std::string_view text) {
    struct Form {
        std::string_view start, middle;
        bool is_wanted_first;
    };
    constexpr std::array<Form, 8> forms{{
        {"invalid initialization of reference of type '", "from expression of type", true},
        {"cannot initialize a ", " value of type", true},
        {"cannot initialize a ", " with an ", true},
        {"no known conversion from '", "' to '", false},
        {"no viable conversion from '", "' to '", false},
        {"cannot convert '", "' to '", false},
        {"invalid conversion from '", "' to '", false},
        {"conversion from '", "to non-scalar type", false},
    }};
    // Several candidates: the one that was meant is not known.
    if (has_candidates(text)) return {};
    const std::string plain = without_aliases(text);
    for (const Form& form : forms) {
        const std::size_t at = plain.find(form.start);
        if (at == std::string::npos || !has(plain.substr(at), form.middle)) continue;
        const Names names = quoted_names(std::string_view(plain).substr(at));
        if (names.size() < 2 || names[0] == names[1]) return {};
        return fmt::format("A value of type {} is needed here, and this is of type {}.",
                           form.is_wanted_first ? names[0] : names[1],
                           form.is_wanted_first ? names[1] : names[0]);
    }
    return {};
}

std::string cause_of_member(std::string_view text) {
    const bool is_clang = has(text, "no member named '");
    if (!is_clang && !has(text, "has no member named '")) return {};
    const Names names = quoted_names(text);
    if (names.size() < 2) return {};
    const bool type_first = !text.starts_with("no member named");
    const std::string& type = type_first ? names[0] : names[1];
    const std::string& member = type_first ? names[1] : names[0];
    const std::string better = suggestion(text);
    if (!better.empty()) return fmt::format("{} has no {}, but it has {}.", type, member, better);
    return fmt::format("{} has no {}: the name is spelled differently, or the variable is of "
                       "another type than you think.",
                       type, member);
}

std::string cause_of_missing_in_std(std::string_view text) {
    if (!has(text, "is not a member of 'std'") && !has(text, "in namespace 'std'")) return {};
    const Names names = quoted_names(text);
    return fmt::format("std has no {} here: its header is not included, or the name is spelled "
                       "differently.",
                       names.front());
}

std::string cause_of_linker(std::string_view text) {
    const bool is_undefined = text.starts_with("undefined reference to ");
    if (!is_undefined && !text.starts_with("multiple definition of ")) return {};
    const std::size_t open = text.find_first_of("`'");
    const std::size_t close = text.rfind('\'');
    if (open == std::string_view::npos || close <= open) return {};
    const std::string_view name = text.substr(open + 1, close - open - 1);
    const std::string_view bare = name.substr(0, name.find('('));
    if (!is_undefined) {
        return fmt::format("{} is defined in two sources, or in a header that both include: leave "
                           "a declaration in the header, and the definition in one source.",
                           bare);
    }
    if (name == "main") return "No source of this program defines main().";
    if (name.starts_with("vtable for ")) {
        return fmt::format("A virtual function of {} is declared but never defined.",
                           name.substr(11));
    }
    if (!has(name, "(")) return fmt::format("{} is declared and used, but never defined.", bare);
    return fmt::format("{} is declared and called, but never defined, or it is defined with other "
                       "types of parameters.",
                       bare);
}

std::string cause_of_strange_letter(std::string_view text) {
    const bool is_stray = has(text, "stray '\\") && !has(text, "stray '\\'");
    if (!is_stray && !has_any(text, {"extended character ", "unexpected character <U+",
                                     "not allowed in an identifier", "non-ASCII character"})) {
        return {};
    }
    return "C++ does not know this character. Typographic quotes, dashes and blanks come with text "
           "that was copied from a document: type them again.";
}

/// Causes that need no name: the first of these phrases that a message contains decides.
struct PlainCause {
    std::string_view phrase;
    std::string_view sentence;
};

namespace sentences {

constexpr std::string_view brace_is_open = "A brace { further up is never closed.";
constexpr std::string_view brace_too_many =
    "There is a closing brace too many: here, or further up.";
constexpr std::string_view function_inside =
    "A function cannot be defined inside another one: a closing brace may be missing above.";
constexpr std::string_view defined_twice =
    "This name already has a definition here: rename one of the two, or delete it.";
constexpr std::string_view file_missing =
    "There is no file of this name in the program's folder, nor among those that come with "
    "Rasterwalk. Capitals count.";
constexpr std::string_view cannot_be_changed =
    "The function could change this argument, because its parameter is a reference (&) without "
    "const, but a temporary value cannot be changed: put it into a variable first, or make the "
    "parameter const.";
constexpr std::string_view loses_const =
    "The argument is const, but the function could change it through its parameter: make that a "
    "reference to const as well.";
constexpr std::string_view is_const = "This is const, so nothing can be assigned to it.";
constexpr std::string_view type_missing =
    "The type is missing: a function that returns nothing is void. If it is no declaration, it "
    "belongs inside a function.";
constexpr std::string_view assigns = "A single = assigns; == compares.";
constexpr std::string_view same_case = "Two cases of this switch have the same value.";
constexpr std::string_view no_function =
    "The brackets call a function, but what stands before them is none: an operator may be "
    "missing, or a variable hides the function of the same name.";
constexpr std::string_view lonely_else =
    "No if ends right before this else: there may be a semicolon after the if's condition, or "
    "several statements without braces.";
constexpr std::string_view open_quote = "A quote in this line is never closed.";
constexpr std::string_view no_members = "This is of a type without members.";
constexpr std::string_view pointer = "This is a pointer: its members are reached with ->.";
constexpr std::string_view no_pointer = "This is no pointer: its members are reached with a dot.";
constexpr std::string_view declares_only =
    "This line only declares a function: it calls none, and makes no variable. A call takes values "
    "without their types; a variable is made without empty brackets.";
constexpr std::string_view type_for_value =
    "This is the name of a type, and a value is needed: the arguments of a call are written "
    "without their types.";
constexpr std::string_view no_return =
    "The function promises a value, but it can end without returning one.";
constexpr std::string_view void_returns = "A void function returns no value.";
constexpr std::string_view ambiguous =
    "There are two things of this name: often one of yours and one that \"using namespace\" "
    "brought in. Rename yours.";
constexpr std::string_view is_private =
    "The members of a class are private unless \"public:\" stands before them.";
constexpr std::string_view outside =
    "This statement is outside of every function: a closing brace above may be one too many.";

} // namespace sentences

constexpr PlainCause plain_causes[] = {
    {"expected '}'", sentences::brace_is_open},
    {"expected declaration before '}'", sentences::brace_too_many},
    {"extraneous closing brace", sentences::brace_too_many},
    {"unction-definition is not allowed here", sentences::function_inside},
    {"unction definition is not allowed here", sentences::function_inside},
    {"redefinition of '", sentences::defined_twice},
    {"redeclaration of '", sentences::defined_twice},
    {"No such file or directory", sentences::file_missing},
    {"' file not found", sentences::file_missing},
    {"cannot bind non-const lvalue reference", sentences::cannot_be_changed},
    {"expects an lvalue for", sentences::cannot_be_changed},
    {"discards qualifiers", sentences::loses_const},
    {"would lose const qualifier", sentences::loses_const},
    {"in read-only object", sentences::is_const},
    {"assignment of read-only", sentences::is_const},
    {"with const-qualified type", sentences::is_const},
    {"forbids declaration of", sentences::type_missing},
    {"requires a type specifier", sentences::type_missing},
    {"a type specifier is required", sentences::type_missing},
    {"suggest parentheses around assignment", sentences::assigns},
    {"using the result of an assignment as a condition", sentences::assigns},
    {"duplicate case value", sentences::same_case},
    {"cannot be used as a function", sentences::no_function},
    {"is not a function or function pointer", sentences::no_function},
    {"'else' without a previous 'if'", sentences::lonely_else},
    {"missing terminating", sentences::open_quote},
    {"unterminated comment", "A comment begins with /* here and never ends: */ is missing."},
    {"unterminated /* comment", "A comment begins with /* here and never ends: */ is missing."},
    {"unterminated #", "This #if or #ifdef has no #endif."},
    {"unterminated conditional directive", "This #if or #ifdef has no #endif."},
    {"which is of pointer type", sentences::pointer},
    {"is a pointer; did you mean to use '->'", sentences::pointer},
    {"has non-pointer type", sentences::no_pointer},
    {"is not a pointer; did you mean to use '.'", sentences::no_pointer},
    {"which is of non-class type", sentences::no_members},
    {"is not a structure or union", sentences::no_members},
    {"were disambiguated as a function declaration", sentences::declares_only},
    {"interpreted as a function declaration", sentences::declares_only},
    {"disambiguated as redundant parentheses", sentences::declares_only},
    {"does not refer to a value", sentences::type_for_value},
    {"no return statement in function returning non-void", sentences::no_return},
    {"control reaches end of non-void", sentences::no_return},
    {"non-void function does not return a value", sentences::no_return},
    {"in function returning 'void'", sentences::void_returns},
    {"should not return a value", sentences::void_returns},
    {"is ambiguous", sentences::ambiguous},
    {"is private within this context", sentences::is_private},
    {"is a private member of", sentences::is_private},
    {"in octal constant", "A number that begins with 0 is octal: its digits are 0 to 7."},
    {"expected unqualified-id before 'for'", sentences::outside},
    {"expected unqualified-id before 'if'", sentences::outside},
    {"expected unqualified-id before 'while'", sentences::outside},
    {"expected unqualified-id before 'return'", sentences::outside},
    {"break statement not within loop", "A break belongs inside a loop or a switch."},
    {"'break' statement not in loop", "A break belongs inside a loop or a switch."},
    {"expected ')' before ';'", "A bracket ( of this statement is not closed."},
};

} // namespace

std::string likely_cause(std::string_view text) {
    for (const auto cause_of :
         {cause_of_linker, cause_of_unknown_name, cause_of_semicolon, cause_of_strange_letter,
          cause_of_missing_in_std, cause_of_member, cause_of_operator, cause_of_count}) {
        std::string cause = cause_of(text);
        if (!cause.empty()) return cause;
    }
    for (const PlainCause& plain : plain_causes) {
        // If a call fits none of several functions, clang gives a reason for each of them, and only
        // one of these is the student's mistake.
        const bool is_of_candidate =
            text.find(plain.phrase) > text.find('\n') && has_candidates(text);
        if (has(text, plain.phrase) && !is_of_candidate) return std::string(plain.sentence);
    }
    return cause_of_type(text);
}

} // namespace rasterwalk
