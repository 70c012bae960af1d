#include "explain/source.h"

#include <utility>

#include <fmt/format.h>

#include "base/element_names.h"
#include "stages/shadow.h"

namespace rasterwalk {

Source from_words(std::string words) {
    Source source;
    source.name = std::move(words);
    return source;
}

Source from_setting(std::string name) {
    Source source;
    source.kind = SourceKind::setting;
    source.name = std::move(name);
    return source;
}

Source from_vertex(int triangle, int vertex, std::string value_id) {
    Source source;
    source.kind = SourceKind::vertex;
    source.name = std::move(value_id);
    source.triangle = triangle;
    source.vertex = vertex;
    return source;
}

Source from_row_end(int triangle, int row, bool is_right) {
    Source source;
    source.kind = SourceKind::row_end;
    source.triangle = triangle;
    source.row = row;
    source.is_right = is_right;
    return source;
}

Source from_moment(const Cursor& moment) {
    Source source;
    source.kind = SourceKind::moment;
    source.moment = moment;
    return source;
}

Source from_texel(int face, int column, int row) {
    Source source;
    source.kind = SourceKind::texel;
    source.face = face;
    source.column = column;
    source.row = row;
    return source;
}

Source from_formula(std::string id) {
    Source source;
    source.kind = SourceKind::formula;
    source.name = std::move(id);
    return source;
}

std::string source_text(const Source& source) {
    switch (source.kind) {
    case SourceKind::given:
        return source.name;
    case SourceKind::setting:
        return "setting " + source.name;
    case SourceKind::vertex:
        return vertex_name(source.vertex) + " of " + triangle_name(source.triangle);
    case SourceKind::row_end:
        return std::string(source.is_right ? "right" : "left") + " end of row " +
               std::to_string(source.row);
    case SourceKind::moment:
        return "the moment " + to_text(source.moment);
    case SourceKind::texel:
        return fmt::format("column {}, row {} of face {}", source.column, source.row,
                           shadow_face_names[static_cast<std::size_t>(source.face)]);
    case SourceKind::formula:
        return "a formula of its own";
    }
    return {};
}

} // namespace rasterwalk
