// All orders of a puzzle's lines within two moves of the right one: the judge, which lets the
// machine carry out the code, agrees with the same lines carried out by a compiler's code.

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "lessons/lesson.h"
#include "lessons/puzzle_judge.h"
#include "session/content.h"
#include "support/effort.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

// Students' lines in C++, for a compiler: each is a function of the variables that are known.

struct Failure {};     ///< an index outside of a table
struct Returned {};    ///< the function has given something back
struct NotCompiled {}; ///< a name that is not known, a name that is there already

using Point = std::pair<int, int>;

struct Variable {
    std::string name;
    float x = 0.0f, y = 0.0f;
    int whole = 0;
    std::vector<Point> points{};
    glm::vec3 vector{0.0f};
};

/// What a function is working on.
struct Run {
    std::vector<float> given;
    std::vector<Variable> variables;
    std::vector<std::vector<Point>> tables; ///< left and right; or the result
    float depth[3][4]{};
    int picture[3][4]{};
    std::vector<glm::vec3> vectors; ///< the result, if it is of those
    std::vector<float> answer;

    Variable& at(const char* name) {
        for (auto one = variables.rbegin(); one != variables.rend(); ++one) {
            if (one->name == name) return *one;
        }
        throw NotCompiled{};
    }
    int& whole(const char* name) { return at(name).whole; }
    Variable& declare(const char* name) {
        variables.push_back({name});
        return variables.back();
    }
};

/// The element, or a failure.
template <class List>
auto& element(List& list, int index) {
    if (index < 0 || index >= static_cast<int>(std::size(list))) throw Failure{};
    return list[static_cast<std::size_t>(index)];
}

/// A line: what it declares and uses, and what it does.
struct NativeLine {
    std::vector<const char*> uses;
    const char* declares = nullptr;
    const char* declares_too = nullptr;
    std::function<void(Run&)> act{};       ///< a statement; of a loop, its beginning
    std::function<bool(Run&)> condition{}; ///< of a loop, or of a choice
    std::function<void(Run&)> next{};      ///< of a loop
    bool goes_on = false;                  ///< `continue`, if the condition holds
};

using NativeLines = std::map<std::string, NativeLine>;

/// A loop that counts a variable from 0.
NativeLine counting(const char* name, std::vector<const char*> uses,
                    std::function<bool(Run&)> condition, int from = 0) {
    return {std::move(uses),
            name,
            nullptr,
            [=](Run& run) { run.declare(name).whole = from; },
            std::move(condition),
            [=](Run& run) { ++run.whole(name); }};
}

NativeLine deciding(std::vector<const char*> uses, std::function<bool(Run&)> condition,
                    bool goes_on = false) {
    return {std::move(uses), nullptr, nullptr, {}, std::move(condition), {}, goes_on};
}

NativeLine doing(std::vector<const char*> uses, std::function<void(Run&)> act) {
    return {std::move(uses), nullptr, nullptr, std::move(act)};
}

NativeLine declaring(const char* name, std::vector<const char*> uses, std::function<void(Run&)> act,
                     const char* another = nullptr) {
    return {std::move(uses), name, another, std::move(act)};
}

class Native {
  public:
    Native(const NativeLines& known, const std::vector<PuzzleLine>& lines) : lines_(lines) {
        for (const PuzzleLine& line : lines)
            native_.push_back(&known.at(line.text));
    }

