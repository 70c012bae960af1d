#include "cli/interrupt.h"

#include <csignal>

namespace rasterwalk {

namespace {

volatile std::sig_atomic_t is_pressed = 0;

extern "C" void record_interrupt(int) {
    is_pressed = 1;
}

} // namespace

Interrupt::Interrupt() : before_(std::signal(SIGINT, record_interrupt)) {
    if (before_ == SIG_IGN) std::signal(SIGINT, SIG_IGN);
}

Interrupt::~Interrupt() {
    std::signal(SIGINT, before_);
    is_pressed = 0;
}

bool Interrupt::was_interrupted() const {
    return is_pressed != 0;
}

} // namespace rasterwalk
