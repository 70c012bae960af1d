#include <chrono>
#include <iostream>

#include "cli/cli.h"

/// The commands without a window, under Node.
int main(int argc, char** argv) {
    const auto milliseconds_now = [] {
        const std::chrono::duration<double, std::milli> time =
            std::chrono::steady_clock::now().time_since_epoch();
        return time.count();
    };
    rasterwalk::CliRequest request;
    return rasterwalk::run_cli(argc, argv, std::cout, std::cerr, request, milliseconds_now);
}