    /// Would a compiler take it? @param names of the parameters
    bool compiles(const std::vector<const char*>& names) const {
        struct Scope {
            int depth = 0;
            std::set<std::string> names;
        };
        std::vector<Scope> scopes{{0, {names.begin(), names.end()}}};
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const int deepest = i == 0 ? 1 : depth_after(lines_[i - 1]);
            if (lines_[i].depth > deepest) return false;
            while (scopes.back().depth >= lines_[i].depth)
                scopes.pop_back();
            const NativeLine& line = *native_[i];
            const bool is_loop = static_cast<bool>(line.next);
            const auto is_known = [&](const std::string& name) {
                return std::any_of(scopes.begin(), scopes.end(),
                                   [&](const Scope& scope) { return scope.names.count(name) > 0; });
            };
            // The names of a loop's own head are known in it.
            for (const std::string name : line.uses) {
                if (!is_known(name) && !(is_loop && name == line.declares)) return false;
            }
            if (is_loop) {
                scopes.push_back({lines_[i].depth, {line.declares}});
            } else {
                for (const char* const name : {line.declares, line.declares_too}) {
                    if (name != nullptr && !scopes.back().names.insert(name).second) return false;
                }
                if (line.condition && !line.goes_on) scopes.push_back({lines_[i].depth, {}});
            }
            const auto is_around = [&](std::size_t other) {
                if (!native_[other]->next || lines_[other].depth >= lines_[i].depth) return false;
                for (std::size_t between = other + 1; between <= i; ++between) {
                    if (lines_[between].depth <= lines_[other].depth) return false;
                }
                return true;
            };
            bool is_in_loop = false;
            for (std::size_t other = 0; other < i; ++other)
                is_in_loop = is_in_loop || is_around(other);
            if (line.goes_on && !is_in_loop) return false;
        }
        return true;
    }

    void carry_out(Run& run) const { block(run, 0, lines_.size()); }

  private:
    std::size_t end_of(std::size_t first) const {
        std::size_t end = first + 1;
        while (end < lines_.size() && lines_[end].depth > lines_[first].depth)
            ++end;
        return end;
    }

    /// Returns true if the round of the loop around it is over.
    bool block(Run& run, std::size_t first, std::size_t end) const {
        const std::size_t known = run.variables.size();
        bool is_over = false;
        for (std::size_t i = first; i < end && !is_over; i = end_of(i))
            is_over = one(run, i);
        run.variables.resize(known);
        return is_over;
    }

    bool one(Run& run, std::size_t i) const {
        const NativeLine& line = *native_[i];
        if (!line.condition) {
            line.act(run);
            return false;
        }
        if (line.goes_on) return line.condition(run);
        if (!line.next) return line.condition(run) && block(run, i + 1, end_of(i));
        const std::size_t known = run.variables.size();
        for (line.act(run); line.condition(run); line.next(run))
            block(run, i + 1, end_of(i));
        run.variables.resize(known);
        return false;
    }

    const std::vector<PuzzleLine>& lines_;
    std::vector<const NativeLine*> native_;
};

void line_of_samples(Point a, Point b, std::vector<Point>& result) {
    const int n = static_cast<int>(result.size());
    const auto gaps = static_cast<float>(std::max(n - 1, 1));
    const float step_x = static_cast<float>(b.first - a.first) / gaps;
    const float step_y = static_cast<float>(b.second - a.second) / gaps;
    auto x = static_cast<float>(a.first), y = static_cast<float>(a.second);
    for (Point& sample : result) {
        sample = {static_cast<int>(x), static_cast<int>(y)};
        x += step_x;
        y += step_y;
    }
}

// --- the lines of the four puzzles

/// A puzzle in C++: its lines, the parameters, and how a run begins and ends.
struct NativePuzzle {
    NativeLines lines;
    std::vector<const char*> parameters;
    std::function<void(Run&)> begin;
    std::function<void(Run&)> end;
};

