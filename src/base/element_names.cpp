#include "base/element_names.h"

namespace rasterwalk {

std::string element_name(std::string_view form, int index, const Language& language) {
    std::string name(tr(form, language));
    if (const std::size_t at = name.find('#'); at != name.npos) {
        name.replace(at, 1, std::to_string(index));
    }
    return name;
}

std::string element_name_of(std::string_view form, int index, int count, const Language& language) {
    const std::string name = element_name(form, index, language);
    return form.ends_with(']') ? tr(language, "{} of {}", name, count) : name;
}

std::string triangle_name(int triangle) {
    return element_name(triangle_form, triangle);
}

std::string vertex_name(int vertex) {
    return element_name(vertex_form, vertex);
}

std::string edge_name(int edge) {
    return element_name(edge_form, edge);
}

std::string sample_name(int edge, int sample) {
    return edge_name(edge) + ", " + element_name(sample_form, sample);
}

std::string short_triangle_name(int triangle) {
    return "t" + std::to_string(triangle);
}

std::string short_vertex_name(int vertex) {
    return "v" + std::to_string(vertex);
}

} // namespace rasterwalk
