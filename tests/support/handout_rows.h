#pragma once

namespace rasterwalk::test {

/// The rows of the triangle (10,5) (5,10) (15,15), as the lab's handout prints them.
inline constexpr const char* handout_rows = "Start: (10,5). End: (10,5).\n"
                                            "Start: (9,6). End: (10,6).\n"
                                            "Start: (8,7). End: (11,7).\n"
                                            "Start: (7,8). End: (11,8).\n"
                                            "Start: (6,9). End: (12,9).\n"
                                            "Start: (5,10). End: (12,10).\n"
                                            "Start: (7,11). End: (13,11).\n"
                                            "Start: (9,12). End: (13,12).\n"
                                            "Start: (11,13). End: (14,13).\n"
                                            "Start: (13,14). End: (14,14).\n"
                                            "Start: (15,15). End: (15,15).\n";

} // namespace rasterwalk::test
