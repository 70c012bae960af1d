#include "figures.h"

#include <cstdio>
#include <sstream>

#include "base/files.h"

namespace rasterwalk {

KnownFigures read_figures(const std::string& path) {
    KnownFigures figures;
    if (path.empty()) return figures;
    std::istringstream lines(read_file(path));
    std::string line;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string name;
        double milliseconds = 0.0;
        if (words >> name >> milliseconds) figures[name] = milliseconds;
    }
    return figures;
}

void print_figure(const std::string& name, double milliseconds, const KnownFigures& others) {
    std::printf("%-24s %10.3f ms", name.c_str(), milliseconds);
    if (const auto other = others.find(name); other != others.end() && other->second > 0.0)
        std::printf("   %6.3f of %10.3f ms", milliseconds / other->second, other->second);
    std::printf("\n");
    std::fflush(stdout);
}

} // namespace rasterwalk
