#pragma once

// The student's own program: checked on another thread, and again whenever it is saved.

#include <string>

namespace rasterwalk {

struct Ui;

/// Compiles and runs the program of a .cpp file or of a folder, under guard, and opens the tab that
/// shows what was found. From then on its files are watched. Only the student's own action may call
/// this: no view, lesson or link starts a program.
void check_my_program(Ui& ui, std::string path);

/// The same for the program that was last checked; does nothing if there is none.
void check_my_program_again(Ui& ui);

/// Takes over what is known of the program so far, and begins again when one of its files has
/// changed. To be called once a frame.
void poll_program_check(Ui& ui);

/// Stops checking. What was found so far stays, and the files are still watched.
void stop_program_check(Ui& ui);

/// Compares the program as run B with ours: walks through both. Each check after that replaces B.
/// A notice says so if that cannot be done.
/// @param to_parting stands where the orders of the pixels part; otherwise at the end
void compare_my_program(Ui& ui, bool to_parting);

/// Is a program being checked?
bool is_checking_program(const Ui& ui);

/// Does the program not compile, perhaps because a file is missing? Then the next frame should come
/// soon enough to notice a new one.
bool may_miss_file(const Ui& ui);

/// Has a file of the program changed since it was last checked?
bool program_was_edited(Ui& ui);

/// Waits until the check is done and takes over its result: for pictures without a window, and
/// tests.
void finish_program_check(Ui& ui);

} // namespace rasterwalk