NativePuzzle native_interpolate() {
    NativePuzzle puzzle;
    puzzle.parameters = {"a", "b", "result"};
    puzzle.begin = [](Run& run) {
        run.declare("a").x = run.given[0];
        run.at("a").y = run.given[1];
        run.declare("b").x = run.given[2];
        run.at("b").y = run.given[3];
        run.tables.assign(1, std::vector<Point>(static_cast<std::size_t>(run.given[4])));
    };
    puzzle.end = [](Run& run) {
        for (const auto& [x, y] : run.tables[0]) {
            run.answer.push_back(static_cast<float>(x));
            run.answer.push_back(static_cast<float>(y));
        }
    };
    const auto put = [](Run& run, float x, float y) {
        element(run.tables[0], run.whole("i")) = {static_cast<int>(x), static_cast<int>(y)};
    };
    const auto below_n = [](Run& run) { return run.whole("i") < run.whole("n"); };
    puzzle.lines = {
        {"int n = result.size();", declaring("n", {"result"},
                                             [](Run& run) {
                                                 run.declare("n").whole =
                                                     static_cast<int>(run.tables[0].size());
                                             })},
        {"float gaps = max(n - 1, 1);", declaring("gaps", {"n"},
                                                  [](Run& run) {
                                                      const int n = run.whole("n");
                                                      run.declare("gaps").x =
                                                          static_cast<float>(std::max(n - 1, 1));
                                                  })},
        {"float gaps = n;", declaring("gaps", {"n"},
                                      [](Run& run) {
                                          const int n = run.whole("n");
                                          run.declare("gaps").x = static_cast<float>(n);
                                      })},
        {"vec2 step = vec2(b - a) / gaps;", declaring("step", {"a", "b", "gaps"},
                                                      [](Run& run) {
                                                          const Variable a = run.at("a"),
                                                                         b = run.at("b");
                                                          const float gaps = run.at("gaps").x;
                                                          Variable& step = run.declare("step");
                                                          step.x = (b.x - a.x) / gaps;
                                                          step.y = (b.y - a.y) / gaps;
                                                      })},
        {"vec2 p = vec2(a);", declaring("p", {"a"},
                                        [](Run& run) {
                                            const Variable a = run.at("a");
                                            Variable& p = run.declare("p");
                                            p.x = a.x;
                                            p.y = a.y;
                                        })},
        {"for (int i = 0; i < n; ++i)", counting("i", {"i", "n"}, below_n)},
        {"for (int i = 1; i < n; ++i)", counting("i", {"i", "n"}, below_n, 1)},
        {"result[i] = ivec2(p);",
         doing({"result", "i", "p"}, [=](Run& run) { put(run, run.at("p").x, run.at("p").y); })},
        {"result[i] = ivec2(round(p.x), round(p.y));",
         doing({"result", "i", "p"},
               [=](Run& run) { put(run, std::round(run.at("p").x), std::round(run.at("p").y)); })},
        {"p += step;", doing({"p", "step"},
                             [](Run& run) {
                                 run.at("p").x += run.at("step").x;
                                 run.at("p").y += run.at("step").y;
                             })},
    };
    return puzzle;
}

