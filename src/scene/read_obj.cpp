#include "scene/read_obj.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/files.h"
#include "base/limits.h"
#include "base/quoted.h"
#include "scene/obj_building.h"
#include "scene/obj_materials.h"
#include "scene/obj_statements.h"
#include "scene/obj_words.h"

namespace rasterwalk {

namespace {

void count_statements(const ObjStatements& file, ObjCounts& counts) {
    counts.lines = file.lines;
    counts.positions = static_cast<std::int64_t>(file.positions.size());
    counts.texcoords = static_cast<std::int64_t>(file.texcoords.size());
    counts.normals = static_cast<std::int64_t>(file.normals.size());
}

[[noreturn]] void refuse_empty(const ObjModel& model) {
    if (model.report.faults.empty()) {
        throw InputError(visible_line(model.path), 1,
                         "there is no face in this file that can be "
                         "drawn.");
    }
    throw InputError(fault_line(model.report.faults.front()) +
                     " No face in the whole file can be drawn.");
}

/// Keeps what belongs to the text, if that is kept.
void keep_source(ObjStatements& file, std::size_t bytes, ModelSource& source) {
    source.bytes = bytes;
    source.lines = file.lines;
    if (bytes > most_kept_model_text) return;
    source.line_marks = std::move(file.line_marks);
    source.corners = std::move(file.corners);
    source.position_lines = std::move(file.position_lines);
    source.texcoord_lines = std::move(file.texcoord_lines);
    source.normal_lines = std::move(file.normal_lines);
}

/// A model without the text of its source.
ObjModel parse(std::string_view text, const std::string& path, const ObjOptions& options,
               const ReadingWatch& watch, ModelSource& source) {
    if (is_utf16(text))
        throw InputError(visible_line(path), 1, "the file is UTF-16; a model must be plain text.");
    ObjModel model;
    model.path = path;
    source.path = path;
    ObjReporter reporter(model.report);
    WatchedSteps watched(watch);
    ObjLibraries libraries(model.path, model.materials, watched, reporter);
    ObjStatements file = read_statements(text, model.path, watched, libraries, reporter);
    count_statements(file, model.report.counts);
    build_model(file, options, watched, reporter, model, source.triangles);
    if (model.mesh.triangle_count() == 0) refuse_empty(model);
    keep_source(file, text.size(), source);
    return model;
}

} // namespace

bool is_model_file(std::string_view path) {
    constexpr std::string_view ending = ".obj";
    if (path.size() <= ending.size()) return false;
    const std::string_view end = path.substr(path.size() - ending.size());
    return std::equal(end.begin(), end.end(), ending.begin(),
                      [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
}

ObjModel parse_obj(std::string_view text, const std::string& path, const ObjOptions& options,
                   const ReadingWatch& watch) {
    const auto source = std::make_shared<ModelSource>();
    ObjModel model = parse(text, path, options, watch, *source);
    if (text.size() <= most_kept_model_text) source->text = text;
    model.source = source;
    return model;
}

ObjModel read_obj(const std::string& path, const ObjOptions& options, const ReadingWatch& watch) {
    const auto source = std::make_shared<ModelSource>();
    source->state = file_state(path);
    std::string text = read_file(path, largest_model_file);
    ObjModel model = parse(text, path, options, watch, *source);
    if (text.size() <= most_kept_model_text) source->text = std::move(text);
    model.source = source;
    return model;
}

} // namespace rasterwalk
