#include "tests/support/prediction_checks.h"

namespace rasterwalk::test {

namespace {

std::set<std::string>& asked() {
    static std::set<std::string> names;
    return names;
}

std::string name_of(const std::string& lesson, const std::string& prediction) {
    return std::string(lesson).append("/").append(prediction);
}

} // namespace

std::set<std::string>& checked_predictions() {
    static std::set<std::string> names;
    return names;
}

CheckedPredictions::CheckedPredictions(const std::string& lesson,
                                       std::initializer_list<const char*> ids) {
    for (const char* id : ids)
        checked_predictions().insert(name_of(lesson, id));
}

void record_question(const std::string& lesson, const std::string& prediction) {
    asked().insert(name_of(lesson, prediction));
}

void forget_questions() {
    asked().clear();
}

void require_questions(const std::string& lesson, std::initializer_list<const char*> ids) {
    std::set<std::string> wanted;
    for (const char* id : ids)
        wanted.insert(name_of(lesson, id));
    CHECK(asked() == wanted);
}

} // namespace rasterwalk::test