NativePuzzle native_rows() {
    NativePuzzle puzzle;
    puzzle.parameters = {"v", "left", "right"};
    puzzle.begin = [](Run& run) {
        Variable& v = run.declare("v");
        int top = INT_MAX, bottom = -INT_MAX;
        for (std::size_t i = 0; i + 1 < run.given.size(); i += 2) {
            const int y = static_cast<int>(run.given[i + 1]);
            v.points.emplace_back(static_cast<int>(run.given[i]), y);
            top = std::min(top, y);
            bottom = std::max(bottom, y);
        }
        run.declare("V").whole = static_cast<int>(run.given.size() / 2);
        run.declare("top").whole = top;
        run.declare("rows").whole = bottom - top + 1;
        run.tables.assign(2, std::vector<Point>(static_cast<std::size_t>(bottom - top + 1)));
    };
    puzzle.end = [](Run& run) {
        for (std::size_t r = 0; r < run.tables[0].size(); ++r) {
            run.answer.push_back(static_cast<float>(run.tables[0][r].first));
            run.answer.push_back(static_cast<float>(run.tables[1][r].first));
        }
    };
    const auto x_of = [](Run& run, std::size_t side) -> int& {
        return element(run.tables[side], run.whole("r")).first;
    };
    const auto sample = [](Run& run) { return element(run.at("line").points, run.whole("k")); };
    const auto point = [](Run& run, const char* name) { return Point(run.at(name).points.at(0)); };
    const auto nothing = [](Run&) {};
    puzzle.lines = {
        // Those that are given; begin() has done what they do.
        {"int V = v.size();", declaring("V", {"v"}, nothing)},
        {"int top = SmallestY(v);", declaring("top", {"v"}, nothing)},
        {"int rows = LargestY(v) - top + 1;", declaring("rows", {"v", "top"}, nothing)},
        {"left.resize(rows);", doing({"left", "rows"}, nothing)},
        {"right.resize(rows);", doing({"right", "rows"}, nothing)},
        {"for (int r = 0; r < rows; ++r)",
         counting("r", {"r", "rows"}, [](Run& run) { return run.whole("r") < run.whole("rows"); })},
        {"left[r].x = INT_MAX;", doing({"left", "r"}, [=](Run& run) { x_of(run, 0) = INT_MAX; })},
        {"left[r].x = 0;", doing({"left", "r"}, [=](Run& run) { x_of(run, 0) = 0; })},
        {"right[r].x = -INT_MAX;",
         doing({"right", "r"}, [=](Run& run) { x_of(run, 1) = -INT_MAX; })},
        {"for (int i = 0; i < V; ++i)",
         counting("i", {"i", "V"}, [](Run& run) { return run.whole("i") < run.whole("V"); })},
        {"Pixel a = v[i], b = v[(i + 1) % V];",
         declaring(
             "a", {"v", "i", "V"},
             [](Run& run) {
                 const int i = run.whole("i"), count = run.whole("V");
                 const Point a = element(run.at("v").points, i);
                 const Point b = element(run.at("v").points, (i + 1) % count);
                 run.declare("a").points = {a};
                 run.declare("b").points = {b};
             },
             "b")},
        {"int n = max(abs(a.x - b.x), abs(a.y - b.y)) + 1;",
         declaring("n", {"a", "b"},
                   [=](Run& run) {
                       const Point a = point(run, "a"), b = point(run, "b");
                       run.declare("n").whole =
                           std::max(std::abs(a.first - b.first), std::abs(a.second - b.second)) + 1;
                   })},
        {"int n = abs(a.y - b.y) + 1;", declaring("n", {"a", "b"},
                                                  [=](Run& run) {
                                                      const Point a = point(run, "a"),
                                                                  b = point(run, "b");
                                                      run.declare("n").whole =
                                                          std::abs(a.second - b.second) + 1;
                                                  })},
        {"vector<Pixel> line(n);", declaring("line", {"n"},
                                             [](Run& run) {
                                                 const int n = run.whole("n");
                                                 run.declare("line").points.resize(
                                                     static_cast<std::size_t>(n));
                                             })},
        {"Interpolate(a, b, line);", doing({"a", "b", "line"},
                                           [=](Run& run) {
                                               line_of_samples(point(run, "a"), point(run, "b"),
                                                               run.at("line").points);
                                           })},
        {"for (int k = 0; k < n; ++k)",
         counting("k", {"k", "n"}, [](Run& run) { return run.whole("k") < run.whole("n"); })},
        {"int r = line[k].y - top;", declaring("r", {"line", "k", "top"},
                                               [=](Run& run) {
                                                   const int r =
                                                       sample(run).second - run.whole("top");
                                                   run.declare("r").whole = r;
                                               })},
        {"int r = line[k].y;", declaring("r", {"line", "k"},
                                         [=](Run& run) {
                                             const int r = sample(run).second;
                                             run.declare("r").whole = r;
                                         })},
        {"if (r < 0 || r >= rows) continue;",
         deciding(
             {"r", "rows"},
             [](Run& run) { return run.whole("r") < 0 || run.whole("r") >= run.whole("rows"); },
             true)},
        {"left[r].x = min(left[r].x, line[k].x);",
         doing({"left", "r", "line", "k"},
               [=](Run& run) { x_of(run, 0) = std::min(x_of(run, 0), sample(run).first); })},
        {"right[r].x = max(right[r].x, line[k].x);",
         doing({"right", "r", "line", "k"},
               [=](Run& run) { x_of(run, 1) = std::max(x_of(run, 1), sample(run).first); })},
    };
    return puzzle;
}

