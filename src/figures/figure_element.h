#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/quoted.h"
#include "figures/figure_tags.h"

namespace rasterwalk {

/// The attributes of one element, each of which is taken by what reads it.
class FigureElement {
  public:
    FigureElement(const FigureTag& tag, const std::string& path)
        : tag_(tag), path_(path), is_taken_(tag.attributes.size()) {}

    const std::string& name() const { return tag_.name; }
    int line() const { return tag_.line; }

    /// Null if it is not there.
    const FigureAttribute* take(std::string_view name) {
        for (std::size_t i = 0; i < tag_.attributes.size(); ++i) {
            if (tag_.attributes[i].name != name) continue;
            is_taken_[i] = true;
            return &tag_.attributes[i];
        }
        return nullptr;
    }
    const FigureAttribute& need(std::string_view name) {
        const FigureAttribute* const found = take(name);
        if (found == nullptr) fail(tag_.line, fmt::format("<{}> needs '{}'.", tag_.name, name));
        return *found;
    }

    /// Refuses what nothing has taken.
    void end() const {
        for (std::size_t i = 0; i < is_taken_.size(); ++i) {
            if (is_taken_[i]) continue;
            fail(tag_.attributes[i].line, fmt::format("<{}> has no attribute {}.", tag_.name,
                                                      in_quotes(tag_.attributes[i].name)));
        }
    }

    /// Runs an action that reads an attribute; what it refuses is a fault in the attribute's line.
    template <class Action>
    auto attempt(const FigureAttribute& attribute, Action action) const {
        try {
            return action();
        } catch (const UsageError& fault) {
            fail(attribute.line, attribute.name + ": " + fault.what());
        }
    }

    [[noreturn]] void fail(int line, const std::string& sentence) const {
        throw InputError(path_, line, sentence);
    }

  private:
    const FigureTag& tag_;
    const std::string& path_;
    std::vector<bool> is_taken_;
};

} // namespace rasterwalk
