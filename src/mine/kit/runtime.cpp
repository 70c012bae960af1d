// See runtime.h.

#include "runtime.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "inner/crash.h"

namespace rasterwalk_kit {

void (*after_first_frame)() = nullptr;

namespace {

constexpr int longest_side = 16384;
constexpr std::uint32_t milliseconds_per_frame = 20;
constexpr std::uint32_t longest_delay = 1000;
constexpr int polls_of_a_waiting_program = 100;
constexpr int most_slots_tried = 32;            // of the table of calls, which may be full
constexpr std::uint32_t colour_bits = 0xffffff; // of 0xAARRGGBB

struct Runtime {
    Recorded* memory = nullptr;
    Canvas canvas;
    std::uint32_t* known = nullptr; ///< the canvas as puts and clears have left it
    std::size_t last_put = 0;       ///< index of its pixel
    bool is_first_frame = true;
    bool is_asking = false; ///< the hook runs
    bool has_ended = false;
    bool is_press_taken = false;
    int times_asked = 0; ///< to go on, in this frame
    int times_polled = 0;
    std::uint32_t clock = 0;
    std::vector<Put>* captured = nullptr;
};
constinit Runtime runtime;

/// Takes the place of the shared memory where there is none.
constinit Progress unrecorded_progress = {};

Progress& progress() {
    return runtime.memory != nullptr ? runtime.memory->progress : unrecorded_progress;
}

std::uint32_t wanted_frames() {
    const bool is_more = runtime.memory != nullptr && runtime.memory->task.frames > 1;
    return is_more ? runtime.memory->task.frames : 1;
}

std::size_t pixel_count() {
    return static_cast<std::size_t>(runtime.canvas.width) *
           static_cast<std::size_t>(runtime.canvas.height);
}

bool has_room_for_picture() {
    return runtime.memory != nullptr && pixel_count() <= most_pixels;
}

void set_in_picture(std::size_t pixel, float red, float green, float blue) {
    if (!has_room_for_picture()) return;
    float* to = runtime.memory->picture + 3 * pixel;
    to[0] = red;
    to[1] = green;
    to[2] = blue;
}

float part_of(std::uint32_t colour, int shift) {
    return static_cast<float>(colour >> shift & 0xff) / 255.0f;
}

/// The picture of the first frame begins again in one colour.
void begin_picture(float red, float green, float blue) {
    Progress& now = progress();
    now.puts = 0;
    now.outside = 0;
    now.direct = 0;
    const std::uint32_t colour = packed_colour(red, green, blue);
    for (std::size_t i = 0; i < pixel_count(); ++i) {
        runtime.canvas.pixels[i] = colour;
        runtime.known[i] = colour;
        set_in_picture(i, red, green, blue);
    }
}

/// memset(screen->buffer, ...) clears the picture without a call. It shows in the pixel that was
/// put last, which has changed, and in all pixels having one colour.
void find_erased() {
    const std::size_t count = pixel_count();
    if (runtime.last_put >= count || progress().puts == 0) return;
    const std::uint32_t* pixels = runtime.canvas.pixels;
    const std::uint32_t colour = pixels[runtime.last_put];
    if (colour == runtime.known[runtime.last_put]) return;
    for (std::size_t i = 0; i < count; ++i) {
        if (pixels[i] != colour) return;
    }
    begin_picture(part_of(colour, 16), part_of(colour, 8), part_of(colour, 0));
}

/// Pixels that changed without a put or a clear.
void find_direct_writes() {
    if (!runtime.is_first_frame) return;
    find_erased();
    for (std::size_t i = 0; i < pixel_count(); ++i) {
        const std::uint32_t colour = runtime.canvas.pixels[i];
        if (((colour ^ runtime.known[i]) & colour_bits) == 0) continue;
        ++progress().direct;
        set_in_picture(i, part_of(colour, 16), part_of(colour, 8), part_of(colour, 0));
        runtime.known[i] = colour;
    }
}

bool has_drawn() {
    find_direct_writes();
    return !runtime.is_first_frame || progress().puts > 0 || progress().direct > 0;
}

void call_hook() {
    if (after_first_frame == nullptr) return;
    const std::uint32_t moment = progress().moment;
    runtime.is_asking = true;
    after_first_frame();
    runtime.is_asking = false;
    capture_puts(nullptr);
    progress().moment = moment;
}

[[noreturn]] void end_program() {
    runtime.has_ended = true;
    progress().moment = moment_ended;
    std::cout.flush();
    std::fflush(nullptr);
    _exit(0);
}

/// Takes what the program has written into a row of pixels by itself, and puts it back.
void capture_row(std::vector<Put>& into, int row) {
    const auto width = static_cast<std::size_t>(runtime.canvas.width);
    std::uint32_t* const pixels = runtime.canvas.pixels + static_cast<std::size_t>(row) * width;
    const std::uint32_t* const known = runtime.known + static_cast<std::size_t>(row) * width;
    // Each question asks all rows, and most of them have not changed.
    if (std::memcmp(pixels, known, width * sizeof *pixels) == 0) return;
    for (std::size_t i = 0; i < width; ++i) {
        const std::uint32_t colour = pixels[i];
        if (((colour ^ known[i]) & colour_bits) == 0) continue;
        pixels[i] = known[i];
        if (into.size() >= most_puts) continue;
        into.push_back({static_cast<std::int32_t>(i), row, part_of(colour, 16), part_of(colour, 8),
                        part_of(colour, 0)});
    }
}

/// main() has ended, or the program has called exit().
void end_normally() {
    if (runtime.has_ended || runtime.is_asking) return;
    runtime.has_ended = true;
    if (progress().frames == 0) {
        find_direct_writes();
        if (runtime.canvas.width > 0 || progress().puts > 0) progress().frames = 1;
        runtime.is_first_frame = false;
        call_hook();
    }
    progress().moment = moment_ended;
}

/// Maps the shared memory, if the descriptor is that.
Recorded* find_memory() {
    struct stat about = {};
    if (fstat(recording_descriptor, &about) != 0) return nullptr;
    if (about.st_size < static_cast<off_t>(sizeof(Recorded))) return nullptr;
    void* place = mmap(nullptr, sizeof(Recorded), PROT_READ | PROT_WRITE, MAP_SHARED,
                       recording_descriptor, 0);
    if (place == MAP_FAILED) return nullptr;
    auto* memory = static_cast<Recorded*>(place);
    if (memory->task.magic != recording_magic) {
        munmap(place, sizeof(Recorded));
        return nullptr;
    }
    // The program must not cut the file short.
    close(recording_descriptor);
    return memory;
}

// Static objects without a priority are made after this.
[[gnu::constructor(101)]] void begin() {
    runtime.memory = find_memory();
    progress().moment = moment_started;
    crash::begin(progress(), find_direct_writes);
    std::atexit(end_normally);
}

} // namespace

Recorded* recorded() {
    return runtime.memory;
}

void capture_puts(std::vector<Put>* into) {
    std::vector<Put>* before = runtime.captured;
    runtime.captured = into;
    if (before == nullptr || into != nullptr) return;
    for (int row = 0; row < runtime.canvas.height; ++row)
        capture_row(*before, row);
}

bool is_capturing() {
    return runtime.captured != nullptr;
}

void set_part(Part part, std::uint64_t question) {
    progress().part = part;
    progress().question = question;
    progress().moment = moment_asked;
}

bool open_canvas(int width, int height) {
    if (width < 1 || height < 1 || width > longest_side || height > longest_side) return false;
    Canvas opened;
    opened.width = width;
    opened.height = height;
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    opened.pixels = static_cast<std::uint32_t*>(std::calloc(count, sizeof(std::uint32_t)));
    auto* known = static_cast<std::uint32_t*>(std::calloc(count, sizeof(std::uint32_t)));
    if (opened.pixels == nullptr || known == nullptr) return false;
    // Functions at exit are called before the static objects die that exist now: the hook needs
    // these. The memory of an earlier window stays, because the program may still point to it.
    if (runtime.canvas.width == 0) std::atexit(end_normally);
    runtime.canvas = opened;
    runtime.known = known;
    progress().moment = moment_window;
    if (!runtime.is_first_frame) return true;
    progress().width = width;
    progress().height = height;
    if (has_room_for_picture()) std::memset(runtime.memory->picture, 0, count * 3 * sizeof(float));
    return true;
}

const Canvas& canvas() {
    return runtime.canvas;
}

void use_dialect(Dialect dialect) {
    if (progress().dialect == dialect_none) progress().dialect = dialect;
}

void put(int x, int y, float red, float green, float blue) {
    if (runtime.captured != nullptr) {
        if (runtime.captured->size() < most_puts) {
            runtime.captured->push_back({x, y, red, green, blue});
        }
        return;
    }
    Progress& now = progress();
    now.moment = moment_put;
    const bool is_inside =
        x >= 0 && y >= 0 && x < runtime.canvas.width && y < runtime.canvas.height;
    const std::size_t pixel =
        is_inside ? static_cast<std::size_t>(y) * static_cast<std::size_t>(runtime.canvas.width) +
                        static_cast<std::size_t>(x)
                  : 0;
    if (runtime.is_first_frame) {
        find_erased();
        // A program may draw with several threads.
        const std::uint64_t index = __atomic_fetch_add(&now.puts, 1, __ATOMIC_RELAXED);
        if (runtime.memory != nullptr && index < most_puts) {
            runtime.memory->puts[index] = {x, y, red, green, blue};
        }
        if (is_inside) set_in_picture(pixel, red, green, blue);
    }
    if (!is_inside) {
        ++(runtime.is_first_frame ? now.outside : now.later_outside);
        return;
    }
    runtime.canvas.pixels[pixel] = packed_colour(red, green, blue);
    runtime.known[pixel] = runtime.canvas.pixels[pixel];
    runtime.last_put = pixel;
}

void clear(float red, float green, float blue) {
    if (runtime.captured != nullptr) return;
    if (runtime.is_first_frame) {
        begin_picture(red, green, blue);
        return;
    }
    const std::uint32_t colour = packed_colour(red, green, blue);
    for (std::size_t i = 0; i < pixel_count(); ++i) {
        runtime.canvas.pixels[i] = colour;
        runtime.known[i] = colour;
    }
}

void show() {
    if (runtime.is_asking || runtime.captured != nullptr || runtime.has_ended) return;
    const bool is_first = runtime.is_first_frame;
    find_direct_writes();
    runtime.is_first_frame = false;
    ++progress().frames;
    progress().moment = moment_shown;
    if (is_first) call_hook();
    if (progress().frames >= wanted_frames()) end_program();
    if (runtime.known != nullptr) {
        std::memcpy(runtime.known, runtime.canvas.pixels, pixel_count() * sizeof(std::uint32_t));
    }
    runtime.times_asked = 0;
    runtime.times_polled = 0;
    runtime.is_press_taken = false;
    runtime.clock += milliseconds_per_frame;
}

void ask_to_go_on() {
    if (++runtime.times_asked < 2) return;
    show();
    runtime.times_asked = 1;
}

void ask_for_events() {
    // Some programs ask in several places of a frame, so two times count only after drawing.
    ++runtime.times_polled;
    if (runtime.times_polled < 2) return;
    if (!has_drawn() && runtime.times_polled < polls_of_a_waiting_program) return;
    show();
    runtime.times_polled = 1;
}

void wait_for_events() {
    show();
}

int held_key() {
    return runtime.is_first_frame || runtime.memory == nullptr ? 0 : runtime.memory->task.key;
}

bool take_key_press() {
    if (held_key() == 0 || runtime.is_press_taken) return false;
    runtime.is_press_taken = true;
    return true;
}

std::uint32_t read_clock() {
    return ++runtime.clock;
}

void delay(std::uint32_t milliseconds) {
    runtime.clock += milliseconds < longest_delay ? milliseconds : longest_delay;
}

std::uint32_t packed_colour(float red, float green, float blue) {
    // NaN is black.
    const auto byte = [](float part) {
        const float scaled = 255.0f * part;
        return scaled > 0.0f ? static_cast<std::uint32_t>(scaled < 255.0f ? scaled : 255.0f) : 0u;
    };
    return 0xff000000u | byte(red) << 16 | byte(green) << 8 | byte(blue);
}

} // namespace rasterwalk_kit

// Called at the beginning of each of the program's functions if it was compiled to do so.
// NOLINTNEXTLINE(readability-identifier-naming): the compiler's name
extern "C" [[gnu::no_instrument_function]] void __cyg_profile_func_enter(void* function, void*) {
    using namespace rasterwalk_kit;
    if (!runtime.is_first_frame || runtime.is_asking || runtime.memory == nullptr) return;
    const std::uint64_t place = reinterpret_cast<std::uintptr_t>(function) - crash::watch.base;
    Calls* calls = runtime.memory->progress.calls;
    std::size_t slot = place / 16 % most_called;
    for (int tried = 0; tried < most_slots_tried; ++tried) {
        if (calls[slot].place == 0) calls[slot].place = place;
        if (calls[slot].place == place) {
            ++calls[slot].count;
            return;
        }
        slot = (slot + 1) % most_called;
    }
}

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" [[gnu::no_instrument_function]] void __cyg_profile_func_exit(void*, void*) {}
