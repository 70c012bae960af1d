#include "lessons/lesson_blocks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>

#include "base/limits.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "base/toml_input.h"
#include "facts/facts.h"
#include "lessons/lesson_link.h"
#include "lessons/widget_names.h"
#include "picture/view_image.h"
#include "session/depth_view.h"
#include "session/second_run.h"
#include "session/tabs.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

int line_of(const toml::node& node) {
    return static_cast<int>(node.source().begin.line);
}

/// What each key of a table does. A key that is not there, or that fails, stops no other.
using Keys = std::map<std::string_view, std::function<void(const toml::node&)>>;

/// A table of a lesson with the faults that are found in it.
class Block {
  public:
    Block(const toml::table& table, int line, std::string what, FaultList& faults)
        : input_(table, faults.path(), std::move(what)), line_(line), faults_(faults) {}

    void read(const Keys& keys) {
        for (auto&& [key, node] : input_.nodes()) {
            const auto found = keys.find(std::string_view(key.str()));
            const toml::node& value = node;
            if (found == keys.end()) {
                refuse_key(key.str(), value, keys);
            } else {
                faults_.attempt(line_of(value), [&] { found->second(value); });
            }
        }
    }

    /// A key that must be there.
    void require(std::string_view key) {
        if (input_.find(key) == nullptr) {
            faults_.add(line_, input_.what() + " needs '" + std::string(key) + "'.");
        }
    }

    std::string text(const toml::node& node) const {
        const auto* text = node.as_string();
        if (text == nullptr) input_.fail(node, "text in quotes is needed here.");
        if (trimmed(text->get()).empty()) input_.fail(node, "this text must not be empty.");
        return text->get();
    }

    int whole(const toml::node& node, int smallest, int largest) const {
        const auto* number = node.as_integer();
        if (number == nullptr || number->get() < smallest || number->get() > largest) {
            input_.fail(node, "a whole number between " + std::to_string(smallest) + " and " +
                                  std::to_string(largest) + " is needed here.");
        }
        return static_cast<int>(number->get());
    }

    /// Every text of a list, each with its own faults.
    void for_each_text(const toml::node& node, std::size_t most,
                       const std::function<void(const std::string&)>& use) const {
        const toml::array* list = node.as_array();
        if (list == nullptr) input_.fail(node, "a list of texts is needed here: [\"...\"].");
        if (list->size() > most) {
            input_.fail(node, "the list has more than " + std::to_string(most) + " entries.");
        }
        for (const toml::node& entry : *list)
            faults_.attempt(line_of(entry), [&] { use(text(entry)); });
    }

    const toml::table& table(const toml::node& node) const {
        const toml::table* table = node.as_table();
        if (table == nullptr) input_.fail(node, "a table is needed here: { ... }.");
        return *table;
    }

    const TomlInput& input() const { return input_; }
    FaultList& faults() { return faults_; }

  private:
    void refuse_key(std::string_view key, const toml::node& node, const Keys& keys) {
        std::vector<std::string_view> names;
        std::string known;
        for (const auto& [name, use] : keys) {
            names.push_back(name);
            known.append(known.empty() ? "" : ", ").append(name);
        }
        faults_.add(line_of(node), input_.what() + " has no " + in_quotes(key) +
                                       "; it has: " + known + "." + did_you_mean(key, names));
    }

    TomlInput input_;
    int line_;
    FaultList& faults_;
};

std::string word(const Block& block, const toml::node& node, const char* what,
                 std::span<const std::string_view> words) {
    const std::string text = block.text(node);
    for (const std::string_view one : words) {
        if (one == text) return text;
    }
    std::string known;
    for (const std::string_view one : words)
        known.append(known.empty() ? "" : ", ").append(one);
    block.input().fail(node, std::string("there is no ")
                                 .append(what)
                                 .append(" ")
                                 .append(in_quotes(text))
                                 .append("; there are ")
                                 .append(known)
                                 .append(".")
                                 .append(did_you_mean(text, words)));
}

