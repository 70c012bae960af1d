#pragma once

// What Rasterwalk and a student's program tell each other, in memory that both have mapped: the
// task, the questions to the program's functions, and what the program did. The program is hostile
// until shown otherwise: Rasterwalk believes no number in here without a check.
//
// The memory is a file without a name, descriptor `recording_descriptor` of the program. It is read
// while the program runs and after it has died, so everything is written in place, in order.

#include <cstddef>
#include <cstdint>

namespace rasterwalk_kit {

inline constexpr std::uint32_t recording_magic = 0x6b6c6177; ///< the first number in the memory
inline constexpr int recording_descriptor = 3;

/// What a program is asked, in this order. The bits of Task::parts and Progress::answered.
enum Part : std::uint32_t {
    part_picture,       ///< the first frame: not a question, the program draws it by itself
    part_globals,       ///< its variables: camera, light, triangles
    part_vertex_shader, ///< VertexShader
    part_interpolate,   ///< Interpolate
    part_polygon_rows,  ///< ComputePolygonRows
    part_draw_rows,     ///< DrawPolygonRows, or DrawRows
    part_depth_test,    ///< fragments one behind the other, through DrawPolygonRows
    part_pixel_shader,  ///< PixelShader
    part_count,
};

/// A call of PutPixelSDL, putPixel, or whatever the program's helper calls it.
struct Put {
    std::int32_t x, y;
    float red, green, blue; ///< linear, as the program gave them, 1 is full
};

/// The values of the lab's struct Pixel, whatever the program calls its members.
struct PixelValues {
    double fields;   ///< sum of PixelField bits: which of the following the program has
    double x, y;     ///< pixels
    double zinv;     ///< 1/z
    double place[3]; ///< pos3d, as it is carried: the position, or the position over z
    double light[3]; ///< illumination, as it is carried
};
inline constexpr std::size_t doubles_in_pixel = sizeof(PixelValues) / sizeof(double);

enum PixelField : std::uint32_t {
    field_xy = 1,
    field_zinv = 2,
    field_place = 4,
    field_light = 8,
};

/// The variables of a program that are worth knowing: in the answer to part_globals each is its
/// number, a count, and so many doubles.
enum Global : std::uint32_t {
    global_camera,         ///< 3 doubles
    global_rotation,       ///< 9 doubles, column by column as glm stores it
    global_yaw,            ///< radians
    global_focal_length,   ///< pixels
    global_light_position, ///< 3 doubles
    global_light_power,    ///< 3 doubles, or 1
    global_indirect,       ///< 3 doubles, or 1
    global_screen,         ///< width, height
    global_triangles,      ///< 15 doubles each: v0, v1, v2, normal, colour
    global_count,
};

// Questions and answers are one double after the other. P is a PixelValues.
//   part_globals        asks nothing, as one question
//   part_vertex_shader  asks position 3, normal 3, colour 3          is answered by P
//   part_interpolate    asks P, P, count                             by n, then n P
//   part_polygon_rows   asks n, then n P                             by n, m, then n P, m P
//   part_draw_rows      asks n, then n P (left), n P (right), colour 3
//                                                                    by n, then n of x y r g b
//   part_depth_test     asks n, then n of (P, colour 3)              by n of (0 or 1: was it put)
//   part_pixel_shader   asks P, normal 3, colour 3                   by 0, or 1 and x y r g b
// In the stream of answers, each part begins with its number and each answer in it with the number
// of the question, from 0. A part ends with `end_of_part`. If a program lacks the function, its
// part is only its number, `not_written`, `end_of_part`; if the function is there but has
// parameters that cannot be filled, `not_askable` in place of `not_written`. What does not
// exist among the variables is left out. Numbers of values are what the program made; of pixels at
// most `most_listed` follow, of puts at most `most_listed_puts`. A part whose answers have no room
// ends before the question that has none, and is not in Progress::answered.
inline constexpr double end_of_part = -1.0, not_written = -2.0, not_askable = -3.0;
inline constexpr std::size_t most_listed = 8192;
inline constexpr std::size_t most_listed_puts = std::size_t{1} << 18;

/// What the program is to do. Written before it starts.
struct Task {
    std::uint32_t magic;
    std::uint32_t parts;       ///< bits, 1 << Part
    std::uint32_t before_main; ///< 1: asked before main(), because the first frame never ends
    std::uint32_t frames;      ///< so many are drawn; then the program ends, exit code 0
    std::int32_t key;          ///< held from the second frame on: an SDL 2 keycode, 'w' or
                               ///< 0x40000052 (up); 0: none
    std::uint64_t question_end[part_count]; ///< doubles: part i asks from the end of part i - 1
};

/// The last thing that happened: after a crash it says where the program was.
enum Moment : std::uint32_t {
    moment_none,
    moment_started, ///< its static objects are being made
    moment_asked,   ///< a function is being asked: Progress::part and question
    moment_window,  ///< it has opened its window
    moment_put,     ///< it has put a pixel
    moment_shown,   ///< it has shown a frame
    moment_ended,   ///< it has drawn its last frame, or has left main()
};

/// What the guard refused to the program, in order.
struct Refused {
    std::uint32_t call;  ///< number of the system call
    std::uint32_t count; ///< how often
    std::uint64_t place; ///< address in the program's file that asked for it; 0: not known
};
inline constexpr std::size_t most_refused = 16;

/// How often a function of the program was called in the first frame. Used and unused entries are
/// mixed.
struct Calls {
    std::uint64_t place; ///< its address in the program's file; 0: the entry is not used
    std::uint64_t count;
};
inline constexpr std::size_t most_called = 256;
inline constexpr std::size_t most_frames_deep = 32;

/// What the program did so far.
struct Progress {
    std::uint32_t moment;       ///< Moment
    std::uint32_t part;         ///< being asked
    std::uint64_t question;     ///< being asked, in that part, from 0
    std::uint32_t answered;     ///< bits: parts that were asked to their end
    std::int32_t width, height; ///< of its window, pixels; 0: none was opened
    std::uint32_t frames;       ///< shown so far
    // The next three are of the first frame, since its picture was last cleared.
    std::uint64_t puts;       ///< pixels put; the first most_puts are kept
    std::uint64_t outside;    ///< of these, outside the picture
    std::uint64_t direct;     ///< pixels written into the surface's memory without PutPixelSDL
    std::uint64_t answers;    ///< doubles
    std::uint32_t dialect;    ///< Dialect
    std::int32_t signal;      ///< that ended it; 0: none
    std::int32_t signal_code; ///< si_code
    std::uint32_t depth;      ///< addresses in `stack`
    std::uint64_t address;    ///< that it touched
    std::uint64_t stack[most_frames_deep]; ///< where it was, the innermost first: addresses in the
                                           ///< program's file, as addr2line takes them
    Refused refused[most_refused];
    Calls calls[most_called];
    std::uint64_t later_outside; ///< puts outside the picture in the frames after the first
};

/// Which helper the program was written for.
enum Dialect : std::uint32_t {
    dialect_none,
    dialect_surface, ///< SDL_Surface* and free functions
    dialect_class,   ///< SDL2Aux
    dialect_screen,  ///< struct screen
};

inline constexpr std::size_t most_questions = std::size_t{1} << 17; ///< doubles
inline constexpr std::size_t most_answers = std::size_t{1} << 22;   ///< doubles
inline constexpr std::size_t most_puts = std::size_t{1} << 22;
inline constexpr std::size_t most_pixels = std::size_t{1} << 22; ///< of a picture; a larger one
                                                                 ///< is not kept

/// All of the memory. Only what is used takes up room.
struct Recorded {
    Task task;
    Progress progress;
    double questions[most_questions];
    double answers[most_answers];
    Put puts[most_puts];            ///< of the first frame, in order
    float picture[most_pixels * 3]; ///< of the first frame: red green blue, row by row from the top
};

} // namespace rasterwalk_kit
