#include "cli/machine.h"

#include "base/numbers.h"
#include "engines/processor.h"

namespace rasterwalk {

std::string machine_text() {
    const std::string name = processor_name();
    return (name.empty() ? name : name + ", ") +
           counted(processor_count(), "processor", "processors");
}

Json machine_to_json() {
    const std::string name = processor_name();
    return {{"processor", name.empty() ? Json() : Json(name)}, {"processors", processor_count()}};
}

} // namespace rasterwalk
