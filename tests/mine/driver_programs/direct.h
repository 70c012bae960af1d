// Belongs before direct() in the programs of test_driver.cpp. What direct() says after the first
// frame is what the driver must have written.

#pragma once

#include <cstdio>
#include <initializer_list>
#include <vector>

#include "runtime.h"

void direct();

/// Prints the numbers that are expected of the next question of a part.
inline void say(rasterwalk_kit::Part part, const std::vector<double>& numbers) {
    std::printf("%d", static_cast<int>(part));
    for (const double number : numbers) std::printf(" %.17g", number);
    std::printf("\n");
}

inline void say(rasterwalk_kit::Part part, std::initializer_list<double> numbers) {
    say(part, std::vector<double>(numbers));
}

/// Says how many pixels this puts, and each of them.
template <class Draw>
void say_puts(rasterwalk_kit::Part part, Draw draw) {
    std::vector<rasterwalk_kit::Put> puts;
    rasterwalk_kit::capture_puts(&puts);
    draw();
    rasterwalk_kit::capture_puts(nullptr);
    std::vector<double> numbers{static_cast<double>(puts.size())};
    for (const rasterwalk_kit::Put& put : puts) {
        numbers.insert(numbers.end(), {double(put.x), double(put.y), put.red, put.green, put.blue});
    }
    say(part, numbers);
}

/// How many pixels this puts.
template <class Draw>
double puts_of(Draw draw) {
    std::vector<rasterwalk_kit::Put> puts;
    rasterwalk_kit::capture_puts(&puts);
    draw();
    rasterwalk_kit::capture_puts(nullptr);
    return static_cast<double>(puts.size());
}
