#include "tests/study/app/simulation.h"

#include <sstream>

#include "study/session/verification.h"
#include "study/storage/records.h"
#include "study/storage/statement.h"
#include "tests/support/programs.h"

namespace tests {

std::vector<std::string> simulation(const std::string& folder, int participants) {
  return {
      tests::releaseProgram(),
      "study",
      "simulate",
      folder,
      "--participants",
      std::to_string(participants),
      "--verbose"};
}

bool isAnswer(const std::string& line) {
  return line.find('/') != std::string::npos;
}

std::vector<std::string> acknowledgedIn(const std::string& out) {
  std::vector<std::string> lines;
  std::istringstream stream(out);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("saved ", 0) == 0) lines.push_back(line);
  }
  return lines;
}

std::map<std::string, questionnaires::Response> answersIn(study::Study& study) {
  std::map<study::SessionId, std::string> names;
  for (const auto& row : study.sessions().all()) names[row.id] = row.participant;
  std::map<std::string, questionnaires::Response> answers;
  for (const auto& record : study::storage::Records(study.database()).answers()) {
    const auto& step = record.step;
    answers.emplace(
        "saved " + names[step.visit.session] + " " + step.phase + "/" + step.condition + " " +
            record.answer.item,
        record.answer.response);
  }
  // Answers that name a person are in a separate database.
  study::storage::Statement named(
      study.identities().database(),
      "SELECT participant, item, text FROM identifying_answer WHERE step = 0");
  while (named.step()) {
    answers.emplace("saved " + named.text(0) + " consent/ " + named.text(1), named.text(2));
  }
  return answers;
}

std::string whatIsLost(const std::string& folder, const std::vector<std::string>& acknowledged) {
  study::SimulatedClock clock;
  auto study = study::Study::open(folder, clock);
  const auto kept = answersIn(study);
  std::string wrong;
  for (const auto& line : acknowledged) {
    if (isAnswer(line) && kept.count(line) == 0) wrong += "lost: " + line + "\n";
  }
  for (const auto& check : study::verify(study).checks) {
    for (const auto& problem : check.problems) wrong += check.what + ": " + problem + "\n";
  }
  return wrong;
}

std::size_t keptBeyond(const std::string& folder, const std::vector<std::string>& acknowledged) {
  study::SimulatedClock clock;
  auto study = study::Study::open(folder, clock);
  auto kept = answersIn(study);
  for (const auto& line : acknowledged) kept.erase(line);
  return kept.size();
}

}  // namespace tests
