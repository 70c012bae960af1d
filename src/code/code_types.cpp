#include "code/code_types.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <utility>

#include "base/numbers.h"

namespace rasterwalk {

namespace {

using TypeKind = CodeType::Kind;

constexpr std::string_view component_names = "xyzw";
constexpr std::string_view colour_names = "rgba";

CodeType number_type(TypeKind kind, std::string name, int words) {
    return {kind, std::move(name), words, 1, code_type::nothing, {}};
}

CodeType vector_type(TypeKind kind, std::string name, int count) {
    const CodeTypeId element = kind == TypeKind::int_vector ? code_type::integer : code_type::real;
    CodeType type{kind, std::move(name), count, count, element, {}};
    for (int i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        type.fields.push_back({std::string(1, component_names[at]), element, i});
    }
    return type;
}

CodeType matrix_type(std::string name, int count, CodeTypeId column) {
    return {TypeKind::matrix, std::move(name), count * count, count, column, {}};
}

/// Names that mean one of the others.
constexpr std::pair<std::string_view, CodeTypeId> other_names[]{
    {"size_t", code_type::integer},
    {"unsigned", code_type::integer},
    {"long", code_type::integer},
    {"Uint32", code_type::integer},
};

/// As the row table has it.
std::string integer_text(std::int32_t value) {
    constexpr std::int32_t largest = std::numeric_limits<std::int32_t>::max();
    if (value == largest) return "INT_MAX";
    return value == -largest ? "-INT_MAX" : std::to_string(value);
}

double double_in(const std::uint32_t* words) {
    double value = 0.0;
    std::memcpy(&value, words, sizeof value);
    return value;
}

} // namespace

CodeTypes::CodeTypes() {
    add(number_type(TypeKind::nothing, "void", 0));
    add(number_type(TypeKind::boolean, "bool", 1));
    add(number_type(TypeKind::integer, "int", 1));
    add(number_type(TypeKind::real, "float", 1));
    add(number_type(TypeKind::double_real, "double", 2));
    add(vector_type(TypeKind::int_vector, "ivec2", 2));
    add(vector_type(TypeKind::int_vector, "ivec3", 3));
    add(vector_type(TypeKind::real_vector, "vec2", 2));
    add(vector_type(TypeKind::real_vector, "vec3", 3));
    add(vector_type(TypeKind::real_vector, "vec4", 4));
    add(matrix_type("mat3", 3, code_type::vec3));
    add(matrix_type("mat4", 4, code_type::vec4));
}

CodeTypeId CodeTypes::add(CodeType type) {
    type.has_list =
        type.kind == TypeKind::list ||
        (type.kind == TypeKind::array && (*this)[type.element].has_list) ||
        std::any_of(type.fields.begin(), type.fields.end(),
                    [&](const CodeField& field) { return (*this)[field.type].has_list; });
    all_.push_back(std::move(type));
    return static_cast<CodeTypeId>(all_.size()) - 1;
}

CodeTypeId CodeTypes::find(std::string_view name) const {
    for (std::size_t i = 0; i < all_.size(); ++i)
        if (all_[i].name == name) return static_cast<CodeTypeId>(i);
    for (const auto& [other, type] : other_names)
        if (other == name) return type;
    return -1;
}

CodeTypeId CodeTypes::list_of(CodeTypeId element) {
    std::string name = "vector<" + (*this)[element].name + ">";
    const CodeTypeId known = find(name);
    if (known >= 0) return known;
    return add({TypeKind::list, std::move(name), 1, 0, element, {}});
}

CodeTypeId CodeTypes::array_of(CodeTypeId element, int count) {
    std::string name = (*this)[element].name + "[" + std::to_string(count) + "]";
    const CodeTypeId known = find(name);
    if (known >= 0) return known;
    const int words = (*this)[element].words * count;
    return add({TypeKind::array, std::move(name), words, count, element, {}});
}

CodeTypeId CodeTypes::add_structure(std::string name, std::vector<CodeField> fields) {
    CodeType type{TypeKind::structure, std::move(name), 0, 1, code_type::nothing, {}};
    for (CodeField& field : fields) {
        field.offset = type.words;
        type.words += (*this)[field.type].words;
    }
    type.fields = std::move(fields);
    return add(std::move(type));
}

bool CodeTypes::is_number(CodeTypeId id) const {
    return id == code_type::boolean || id == code_type::integer || id == code_type::real ||
           id == code_type::double_real;
}

bool CodeTypes::has_list(CodeTypeId id) const {
    return (*this)[id].has_list;
}

const CodeField* CodeTypes::field(CodeTypeId id, std::string_view name) const {
    const CodeType& type = (*this)[id];
    const std::size_t colour =
        is_vector(type) && name.size() == 1 ? colour_names.find(name) : name.npos;
    for (std::size_t i = 0; i < type.fields.size(); ++i)
        if (type.fields[i].name == name || i == colour) return &type.fields[i];
    return nullptr;
}

std::string with_article(std::string_view type) {
    const bool has_vowel = !type.empty() && std::string_view("aeio").find(type[0]) < 4;
    return std::string(has_vowel ? "an " : "a ").append(type);
}

std::string at_beginning(std::string words) {
    if (words.starts_with('a')) words[0] = 'A';
    return words;
}

std::string code_value_text(const CodeTypes& types, CodeTypeId id, const std::uint32_t* words,
                            int size) {
    const CodeType& type = types[id];
    switch (type.kind) {
    case TypeKind::nothing:
        return {};
    case TypeKind::boolean:
        return *words != 0 ? "true" : "false";
    case TypeKind::integer:
        return integer_text(static_cast<std::int32_t>(*words));
    case TypeKind::real:
        return number_text(std::bit_cast<float>(*words));
    case TypeKind::double_real:
        return shortest(double_in(words));
    case TypeKind::list:
        return counted(size, "element", "elements");
    case TypeKind::array:
        return counted(type.count, "element", "elements");
    case TypeKind::int_vector:
    case TypeKind::real_vector:
    case TypeKind::matrix:
    case TypeKind::structure:
        break;
    }
    const bool is_structure = type.kind == TypeKind::structure;
    std::string text(1, is_structure ? '{' : '(');
    const auto append = [&](CodeTypeId part, int offset, std::string_view name) {
        if (text.size() > 1) text += ", ";
        if (is_structure) text.append(name).append(" ");
        text += code_value_text(types, part, words + offset);
    };
    for (const CodeField& field : type.fields)
        append(field.type, field.offset, field.name);
    if (type.kind == TypeKind::matrix)
        for (int i = 0; i < type.count; ++i)
            append(type.element, i * type.count, {});
    return text + (is_structure ? '}' : ')');
}

} // namespace rasterwalk