std::vector<std::string> assignments(const Block& block, const toml::node& node) {
    constexpr std::size_t most = 100;
    std::vector<std::string> list;
    block.for_each_text(node, most, [&](const std::string& assignment) {
        Settings tried;
        set_from_text(tried, assignment);
        list.push_back(assignment);
    });
    return list;
}

glm::ivec2 pixel(const Block& block, const toml::node& node) {
    const std::optional<glm::ivec2> pixel = parse_pixel(block.text(node));
    if (!pixel) block.input().fail(node, "a pixel is needed here: \"250,131\".");
    return *pixel;
}

/// The keys of a situation.
void add_situation_keys(Keys& keys, Block& block, Situation& s) {
    const auto noted = [&s](const char* key, auto use) {
        return [&s, key, use](const toml::node& node) {
            s.lines[key] = line_of(node);
            use(node);
        };
    };
    const auto add = [&](const char* key, auto use) { keys[key] = noted(key, use); };
    add("scene", [&](const toml::node& n) { s.scene = block.text(n); });
    add("set", [&](const toml::node& n) { s.set = assignments(block, n); });
    add("compare", [&](const toml::node& n) { s.compare = assignments(block, n); });
    add("cursor", [&](const toml::node& n) {
        s.cursor = parse_cursor(block.text(n));
        if (!s.cursor) {
            block.input().fail(n, in_quotes(block.text(n)) +
                                      " is not a moment; one is written t12, t12/v1, t12/e2/s14, "
                                      "t12/r37/c5 or end.");
        }
    });
    add("pixel", [&](const toml::node& n) { s.pixel = pixel(block, n); });
    add("triangle", [&](const toml::node& n) { s.triangle = block.whole(n, 0, max_triangles); });
    add("row", [&](const toml::node& n) { s.row = block.whole(n, 0, largest_viewport); });
    add("vertex", [&](const toml::node& n) { s.vertex = block.whole(n, 0, 2); });
    add("tab", [&](const toml::node& n) { s.tab = word(block, n, "tab", tab_names()); });
    add("view",
        [&](const toml::node& n) { s.view = find_view(word(block, n, "view", view_names())); });
    add("overlays", [&](const toml::node& n) {
        s.overlays = OverlaySet{};
        block.for_each_text(n, overlay_count, [&](const std::string& name) {
            const std::optional<Overlay> overlay = find_overlay(name);
            if (!overlay) {
                parse_lesson_link("overlay:" + name); // says which there are
            } else {
                s.overlays->set(*overlay, true);
            }
        });
    });
    add("zoom", [&](const toml::node& n) {
        s.zoom = block.input().number(n, 0.0f, largest_zoom, "the zoom");
        if (*s.zoom != 0.0f && *s.zoom < smallest_zoom) {
            block.input().fail(n, "the zoom is 0.25 to 64, or 0 to fit.");
        }
    });
    add("centre", [&](const toml::node& n) {
        s.centre = parse_place(block.text(n));
        if (!s.centre) block.input().fail(n, "a place in the picture is needed here: \"250,131\".");
        if (std::max(std::abs(s.centre->x), std::abs(s.centre->y)) > farthest_centre) {
            block.input().fail(n, "this place lies too far outside the picture.");
        }
    });
    add("compare_view", [&](const toml::node& n) {
        const std::string name = word(block, n, "way to compare", compare_view_names());
        s.compare_view = find_compare_view(name);
    });
    add("wipe", [&](const toml::node& n) {
        s.wipe = block.input().number(n, 0.0f, 1.0f, "the place of the divider");
    });
    add("grid", [&](const toml::node& n) {
        s.grid = n.value_exact<bool>();
        if (!s.grid) block.input().fail(n, "the grid is true or false.");
    });
    add("depth_range", [&](const toml::node& n) {
        s.depth_range = parse_depth_range(block.text(n));
        if (!s.depth_range) {
            block.input().fail(n, "a range of 1/z is needed here, far and near: \"0.2,0.8\".");
        }
    });
    add("vertices", [&](const toml::node& n) {
        block.for_each_text(n, most_placed_triangles, [&](const std::string& text) {
            s.vertices.push_back(parse_placed_triangle(text));
        });
    });
    add("point_at", [&](const toml::node& n) {
        check_widget_name(block.text(n));
        s.point_at = block.text(n);
    });
}

