#pragma once

// Writes formulas one after another, each from the numbers of earlier ones: every number is passed
// on once, where it is the result of its own formula.

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "explain/formula.h"

namespace rasterwalk {

/// The names of the components: x y z, and red green blue.
inline constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};
inline constexpr std::array<const char*, 3> channel_names{"red", "green", "blue"};

inline std::string axis_name(int i) {
    return axis_names[static_cast<std::size_t>(i)];
}
inline std::string channel_name(int i) {
    return channel_names[static_cast<std::size_t>(i)];
}

using FormulaInputs = std::vector<FormulaInput>;

/// The inputs of the first list, then those of the second.
FormulaInputs joined(FormulaInputs first, const FormulaInputs& second);

/// A value with three components, and where each of them comes from.
struct SourcedVector {
    glm::vec3 value{0.0f};
    std::array<Source, 3> sources;

    /// One component as an input.
    /// @param symbol of the component: "n.x"
    FormulaInput part(std::string symbol, int i) const {
        return {std::move(symbol), {value[i]}, sources[static_cast<std::size_t>(i)]};
    }
    /// All three: "n.x", "n.y", "n.z".
    /// @param symbol of the vector: "n"
    FormulaInputs parts(const std::string& symbol) const;
};

/// Appends formulas to a list. All ids that it takes are without its prefix.
class FormulaWriter {
  public:
    /// @param formulas must outlive it
    /// @param prefix   of the ids: "bump."
    explicit FormulaWriter(std::vector<Formula>& formulas, std::string prefix = {})
        : formulas_(formulas), prefix_(std::move(prefix)) {}

    /// For the same list, with another prefix.
    FormulaWriter under(std::string prefix) const {
        return FormulaWriter(formulas_, std::move(prefix));
    }

    const std::string& prefix() const { return prefix_; }

    /// @return the formula, until the next one is added
    Formula& add(const std::string& id, std::string name, std::string help, std::string expression,
                 FormulaInputs inputs, Number result);

    /// Three formulas, ID.x ID.y ID.z, for a vector.
    /// @param expression with {} where the axis is named: "s.{} / |s|"
    /// @param inputs     of the component 0 to 2
    /// @return the vector, with these formulas as its sources
    SourcedVector add_vector(const std::string& id, const std::string& symbol,
                             const std::string& help, const std::string& expression,
                             const glm::vec3& value,
                             const std::function<FormulaInputs(int)>& inputs);
    /// A dot product: "a.x · b.x + a.y · b.y + a.z · b.z".
    Formula& add_dot(const std::string& id, std::string name, std::string help,
                     const std::string& a_symbol, const SourcedVector& a,
                     const std::string& b_symbol, const SourcedVector& b, float result);
    /// The length of a vector: "sqrt(v.x² + v.y² + v.z²)".
    Formula& add_length(const std::string& id, std::string name, std::string help,
                        const std::string& symbol, const SourcedVector& vector, float result);

    // Throw std::logic_error if no formula has the id.
    /// An earlier formula, to be changed.
    Formula& formula(const std::string& id) const;
    /// The same as an input.
    FormulaInput input(std::string symbol, const std::string& id) const;
    /// An earlier vector.
    SourcedVector vector(const std::string& id) const;
    /// One component of an earlier vector as an input.
    /// @param symbol of the component
    FormulaInput part(std::string symbol, const std::string& id, int i) const {
        return input(std::move(symbol), id + "." + axis_name(i));
    }

  private:
    std::vector<Formula>& formulas_;
    std::string prefix_;
};

} // namespace rasterwalk
