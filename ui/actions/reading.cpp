#include "ui/actions/reading.h"

#include <filesystem>
#include <memory>
#include <utility>

#include "base/error.h"
#include "base/quoted.h"
#include "ui/actions/actions.h"
#include "ui/actions/view_files.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// Opens what has been read.
void take_scene(Ui& ui, SceneReading& reading) {
    try {
        show_opened_scene(ui, reading.take());
        ui.sheets.files.kind = FileSheet::Kind::closed;
    } catch (const Error& fault) {
        tell_opening_fault(ui, reading.path(), fault.what());
    }
}

} // namespace

void begin_reading(Ui& ui, const std::string& path) {
    stop_reading(ui);
    ui.reading.now = std::make_unique<SceneReading>(path);
    ui.reading.shown = ui.session.scene;
    ui.reading.lesson = ui.session.lesson;
}

void stop_reading(Ui& ui) {
    BesideReading& reading = ui.reading;
    if (!reading.now) return;
    reading.now->stop();
    reading.stopped.push_back(std::move(reading.now));
    reading.shown = nullptr;
}

void carry_on_reading(Ui& ui) {
    BesideReading& reading = ui.reading;
    std::erase_if(reading.stopped, [](const auto& one) { return one->is_done(); });
    if (!reading.now) return;
    if (ui.session.scene != reading.shown || ui.session.lesson != reading.lesson) {
        const std::filesystem::path path = reading.now->path();
        stop_reading(ui);
        tell(ui.session, "Something else was opened: " + in_quotes(path.filename().string()) +
                             " is not read any further.");
        return;
    }
    if (!reading.now->is_done()) return;
    const std::unique_ptr<SceneReading> done = std::move(reading.now);
    reading.shown = nullptr;
    take_scene(ui, *done);
}

bool is_reading(const Ui& ui) {
    return ui.reading.now != nullptr;
}

} // namespace rasterwalk
