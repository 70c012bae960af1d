#pragma once

// The types of a program of the lab, and how their values lie in memory: in words of 32 bits, one
// after the other, without gaps.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A type, by its place in the table.
using CodeTypeId = int;

struct CodeField {
    std::string name;
    CodeTypeId type = 0;
    int offset = 0; ///< words from the beginning of the value
};

struct CodeType {
    enum class Kind : std::uint8_t {
        nothing,     ///< void
        boolean,     ///< 0 or 1
        integer,     ///< int, and what counts like it
        real,        ///< float
        double_real, ///< double: two words
        int_vector,  ///< ivec2, ivec3
        real_vector, ///< vec2, vec3, vec4
        matrix,      ///< mat3, mat4: column by column
        structure,
        list,  ///< vector<T>: one word, the number of a block, see code_machine.h
        array, ///< T[N]
    };
    Kind kind = Kind::nothing;
    std::string name; ///< as it is written in the program
    int words = 0;
    int count = 1;          ///< elements of an array, vector or column
    CodeTypeId element = 0; ///< their type, or the column's
    std::vector<CodeField> fields;
    bool has_list = false; ///< see CodeTypes::has_list()
};

/// Is it a vector of GLM?
inline bool is_vector(const CodeType& type) {
    return type.kind == CodeType::Kind::int_vector || type.kind == CodeType::Kind::real_vector;
}

/// The types that every program has; their places in the table.
namespace code_type {
enum : CodeTypeId {
    nothing,
    boolean,
    integer,
    real,
    double_real,
    ivec2,
    ivec3,
    vec2,
    vec3,
    vec4,
    mat3,
    mat4,
    built_in_count
};
}

class CodeTypes {
  public:
    CodeTypes();

    const CodeType& operator[](CodeTypeId id) const { return all_[static_cast<std::size_t>(id)]; }

    /// The type of this name; -1: there is none.
    CodeTypeId find(std::string_view name) const;
    /// vector<element>; made if it is not there.
    CodeTypeId list_of(CodeTypeId element);
    /// element[count]; made if it is not there.
    CodeTypeId array_of(CodeTypeId element, int count);
    CodeTypeId add_structure(std::string name, std::vector<CodeField> fields);

    /// int, float, double or bool: what arithmetic converts.
    bool is_number(CodeTypeId id) const;
    /// Does it have a list in it? Such values cannot be copied word by word.
    bool has_list(CodeTypeId id) const;
    /// The member, or the component `x` or `r` of a vector; null: it has none of this name.
    const CodeField* field(CodeTypeId id, std::string_view name) const;

  private:
    CodeTypeId add(CodeType type);

    std::vector<CodeType> all_;
};

/// The name of a type with its article: "an int", "a float"; and at the beginning of a sentence.
std::string with_article(std::string_view type);
std::string at_beginning(std::string words);

/// A value as text: `9`, `0.25`, `(1, 2, 3)`, `{x 3, y 4}`; of a list, how many elements it has.
/// @param words of the value
/// @param size  of a list
std::string code_value_text(const CodeTypes& types, CodeTypeId id, const std::uint32_t* words,
                            int size = 0);

} // namespace rasterwalk
