#pragma once

#include <map>
#include <string>
#include <vector>

#include "questionnaires/model/answer.h"
#include "study/session/study.h"

namespace tests {

/// The call of the program that simulates @p participants, and says what it has saved.
std::vector<std::string> simulation(const std::string& folder, int participants);

/// Of "saved P001 felt/kalman presence" and "saved P001 felt done": whether it is the first kind.
bool isAnswer(const std::string& line);

/// The acknowledgements in all that a program printed.
std::vector<std::string> acknowledgedIn(const std::string& out);

/// What is kept, named as the program acknowledges it, and what was answered.
std::map<std::string, questionnaires::Response> answersIn(study::Study& study);

/// Answers of @p acknowledged that are not kept, and whatever does not verify; empty where all is
/// well.
std::string whatIsLost(const std::string& folder, const std::vector<std::string>& acknowledged);

/// How many answers are kept that nobody was told about: one at most, however the program ended.
std::size_t keptBeyond(const std::string& folder, const std::vector<std::string>& acknowledged);

}  // namespace tests
