// Belongs behind the driver in the programs of test_driver.cpp: direct() is called after it.

#pragma once

static void (*const ask_before_direct)() = rasterwalk_kit::after_first_frame;
static const bool is_direct_set = [] {
    rasterwalk_kit::after_first_frame = [] {
        ask_before_direct();
        direct();
        std::fflush(stdout);
    };
    return true;
}();
