#pragma once

#include <map>
#include <string>
#include <vector>

#include "questionnaires/model/answer.h"
#include "study/session/study.h"

namespace tests {

/// The command that simulates @p participants and prints what it has saved.
std::vector<std::string> simulation(const std::string& folder, int participants);

/// Whether a line is about an answer, "saved P001 felt/kalman presence", and not about a step,
/// "saved P001 felt done".
bool isAnswer(const std::string& line);

/// The acknowledgements in a program's output.
std::vector<std::string> acknowledgedIn(const std::string& out);

/// The stored answers, by the names of their acknowledgements.
std::map<std::string, questionnaires::Response> answersIn(study::Study& study);

/// The answers in @p acknowledged that are not stored, and the problems that verification finds;
/// empty if there are none.
std::string whatIsLost(const std::string& folder, const std::vector<std::string>& acknowledged);

/// The number of stored answers that were not acknowledged: at most one, however the program ended.
std::size_t keptBeyond(const std::string& folder, const std::vector<std::string>& acknowledged);

}  // namespace tests
