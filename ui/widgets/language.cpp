#include "ui/widgets/language.h"

namespace rasterwalk {

namespace {

const Language* language_in_use = &english();

} // namespace

void use_language(const Language& language) {
    language_in_use = &language;
}

const Language& current_language() {
    return *language_in_use;
}

} // namespace rasterwalk
