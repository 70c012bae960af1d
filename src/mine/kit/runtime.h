#pragma once

// The runtime is linked to the student's program. It keeps the picture that the program draws, has
// no window, and writes down what happens in the memory that Rasterwalk shares with it. It begins
// before the program's static objects are made. Without that memory the program draws one frame,
// and nothing is written down.

#include <cstdint>
#include <vector>

#include "recording.h"

namespace rasterwalk_kit {

// For the driver, which asks the program's functions.

/// The memory shared with Rasterwalk; null: there is none.
Recorded* recorded();

/// Called once, after the first frame, or when main() ends without one. What it makes the program
/// show is not a frame. Null: nothing is called.
extern void (*after_first_frame)();

/// Pixels that the program puts from now on go there, also those outside the picture, and the
/// picture stays as it is. At most most_puts are kept. Null ends that: pixels written into the
/// surface without PutPixelSDL are then added, row by row, and the surface is as before.
void capture_puts(std::vector<Put>* into);

/// Do pixels go there now?
bool is_capturing();

/// Records which question is asked next: after a crash that is where the program was. The driver
/// itself sets the bit of Progress::answered when a part is over.
void set_part(Part part, std::uint64_t question);

// For the stand-in headers.

/// What the program sees of its picture.
struct Canvas {
    int width = 0, height = 0;       ///< pixels; 0: no window is open
    std::uint32_t* pixels = nullptr; ///< 0xAARRGGBB, row by row from the top
};

/// Opens the window, or opens it again in another size. False: no window has such a size.
bool open_canvas(int width, int height);

/// The picture of the window.
const Canvas& canvas();

/// Which helper the program is written for: the first one that it uses counts.
void use_dialect(Dialect dialect);

/// Puts a pixel into the picture. Outside it only counts.
void put(int x, int y, float red, float green, float blue);

/// Gives the whole picture one colour: what was put before is forgotten.
void clear(float red, float green, float blue);

/// Ends a frame. Does not return from the last one that is wanted.
void show();

/// The program asks whether it shall go on. The second time without a frame in between ends one.
void ask_to_go_on();

/// The program has read all events there are. If it never shows a frame, this is how it ends.
void ask_for_events();

/// The program waits until something happens: the frame is over.
void wait_for_events();

/// The key that is held in this frame, as an SDL 2 keycode; 0: none.
int held_key();

/// Has that key been pressed, and not been asked for in this frame yet?
bool take_key_press();

/// Milliseconds of a clock that always runs the same: 20 a frame, and 1 each time that it is read.
std::uint32_t read_clock();

/// Puts that clock forward instead of waiting.
void delay(std::uint32_t milliseconds);

/// A colour of 0xAARRGGBB: 1 is full, what is more is cut off, and alpha is 255.
std::uint32_t packed_colour(float red, float green, float blue);

} // namespace rasterwalk_kit
