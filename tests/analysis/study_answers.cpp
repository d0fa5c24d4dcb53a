#include "tests/analysis/study_answers.h"

#include "analysis/data/csv_table.h"
#include "tests/analysis/golden_file.h"

namespace tests {

StudyAnswers studyAnswers(const std::string& cohort) {
  const auto table = statsTable("study/study_answers.csv");
  const auto labels = [&](const char* column) {
    std::vector<std::string> cells;
    for (const auto& row : table.rows) {
      if (row.cells[table.columnIndex("cohort")] != cohort) continue;
      cells.push_back(row.cells[table.columnIndex(column)]);
    }
    return cells;
  };
  StudyAnswers answers;
  for (const auto& score : labels("score")) {
    answers.scores.push_back(base::decimalNumber(score).value());
  }
  const std::vector<std::string> methods{"interpolation", "fem", "kalman"};
  answers.participant = analysis::factorOf("participant", labels("participant"));
  answers.method = analysis::factorOf("method", labels("method"), methods);
  answers.round = analysis::factorOf("round", labels("round"));
  return answers;
}

}  // namespace tests
