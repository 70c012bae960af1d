#include <chrono>
#include <exception>
#include <iostream>
#include <new>
#include <utility>

#include <unistd.h>

#include "base/error.h"
#include "base/quoted.h"
#include "cli/cli.h"
#include "engines/llvmpipe_peer.h"
#include "engines/opengl_peer.h"
#include "ui/hosts/window.h"

namespace {

double milliseconds_now() {
    const std::chrono::duration<double, std::milli> time =
        std::chrono::steady_clock::now().time_since_epoch();
    return time.count();
}

} // namespace

int main(int argc, char** argv) {
    using rasterwalk::ExitCode;
    const auto complain = [](const char* sentence, ExitCode code) {
        std::cerr << "rasterwalk: " << rasterwalk::visible_line(sentence) << '\n';
        return static_cast<int>(code);
    };
    try {
        // Commands need no display, so another program draws with OpenGL for them.
        rasterwalk::PeerOpenGl opengl(rasterwalk::llvmpipe_program());
        const rasterwalk::UsedOpenGl used(opengl);
        rasterwalk::CliRequest request;
        const bool is_watched = isatty(STDERR_FILENO) == 1;
        const int exit_code =
            rasterwalk::run_cli(argc, argv, std::cout, std::cerr, request, milliseconds_now,
                                is_watched ? &std::cerr : nullptr);
        if (request.open_window) {
            rasterwalk::show_window(std::move(request.session), request.is_plain,
                                    std::move(request.reading), request.code);
        }
        return exit_code;
    } catch (const rasterwalk::Error& fault) {
        return complain(fault.what(), fault.code);
    } catch (const std::bad_alloc&) {
        return complain("there is not enough memory for this.", ExitCode::no_access);
    } catch (const std::exception& fault) {
        return complain(fault.what(), ExitCode::no_access);
    }
}
