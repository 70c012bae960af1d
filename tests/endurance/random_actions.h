#pragma once

#include <string>
#include <vector>

#include "tests/support/random.h"
#include "tests/ui/driver.h"

namespace rasterwalk::endurance {

/// What a restless student does to the window: mouse, keys, text, window sizes, lessons, scenes,
/// links and files, among them damaged ones. An action is determined by its number and the seed,
/// and by what is on the screen. Nothing is written outside the current folder, which must be the
/// one given, and no compiler is found.
class RandomActions {
  public:
    /// @param folder where the files to be dropped are made, and where views are saved
    RandomActions(Driver& driver, std::uint32_t seed, std::string folder);

    /// Does one action, and builds a frame of 100 ms after it. Returns what it was: "click
    /// tab.rows".
    std::string act(int number);

    /// The lab's room as it first opens, in a window of the usual size, so that measurements of
    /// memory can be compared.
    void come_to_rest();

  private:
    using Kind = std::string (RandomActions::*)();

    std::string click_widget();
    std::string click_anywhere();
    std::string drag();
    std::string press_key();
    std::string hold_key();
    std::string type_text();
    std::string turn_wheel();
    std::string hover();
    std::string change_size();
    std::string change_look();
    std::string run_action();
    std::string follow_any_link();
    std::string open_lesson_step();
    std::string open_scene();
    std::string drop_file();

    void frame(float seconds);
    void press_mouse(ImVec2 place);
    std::string some_widget();
    ImVec2 place_in(const std::string& widget);
    ImVec2 any_place();
    void play_some_modifiers();
    int some_key();
    std::string changed_file();
    void stay_in_folder();
    void give_up_long_work();

    template <class List>
    const auto& one_of(const List& list) {
        return list[static_cast<std::size_t>(
            random_.integer(0, static_cast<int>(std::size(list)) - 1))];
    }

    Driver& driver_;
    Ui& ui_;
    std::uint32_t seed_;
    std::string folder_;
    test::Random random_{1};
    std::vector<std::string> links_, scenes_, dropped_;
    int diagnosing_ = 0; ///< actions since a picture's diagnosis began
};

} // namespace rasterwalk::endurance