NativePuzzle native_depth() {
    NativePuzzle puzzle;
    puzzle.parameters = {"fragments", "depth", "picture"};
    puzzle.begin = [](Run& run) {
        for (auto& row : run.depth)
            std::fill(std::begin(row), std::end(row), 9.0f);
    };
    puzzle.end = [](Run& run) {
        for (int y = 0; y < 3; ++y) {
            for (int x = 0; x < 4; ++x) {
                run.answer.push_back(static_cast<float>(run.picture[y][x]));
                run.answer.push_back(run.depth[y][x]);
            }
        }
    };
    // A fragment keeps where it begins in what is given.
    const auto part = [](Run& run, int offset) {
        return run.given[static_cast<std::size_t>(4 * run.whole("p") + offset)];
    };
    const auto x_of = [=](Run& run) { return static_cast<int>(part(run, 0)); };
    const auto y_of = [=](Run& run) { return static_cast<int>(part(run, 1)); };
    const auto kept = [=](Run& run) -> float& {
        return element(element(run.depth, y_of(run)), x_of(run));
    };
    const auto cell = [](Run& run) -> float& {
        return element(element(run.depth, run.whole("y")), run.whole("x"));
    };
    puzzle.lines = {
        {"for (int y = 0; y < HEIGHT; ++y)",
         counting("y", {"y"}, [](Run& run) { return run.whole("y") < 3; })},
        {"for (int x = 0; x < WIDTH; ++x)",
         counting("x", {"x"}, [](Run& run) { return run.whole("x") < 4; })},
        {"depth[y][x] = 0;", doing({"y", "x"}, [=](Run& run) { cell(run) = 0.0f; })},
        {"depth[y][x] = INT_MAX;",
         doing({"y", "x"}, [=](Run& run) { cell(run) = static_cast<float>(INT_MAX); })},
        {"for (int i = 0; i < fragments.size(); ++i)",
         counting(
             "i", {"i"},
             [](Run& run) { return run.whole("i") < static_cast<int>(run.given.size() / 4); })},
        {"Pixel p = fragments[i];", declaring("p", {"i"},
                                              [](Run& run) {
                                                  const int i = run.whole("i");
                                                  run.declare("p").whole = i;
                                              })},
        {"if (p.x < 0 || p.x >= WIDTH || p.y < 0 || p.y >= HEIGHT) continue;",
         deciding(
             {"p"},
             [=](Run& run) {
                 const int x = x_of(run), y = y_of(run);
                 return x < 0 || x >= 4 || y < 0 || y >= 3;
             },
             true)},
        {"if (p.zinv > depth[p.y][p.x])",
         deciding({"p"}, [=](Run& run) { return part(run, 2) > kept(run); })},
        {"if (p.zinv >= depth[p.y][p.x])",
         deciding({"p"}, [=](Run& run) { return part(run, 2) >= kept(run); })},
        {"if (p.zinv < depth[p.y][p.x])",
         deciding({"p"}, [=](Run& run) { return part(run, 2) < kept(run); })},
        {"depth[p.y][p.x] = p.zinv;", doing({"p"}, [=](Run& run) { kept(run) = part(run, 2); })},
        {"depth[p.x][p.y] = p.zinv;", doing({"p"},
                                            [=](Run& run) {
                                                element(element(run.depth, x_of(run)), y_of(run)) =
                                                    part(run, 2);
                                            })},
        {"picture[p.y][p.x] = p.colour;", doing({"p"},
                                                [=](Run& run) {
                                                    element(element(run.picture, y_of(run)),
                                                            x_of(run)) =
                                                        static_cast<int>(part(run, 3));
                                                })},
    };
    return puzzle;
}

NativePuzzle native_line() {
    NativePuzzle puzzle;
    puzzle.parameters = {"x", "y", "l", "s"};
    puzzle.begin = [](Run& run) {
        for (std::size_t i = 0; i < 4; ++i)
            run.declare(std::array{"x", "y", "l", "s"}[i]).whole = static_cast<int>(run.given[i]);
    };
    puzzle.end = [](Run&) {};
    const auto add = [](const char* name, const char* from, int times) {
        return doing({name, from}, [=](Run& run) { run.whole(name) += times * run.whole(from); });
    };
    puzzle.lines = {
        {"int d = 2 * s - l;", declaring("d", {"s", "l"},
                                         [](Run& run) {
                                             const int d = 2 * run.whole("s") - run.whole("l");
                                             run.declare("d").whole = d;
                                         })},
        {"int d = 0;", declaring("d", {}, [](Run& run) { run.declare("d"); })},
        {"for (int i = 0; i <= l; ++i)",
         counting("i", {"i", "l"}, [](Run& run) { return run.whole("i") <= run.whole("l"); })},
        {"for (int i = 0; i < l; ++i)",
         counting("i", {"i", "l"}, [](Run& run) { return run.whole("i") < run.whole("l"); })},
        {"Plot(x, y);", doing({"x", "y"},
                              [](Run& run) {
                                  run.answer.push_back(static_cast<float>(run.whole("x")));
                                  run.answer.push_back(static_cast<float>(run.whole("y")));
                              })},
        {"if (d >= 0)", deciding({"d"}, [](Run& run) { return run.whole("d") >= 0; })},
        {"if (d > 0)", deciding({"d"}, [](Run& run) { return run.whole("d") > 0; })},
        {"++y;", doing({"y"}, [](Run& run) { ++run.whole("y"); })},
        {"++x;", doing({"x"}, [](Run& run) { ++run.whole("x"); })},
        {"d -= 2 * l;", add("d", "l", -2)},
        {"d += 2 * s;", add("d", "s", 2)},
        {"d += s;", add("d", "s", 1)},
    };
    return puzzle;
}

