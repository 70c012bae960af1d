#pragma once

// The groups of the table of facts, one for each subject.

#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "explain/formula_writer.h"
#include "facts/fact_values.h"
#include "facts/facts.h"

namespace rasterwalk {

/// A number or word as a value; 1 and 0 for true and false.
template <class T>
Value as_value(const T& value) {
    if constexpr (std::is_same_v<T, bool>)
        return number(value ? 1 : 0);
    else if constexpr (std::is_convertible_v<T, std::string_view>)
        return std::string(value);
    else if constexpr (requires { number(value); })
        return number(value);
    else
        return value;
}

/// Adds facts about one thing to a table: `add("pixel.u", "u of ...", real(),
/// read)`.
/// @tparam about gives the thing, or null if it is not there, and then none of
/// the facts has a value
template <auto about>
class FactAdder {
  public:
    explicit FactAdder(std::vector<Fact>& table) : table_(table) {}

    /// @param read a lambda without captures, of the thing and, if facts are
    /// alike, the number
    template <class Read>
    void operator()(std::string name, std::string help, ValueRange range, Read,
                    int number = 0) const {
        table_.push_back({std::move(name), std::move(help), std::move(range), value<Read>, number});
    }

  private:
    template <class Read>
    static Value value(const Facts& facts, int number) {
        const auto thing = std::invoke(about, facts);
        if (!thing) return {};
        if constexpr (std::is_invocable_v<Read, decltype(*thing), int>)
            return as_value(Read{}(*thing, number));
        else
            return as_value(Read{}(*thing));
    }

    std::vector<Fact>& table_;
};

/// For facts that need the session or several results.
inline const Facts* everything(const Facts& facts) {
    return &facts;
}

// In frame_facts.cpp:
/// The moment: what comes next.
void add_cursor_facts(std::vector<Fact>& table);
/// The results of edge functions for the pixel that comes next.
void add_test_facts(std::vector<Fact>& table);
/// What is selected, and what is shown.
void add_session_facts(std::vector<Fact>& table);
/// The whole frame in numbers.
void add_frame_facts(std::vector<Fact>& table);
/// The contents of the open model file.
void add_model_facts(std::vector<Fact>& table);

// In triangle_facts.cpp, for the triangle shown:
/// Where it is, and which side it shows.
void add_side_facts(std::vector<Fact>& table);
/// What clipping and culling do to it.
void add_clip_facts(std::vector<Fact>& table);
/// The polygon of the scene that it belongs to.
void add_outline_facts(std::vector<Fact>& table);
/// The edge that it shares with a neighbour.
void add_shared_edge_facts(std::vector<Fact>& table);
/// Its selected vertex.
void add_vertex_facts(std::vector<Fact>& table);

// In light_facts.cpp:
/// The light of the picked pixel, term by term.
void add_light_facts(std::vector<Fact>& table);

// In shadow_facts.cpp:
/// What is in shadow: the picked pixel, the part shown, the whole picture.
void add_shadow_facts(std::vector<Fact>& table);

// In fragment_facts.cpp:
/// The picked pixel.
void add_pixel_facts(std::vector<Fact>& table);
/// The row table of the triangle shown.
void add_table_facts(std::vector<Fact>& table);

// In compare_facts.cpp:
/// Two runs, and how they differ.
void add_compare_facts(std::vector<Fact>& table);

/// The most corners of a triangle after all planes, each of which can add one.
inline constexpr int most_polygon_corners = triangle_corners + static_cast<int>(clip_plane_count);

/// Ndc z of a depth in front of run A's camera; none in a scene in pixels.
Value z_ndc(const Facts& facts, float z);

} // namespace rasterwalk