Expression condition(const Block& block, const toml::node& node) {
    return parse_condition(block.text(node));
}

/// An expression is text; a plain number may stand without quotes.
Expression expression(const Block& block, const toml::node& node) {
    if (const std::optional<double> number = node.value<double>()) {
        // All digits of a double: a count may be larger than a float tells.
        std::array<char, 64> digits;
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), *number).ptr;
        return parse_expression({digits.data(), end});
    }
    return parse_expression(block.text(node));
}

/// Ids are letters, digits, - and _: they are written into the file of the progress.
std::string id(const Block& block, const toml::node& node) {
    constexpr std::size_t longest = 60;
    std::string text = block.text(node);
    const bool is_good =
        text.size() <= longest &&
        text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_") == text.npos;
    if (!is_good) {
        block.input().fail(node, "an id has small letters, digits, - and _, at most " +
                                     std::to_string(longest) + ".");
    }
    return text;
}

using PredictionKind = LessonPrediction::Kind;

/// Which keys each kind needs, and which belong to another kind.
void check_kind(Block& block, PredictionKind kind) {
    struct Rule {
        std::string_view key;
        PredictionKind kind;
        bool is_needed;
    };
    constexpr Rule rules[] = {
        {"answer", PredictionKind::number, true}, {"tolerance", PredictionKind::number, false},
        {"unit", PredictionKind::number, false},  {"choices", PredictionKind::choice, true},
        {"right", PredictionKind::choice, true},  {"where", PredictionKind::pixel, true},
        {"recipe", PredictionKind::pixel, true},  {"wrong", PredictionKind::pixel, true},
    };
    constexpr std::string_view names[] = {"number", "pixel", "choice"};
    for (const Rule& rule : rules) {
        const toml::node* const node = block.input().find(rule.key);
        if (rule.kind == kind && rule.is_needed && node == nullptr) block.require(rule.key);
        if (rule.kind != kind && node != nullptr) {
            block.faults().add(line_of(*node),
                               "'" + std::string(rule.key) + "' belongs to a prediction of kind " +
                                   std::string(names[static_cast<std::size_t>(rule.kind)]) + ".");
        }
    }
}

} // namespace

Situation read_situation(const toml::table& table, int line, FaultList& faults, const char* what) {
    Block block(table, line, what, faults);
    Situation situation;
    situation.line = line;
    Keys keys;
    add_situation_keys(keys, block, situation);
    block.read(keys);
    return situation;
}

Situation read_lesson_block(const toml::table& table, int line, Lesson& lesson, FaultList& faults) {
    Block block(table, line, "the block 'lesson'", faults);
    Situation situation;
    situation.line = line;
    Keys keys;
    add_situation_keys(keys, block, situation);
    keys["title"] = [&](const toml::node& n) { lesson.title = block.text(n); };
    keys["section"] = [&](const toml::node& n) { lesson.section = block.text(n); };
    keys["about"] = [&](const toml::node& n) { lesson.about = block.text(n); };
    keys["program"] = [&](const toml::node& n) { lesson.program = block.text(n); };
    keys["minutes"] = [&](const toml::node& n) { lesson.minutes = block.whole(n, 1, 120); };
    keys["picture"] = [&](const toml::node& n) {
        situation.lines["picture"] = line_of(n);
        lesson.picture = block.whole(n, 0, most_lesson_steps);
    };
    block.read(keys);
    for (const char* key : {"title", "section", "minutes", "about", "program"})
        block.require(key);
    return situation;
}

