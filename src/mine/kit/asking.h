#pragma once

// All that driver.h needs and that does not depend on the student's code. Include it before that
// code, best in a precompiled header: a macro of theirs could change what is written here.

#include <type_traits>

#include "asking_givers.h"
#include "asking_globals.h"
#include "asking_questions.h"
#include "runtime.h"

namespace rasterwalk_kit {

template <class Giver, class Name, class Question>
void ask_one(Question& question) {
    Giver giver{{question}};
    call_with<Name>(giver, choose_parameters<Name, Giver>());
}

/// How to ask the first of these names that can be asked.
/// @tparam OtherNames a function of such a name may be anything: it counts if it can be asked
template <class Giver, class Names, class OtherNames, class Question>
void find_function(Function<Question>& function) {
    using Name = decltype(first_name<Giver>(Joined<Names, OtherNames>{}));
    if constexpr (std::is_same_v<Name, Nothing>) {
        function.is_written = is_any_written(Names{});
    } else {
        function.is_written = true;
        function.ask = ask_one<Giver, Name, Question>;
    }
}

/// Asks a program with these names.
template <class Program>
void ask_program() noexcept {
    Functions functions;
    find_function<VertexGiver<Program>, typename Program::VertexShader,
                  typename Program::OtherVertexShaders>(functions.vertex_shader);
    find_function<InterpolateGiver<Program>, typename Program::Interpolate, List<>>(
        functions.interpolate);
    find_function<RowsGiver<Program>, typename Program::PolygonRows,
                  typename Program::OtherPolygonRows>(functions.polygon_rows);
    find_function<DrawGiver<Program>, typename Program::DrawRows, typename Program::OtherDrawRows>(
        functions.draw_rows);
    find_function<ShaderGiver<Program>, typename Program::PixelShader,
                  typename Program::OtherPixelShaders>(functions.pixel_shader);
    functions.set_surface = set_surface<Program>;
    functions.clear_depth = clear_depth<Program>;
    functions.greatest_depth = greatest_depth<Program>;
    functions.list_variables = list_variables<Program>;
    ask_all(functions);
}

} // namespace rasterwalk_kit