NativeLine vector_line(const char* name, std::vector<const char*> uses,
                       std::function<glm::vec3(Run&)> value) {
    return declaring(name, std::move(uses), [=](Run& run) {
        const glm::vec3 v = value(run);
        run.declare(name).vector = v;
    });
}

NativeLine real_line(const char* name, std::vector<const char*> uses,
                     std::function<float(Run&)> value) {
    return declaring(name, std::move(uses), [=](Run& run) {
        const float x = value(run);
        run.declare(name).x = x;
    });
}

/// `return`: what is given back counts only once, and ends the function.
NativeLine returning(std::vector<const char*> uses, std::function<glm::vec3(Run&)> value) {
    NativeLine line = doing(std::move(uses), [=](Run& run) {
        const glm::vec3 v = value(run);
        run.answer = {v.x, v.y, v.z};
        throw Returned{};
    });
    return line;
}

glm::vec3 given_vector(const Run& run, std::size_t first) {
    return {run.given[first], run.given[first + 1], run.given[first + 2]};
}

NativePuzzle native_light() {
    NativePuzzle puzzle;
    puzzle.parameters = {"position", "normal", "reflectance"};
    puzzle.begin = [](Run& run) {
        run.declare("position").vector = given_vector(run, 0);
        run.declare("normal").vector = given_vector(run, 3);
        run.declare("reflectance").vector = {0.75f, 0.5f, 0.15f};
        run.answer = {0.0f, 0.0f, 0.0f};
    };
    puzzle.end = [](Run&) {};
    const glm::vec3 lamp{0.0f, -0.5f, -0.7f}, power{14.0f, 12.0f, 10.0f};
    const glm::vec3 indirect{0.5f, 0.4f, 0.3f};
    const auto vector = [](Run& run, const char* name) { return run.at(name).vector; };
    const float sphere = 4.0f * 3.14159265f;
    puzzle.lines = {
        {"vec3 r = lightPos - position;",
         vector_line("r", {"position"}, [=](Run& run) { return lamp - vector(run, "position"); })},
        {"vec3 r = position - lightPos;",
         vector_line("r", {"position"}, [=](Run& run) { return vector(run, "position") - lamp; })},
        {"float r2 = dot(r, r);",
         real_line("r2", {"r"},
                   [=](Run& run) { return glm::dot(vector(run, "r"), vector(run, "r")); })},
        {"float c = max(0.0f, dot(r, normal) / sqrt(r2));",
         real_line("c", {"r", "normal", "r2"},
                   [=](Run& run) {
                       const float dot = glm::dot(vector(run, "r"), vector(run, "normal"));
                       return std::max(0.0f, dot / std::sqrt(run.at("r2").x));
                   })},
        {"vec3 D = lightPower * c / (4 * pi * r2);",
         vector_line("D", {"c", "r2"},
                     [=](Run& run) { return power * run.at("c").x / (sphere * run.at("r2").x); })},
        {"vec3 D = lightPower * c / (4 * pi * sqrt(r2));",
         vector_line("D", {"c", "r2"},
                     [=](Run& run) {
                         return power * run.at("c").x / (sphere * std::sqrt(run.at("r2").x));
                     })},
        {"return reflectance * (D + indirect);", returning({"reflectance", "D"},
                                                           [=](Run& run) {
                                                               return vector(run, "reflectance") *
                                                                      (vector(run, "D") + indirect);
                                                           })},
        {"return reflectance * D + indirect;",
         returning(
             {"reflectance", "D"},
             [=](Run& run) { return vector(run, "reflectance") * vector(run, "D") + indirect; })},
    };
    return puzzle;
}

