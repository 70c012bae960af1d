#include "ui/hosts/made_times.h"

#include <algorithm>
#include <sstream>

#include "base/error.h"
#include "base/files.h"
#include "base/quoted.h"
#include "engines/measure.h"

namespace rasterwalk {

namespace {

std::size_t place_of_rung(const std::string& name, const std::string& path) {
    for (std::size_t place = 0; place < rung_count(); ++place) {
        if (rung_at(place).name == name) return place;
    }
    throw InputError(path + ": there is no rung " + in_quotes(name) + ".");
}

} // namespace

MadeTimes read_made_times(const std::string& path) {
    MadeTimes made;
    made.times.rungs.resize(rung_count());
    made.times.share = 1.0f;
    std::istringstream lines(read_file(path));
    std::getline(lines, made.processor);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name;
        if (!(words >> name)) continue;
        RungTime& time = made.times.rungs[place_of_rung(name, path)];
        words >> time.from_previous.different;
        time.from_previous.pixels = 1; // it was compared
        for (double milliseconds = 0.0; words >> milliseconds;)
            time.milliseconds.push_back(milliseconds);
        if (time.milliseconds.empty()) throw InputError(path + ": no times of " + name + ".");
        time.median = median(time.milliseconds);
    }
    if (!made.times.has_all()) throw InputError(path + ": not all rungs have times.");
    const auto fewest = std::min_element(
        made.times.rungs.begin(), made.times.rungs.end(),
        [](const auto& a, const auto& b) { return a.milliseconds.size() < b.milliseconds.size(); });
    made.times.rounds = static_cast<int>(fewest->milliseconds.size());
    return made;
}

} // namespace rasterwalk
