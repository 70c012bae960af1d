#include "scene/obj_report.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/faults.h"
#include "base/limits.h"
#include "base/numbers.h"
#include "base/quoted.h"

namespace rasterwalk {

namespace {

constexpr std::size_t longest_kind = 24;
constexpr std::string_view further_kinds = "others";

/// Faults that are neither in the list nor counted with one in it.
std::int64_t faults_after(const ObjReport& report, std::size_t first) {
    std::int64_t left = report.counts.faults;
    for (std::size_t i = 0; i < first; ++i)
        left -= report.faults[i].count;
    return left;
}

} // namespace

bool ObjReporter::has_room() const {
    return report_.faults.size() < static_cast<std::size_t>(most_faults);
}

void ObjReporter::keep(std::string_view path, int line, std::string sentence) {
    report_.faults.push_back({visible_line(path), line, std::move(sentence)});
}

void ObjReporter::skip(std::string_view path, int line, std::string_view statement,
                       std::string_view why) {
    statement = statement.substr(0, longest_kind);
    std::vector<ObjSkipped>& skipped = report_.skipped;
    const auto known = kinds_.find(statement);
    if (known != kinds_.end()) {
        ++skipped[known->second].count;
    } else if (kinds_.size() < most_skipped_kinds) {
        kinds_.emplace(statement, skipped.size());
        skipped.push_back({visible_line(statement), std::string(why), visible_line(path), line, 1});
    } else if (skipped.size() == most_skipped_kinds) {
        skipped.push_back(
            {std::string(further_kinds), "of too many kinds to list", visible_line(path), line, 1});
    } else {
        ++skipped.back().count;
    }
}

void ObjReporter::note(std::string_view path, int line, std::string sentence) {
    if (report_.notes.size() >= static_cast<std::size_t>(most_faults)) return;
    report_.notes.push_back({visible_line(path), line, std::move(sentence)});
}

std::string more_like_it(const ObjFault& fault) {
    const std::int64_t more = fault.count - 1;
    if (more <= 0) return "";
    return fmt::format(" There {} {} more like it.", more == 1 ? "is" : "are", more);
}

std::string fault_line(const ObjFault& fault) {
    return fmt::format("{}:{}: {}{}", fault.path, fault.line, fault.sentence, more_like_it(fault));
}

std::vector<std::string> fault_lines(const ObjReport& report) {
    std::vector<std::string> lines;
    for (const ObjFault& fault : report.faults)
        lines.push_back(fault_line(fault));
    const std::int64_t left = faults_after(report, report.faults.size());
    if (left > 0) lines.push_back(counted(left, "more fault", "more faults") + " after these.");
    return lines;
}

std::vector<std::string> remark_lines(const ObjReport& report) {
    std::vector<std::string> lines;
    for (const ObjFault& note : report.notes)
        lines.push_back(fault_line(note));
    return lines;
}

std::vector<std::string> skipped_lines(const ObjReport& report) {
    std::vector<std::string> lines;
    for (const ObjSkipped& skipped : report.skipped) {
        lines.push_back(fmt::format("{}:{}: {} '{}' {} skipped: {}.", skipped.path, skipped.line,
                                    counted(skipped.count, "statement", "statements"),
                                    skipped.statement, skipped.count == 1 ? "is" : "are",
                                    skipped.why));
    }
    return lines;
}

std::string fault_notice(const ObjReport& report) {
    constexpr std::size_t most_shown = 3;
    std::string notice;
    const auto add = [&](const std::string& sentence) {
        notice.append(notice.empty() ? "" : " ").append(sentence);
    };
    const std::size_t shown = std::min(report.faults.size(), most_shown);
    for (std::size_t i = 0; i < shown; ++i)
        add(fault_line(report.faults[i]));
    const std::int64_t more = faults_after(report, shown);
    if (more > 0) add(counted(more, "more fault", "more faults") + " after that.");
    return notice;
}

} // namespace rasterwalk