NativePuzzle native_positions() {
    NativePuzzle puzzle;
    puzzle.parameters = {"a", "b", "result"};
    puzzle.begin = [](Run& run) {
        run.declare("a").vector = given_vector(run, 0);
        run.declare("b").vector = given_vector(run, 3);
        run.declare("n").whole = 5;
        run.declare("zinv").x = 1.0f / run.given[2];
        run.vectors.assign(5, glm::vec3(0.0f));
    };
    puzzle.end = [](Run& run) {
        for (const glm::vec3& v : run.vectors)
            run.answer.insert(run.answer.end(), {v.x, v.y, v.z});
    };
    const auto vector = [](Run& run, const char* name) { return run.at(name).vector; };
    const auto nothing = [](Run&) {};
    puzzle.lines = {
        // Those that are given; begin() has done what they do.
        {"int n = result.size();", declaring("n", {"result"}, nothing)},
        {"float zinv = 1 / a.z;",
         real_line("zinv", {"a"}, [=](Run& run) { return 1.0f / vector(run, "a").z; })},
        {"float stepZinv = (1 / b.z - zinv) / (n - 1);",
         real_line("stepZinv", {"b", "zinv", "n"},
                   [=](Run& run) {
                       return (1.0f / vector(run, "b").z - run.at("zinv").x) /
                              static_cast<float>(run.whole("n") - 1);
                   })},
        {"vec3 q = a * zinv;",
         vector_line("q", {"a", "zinv"},
                     [=](Run& run) { return vector(run, "a") * run.at("zinv").x; })},
        {"vec3 q = a;", vector_line("q", {"a"}, [=](Run& run) { return vector(run, "a"); })},
        {"vec3 stepQ = (b / b.z - q) / float(n - 1);",
         vector_line("stepQ", {"b", "q", "n"},
                     [=](Run& run) {
                         const glm::vec3 b = vector(run, "b");
                         return (b / b.z - vector(run, "q")) /
                                static_cast<float>(run.whole("n") - 1);
                     })},
        {"for (int i = 0; i < n; ++i)",
         counting("i", {"i", "n"}, [](Run& run) { return run.whole("i") < run.whole("n"); })},
        {"result[i] = q / zinv;", doing({"result", "i", "q", "zinv"},
                                        [=](Run& run) {
                                            element(run.vectors, run.whole("i")) =
                                                vector(run, "q") / run.at("zinv").x;
                                        })},
        {"result[i] = q;",
         doing({"result", "i", "q"},
               [=](Run& run) { element(run.vectors, run.whole("i")) = vector(run, "q"); })},
        {"q += stepQ;",
         doing({"q", "stepQ"}, [=](Run& run) { run.at("q").vector += vector(run, "stepQ"); })},
        {"zinv += stepZinv;",
         doing({"zinv", "stepZinv"}, [](Run& run) { run.at("zinv").x += run.at("stepZinv").x; })},
        {"zinv += 1 / stepZinv;",
         doing({"zinv", "stepZinv"},
               [](Run& run) { run.at("zinv").x += 1.0f / run.at("stepZinv").x; })},
    };
    return puzzle;
}

/// Equal, apart from the rounding of a few sums.
bool is_near(const std::vector<float>& a, const std::vector<float>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
        return x == y || std::abs(x - y) <= 1e-5f * std::max(std::abs(y), 1.0f);
    });
}

/// The answer to a question; none: it does not compile, or it fails.
std::optional<std::vector<float>> native_answer(const NativePuzzle& native,
                                                const std::vector<PuzzleLine>& lines,
                                                const PuzzleQuestion& question) {
    const std::vector<PuzzleLine> body(lines.begin() + 1, lines.end());
    const Native function(native.lines, body);
    if (!function.compiles(native.parameters)) return std::nullopt;
    Run run;
    run.given = question.given;
    native.begin(run);
    try {
        function.carry_out(run);
    } catch (const Returned&) {
        // At its end, or before.
    } catch (const Failure&) {
        return std::nullopt;
    }
    native.end(run);
    return run.answer;
}

using Order = std::vector<PlacedPiece>;