LessonTask read_task(const toml::table& table, int line, FaultList& faults) {
    Block block(table, line, "the block 'task'", faults);
    LessonTask task;
    task.line = task.done_line = task.recipe_line = line;
    Keys keys;
    keys["id"] = [&](const toml::node& n) { task.id = id(block, n); };
    keys["done"] = [&](const toml::node& n) {
        task.done_line = line_of(n);
        task.done = condition(block, n);
    };
    keys["recipe"] = [&](const toml::node& n) {
        task.recipe_line = line_of(n);
        std::size_t links = 0;
        if (const toml::array* list = n.as_array()) links = list->size();
        block.for_each_text(n, most_recipe_links, [&](const std::string& target) {
            parse_lesson_link(target);
            task.recipe.push_back(target);
        });
        if (links == 0) block.input().fail(n, "a task cannot be solved by doing nothing.");
        // Half a recipe solves nothing; that need not be told as well.
        if (task.recipe.size() < links) task.recipe.clear();
    };
    keys["hint"] = [&](const toml::node& n) { task.hint = block.text(n); };
    block.read(keys);
    for (const char* key : {"id", "done", "recipe"})
        block.require(key);
    return task;
}

LessonPrediction read_prediction(const toml::table& table, int line, const Situation& step,
                                 FaultList& faults) {
    Block block(table, line, "the block 'prediction'", faults);
    LessonPrediction p;
    p.line = p.answer_line = p.because_line = line;
    p.at = step;
    Keys keys;
    keys["id"] = [&](const toml::node& n) { p.id = id(block, n); };
    keys["kind"] = [&](const toml::node& n) {
        constexpr std::string_view names[] = {"number", "pixel", "choice"};
        const std::string name = word(block, n, "kind of prediction", names);
        p.kind = name == "number"  ? PredictionKind::number
                 : name == "pixel" ? PredictionKind::pixel
                                   : PredictionKind::choice;
    };
    keys["answer"] = [&](const toml::node& n) {
        p.answer_line = line_of(n);
        p.answer = expression(block, n);
    };
    keys["tolerance"] = [&](const toml::node& n) { p.tolerance = expression(block, n); };
    keys["unit"] = [&](const toml::node& n) { p.unit = block.text(n); };
    keys["choices"] = [&](const toml::node& n) {
        block.for_each_text(n, most_choices,
                            [&](const std::string& text) { p.choices.push_back(text); });
        if (p.choices.size() < 2) block.input().fail(n, "there must be at least two choices.");
    };
    keys["right"] = [&](const toml::node& n) {
        p.answer_line = line_of(n);
        block.for_each_text(n, most_choices, [&](const std::string& text) {
            p.right.push_back(parse_condition(text));
        });
    };
    keys["where"] = [&](const toml::node& n) {
        p.answer_line = line_of(n);
        p.where = condition(block, n);
    };
    keys["recipe"] = [&](const toml::node& n) { p.right_pixel = pixel(block, n); };
    keys["wrong"] = [&](const toml::node& n) { p.wrong_pixel = pixel(block, n); };
    keys["at"] = [&](const toml::node& n) {
        p.at = combined(step, read_situation(block.table(n), line_of(n), faults));
    };
    keys["then"] = [&](const toml::node& n) {
        p.then = combined(step, read_situation(block.table(n), line_of(n), faults));
    };
    keys["because"] = [&](const toml::node& n) {
        p.because_line = line_of(n);
        p.because = block.text(n);
    };
    block.read(keys);
    for (const char* key : {"id", "kind"})
        block.require(key);
    check_kind(block, p.kind);
    const auto size_of = [&](std::string_view key) -> std::size_t {
        const toml::node* const node = block.input().find(key);
        const toml::array* const list = node != nullptr ? node->as_array() : nullptr;
        return list != nullptr ? list->size() : 0;
    };
    if (p.kind == PredictionKind::choice && size_of("choices") != size_of("right")) {
        faults.add(p.answer_line, "'right' needs one condition for each of the choices.");
    }
    return p;
}

} // namespace rasterwalk
