#include "ui/actions/reading.h"

#include <filesystem>
#include <memory>
#include <utility>
#include <variant>

#include "base/error.h"
#include "base/quoted.h"
#include "opening/opened_view.h"
#include "session/scene_file.h"
#include "ui/actions/actions.h"
#include "ui/actions/view_files.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

FileReading::Read reader_of(const std::string& path) {
    if (!is_view_file(path) && !path.ends_with(".md"))
        return [path](const ReadingWatch& watch) -> Opened { return read_scene_file(path, watch); };
    ViewOptions options;
    options.file = path;
    return [options](const ReadingWatch& watch) -> Opened { return open_view(options, watch); };
}

/// Opens what has been read.
void take_read(Ui& ui) {
    const std::unique_ptr<FileReading> done = std::move(ui.reading.now);
    ui.reading.shown = nullptr;
    Opened opened = done->take();
    if (auto* const session = std::get_if<Session>(&opened)) {
        show_view(ui, std::move(*session));
    } else {
        show_opened_scene(ui, std::get<Scene>(std::move(opened)));
    }
}

} // namespace

void read_and_open(Ui& ui, const std::string& path) {
    begin_reading(ui, std::make_unique<FileReading>(path, reader_of(path)));
    const std::chrono::milliseconds patience = ui.reading.patience;
    if (patience.count() > 0 && ui.reading.now->is_done(patience)) take_read(ui);
}

void begin_reading(Ui& ui, std::unique_ptr<FileReading> reading) {
    stop_reading(ui);
    ui.reading.now = std::move(reading);
    ui.reading.shown = ui.session.scene;
    ui.reading.lesson = ui.session.lesson;
}

void stop_reading(Ui& ui) {
    BackgroundLoad& reading = ui.reading;
    if (!reading.now) return;
    reading.now->stop();
    reading.stopped.push_back(std::move(reading.now));
    reading.shown = nullptr;
}

void poll_background_load(Ui& ui) {
    BackgroundLoad& reading = ui.reading;
    std::erase_if(reading.stopped, [](const auto& one) { return one->is_done(); });
    if (!reading.now) return;
    if (ui.session.scene != reading.shown || ui.session.lesson != reading.lesson) {
        const std::filesystem::path path = reading.now->path();
        stop_reading(ui);
        show_info(ui.session, "Something else was opened, so " +
                                  in_quotes(path.filename().string()) +
                                  " is not read any further.");
        return;
    }
    if (!reading.now->is_done()) return;
    const std::string path = reading.now->path();
    try {
        take_read(ui);
        ui.sheets.files.kind = FileSheet::Kind::closed;
    } catch (const Error& fault) {
        show_opening_fault(ui, path, fault.what());
    }
}

bool is_reading(const Ui& ui) {
    return ui.reading.now != nullptr;
}

} // namespace rasterwalk