/// All orders that are one move away: a piece is put somewhere, indented differently or taken out.
std::vector<Order> moved(const LessonPuzzle& puzzle, const Order& order) {
    std::vector<Order> all;
    for (int piece = 0; piece < piece_count(puzzle); ++piece) {
        Order without;
        int depth = 0; // it is not used
        for (const PlacedPiece& one : order) {
            if (one.piece == piece) {
                depth = one.depth;
            } else {
                without.push_back(one);
            }
        }
        if (without.size() < order.size()) all.push_back(without);
        for (std::size_t place = 0; place <= without.size(); ++place) {
            // As deep as it was, or as the line there.
            const std::size_t there = std::min(place, without.size() - 1);
            std::set<int> depths{depth, without[there].depth};
            const std::size_t before = without.size() < order.size() ? place : without.size() + 1;
            const bool is_in_place = before < order.size() && order[before].piece == piece;
            if (is_in_place) depths = {depth - 1, depth + 1};
            for (const int wanted : depths) {
                if (wanted < 1) continue;
                Order put = without;
                put.insert(put.begin() + static_cast<std::ptrdiff_t>(place), {piece, wanted});
                all.push_back(put);
            }
        }
    }
    return all;
}

std::string text_of(const LessonPuzzle& puzzle, const Order& order) {
    return source_of(function_of(puzzle, order));
}

/// Every order within two moves, once.
std::vector<Order> within_two_moves(const LessonPuzzle& puzzle) {
    std::map<std::string, Order> all;
    const Order right = right_order(puzzle);
    all[text_of(puzzle, right)] = right;
    for (const Order& one : moved(puzzle, right)) {
        all[text_of(puzzle, one)] = one;
        for (const Order& two : moved(puzzle, one))
            all[text_of(puzzle, two)] = two;
    }
    std::vector<Order> orders;
    for (const auto& [text, order] : all)
        orders.push_back(order);
    return orders;
}

void check_all_orders(const std::string& path, const NativePuzzle& native) {
    const Lesson lesson = read_lesson(lessons_folder() + "/" + path);
    // The last one; one before it is a gap.
    const LessonPuzzle& puzzle = lesson.puzzles.at(lesson.puzzles.size() - 1);
    const PuzzleExam& exam = *find_exam(puzzle.exam);
    std::vector<std::vector<float>> wanted;
    for (const PuzzleQuestion& question : exam.questions)
        wanted.push_back(native_answer(native, puzzle.lines, question).value());
    const std::vector<float> none;
    const std::vector<Order> orders = within_two_moves(puzzle);
    CHECK(orders.size() > 500);
    for (const Order& order : test::some_of(orders, 20)) {
        const std::vector<PuzzleLine> lines = function_of(puzzle, order);
        bool is_right = true;
        for (std::size_t i = 0; i < wanted.size() && is_right; ++i)
            is_right =
                is_near(native_answer(native, lines, exam.questions[i]).value_or(none), wanted[i]);
        const PuzzleVerdict verdict = judge_order(puzzle, order);
        if (verdict.is_right == is_right) continue;
        FAIL_CHECK(source_of(lines)
                   << "is " << (is_right ? "right" : "wrong")
                   << ", but the judge says: " << (verdict.is_right ? "right" : verdict.sentence));
        return;
    }
    CHECK(judge_order(puzzle, right_order(puzzle)).is_right);
}

} // namespace

TEST_CASE("Every order of Interpolate's lines within two moves is judged as a compiler would") {
    check_all_orders("04-edges.md", native_interpolate());
}

TEST_CASE("Every order of ComputePolygonRows' lines within two moves is judged as a compiler "
          "would") {
    check_all_orders("05-row-table.md", native_rows());
}

TEST_CASE("Every order of the depth test's lines within two moves is judged as a compiler would") {
    check_all_orders("08-depth-buffer.md", native_depth());
}

TEST_CASE("Every order of Bresenham's lines within two moves is judged as a compiler would") {
    check_all_orders("20-bresenham.md", native_line());
}

TEST_CASE("Every order of the light's lines within two moves is judged as a compiler would") {
    check_all_orders("09-light-per-vertex.md", native_light());
}

TEST_CASE("Every order of the lines of perspective within two moves is judged as a compiler "
          "would") {
    check_all_orders("11-perspective.md", native_positions());
}
