// What `palpate bench stats` measures: from a study's database to its table, in a process that does
// nothing else.
#include "study/bench/bench_stats.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <fmt/format.h>

#include "study/bench/bench_stats_study.h"
#include "study/bench/bench_workers.h"
#include "study/results/pooled_answers.h"
#include "study/storage/answer_repository.h"
#include "study/storage/statement.h"

namespace study::app {
namespace {

namespace fs = std::filesystem;

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  }

 private:
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

/// A folder that is gone when this is.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::string& inside)
      : path_(
            (inside.empty() ? fs::temp_directory_path() : fs::path(inside)) /
            "palpate-bench-XXXXXX") {
    auto name = path_.string();
    if (mkdtemp(name.data()) == nullptr) {
      throw storage::StorageError(
          path_.parent_path().string() +
          " takes no folder for the measurement. Choose another one with --disk.");
    }
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const fs::path& path() const noexcept { return path_; }

 private:
  fs::path path_;
};

/// The most memory that this process has held since it began [MB].
double mostMemory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    constexpr std::string_view kMost = "VmHWM:";
    if (line.starts_with(kMost)) return std::stod(line.substr(kMost.size())) * 1024.0 / 1e6;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<TableRow> tableOf(Study& study, const PooledAnswers& pooled) {
  const auto& protocol = study.protocol().protocol;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<TableRow> rows;
  for (std::size_t i = 0; i < protocol.analysis.families.size(); ++i) {
    for (std::size_t j = 0; j < protocol.cohorts.size(); ++j) {
      const auto compared = comparePooled(protocol.analysis.families[i], pooled.of(i, j));
      for (const auto& row : compared.rows) {
        const auto& w = row.welch;
        rows.push_back(
            {protocol.cohorts[j].id,
             row.group1,
             row.group2,
             w.mean1.value_or(kNone),
             w.mean2.value_or(kNone),
             w.variance1.value_or(kNone),
             w.variance2.value_or(kNone),
             w.t.value_or(kNone),
             w.p.value_or(kNone)});
      }
    }
  }
  return rows;
}

std::string asLine(const TableRow& row) {
  return fmt::format(
      "row {} {} {} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}",
      row.cohort,
      row.first,
      row.second,
      row.mean1,
      row.mean2,
      row.variance1,
      row.variance2,
      row.t,
      row.p);
}

void measureTable(const std::string& folder, int repetitions) {
  SystemClock clock;
  fmt::print("before {}\n", mostMemory());
  std::vector<TableRow> rows;
  for (int i = 0; i < repetitions; ++i) {
    const Stopwatch watch;
    const auto busy = std::clock();
    auto study = Study::open(folder, clock, storage::Database::Access::ReadOnly);
    const PooledAnswers pooled(study, RunMode::Simulated);
    rows = tableOf(study, pooled);
    fmt::print("seconds {}\n", watch.seconds());
    fmt::print("processor {}\n", static_cast<double>(std::clock() - busy) / CLOCKS_PER_SEC);
  }
  fmt::print("memory {}\n", mostMemory());
  for (const auto& row : rows) fmt::print("{}\n", asLine(row));
}

/// Some answer or other, changed as a session changes one: a row and an event, in one transaction.
void changeAnAnswer(Study& study, std::int64_t which) {
  storage::Statement select(
      study.database(), "SELECT session_id, step, attempt, item FROM answer WHERE rowid = ?");
  select.bind(1, which);
  select.step();
  const VisitKey visit{
      SessionId{select.number(0)},
      static_cast<int>(select.number(1)),
      static_cast<int>(select.number(2))};
  storage::AnswerRepository answers(study.database());
  auto answer = answers.find(visit, select.text(3)).value();
  answer.response = std::get<std::int64_t>(answer.response) % 5 + 1;
  const auto now = study.clock().now();
  study.transact([&] {
    answers.put(visit, answer, asUtc(now.wall));
    study.events().append(
        {.visit = visit,
         .when = now,
         .actor = storage::Actor::Participant,
         .kind = "answered",
         .values = storage::valuesOf(answer)});
  });
}

void measureEdits(const std::string& folder, int repetitions) {
  SystemClock clock;
  auto study = Study::open(folder, clock);
  PooledAnswers pooled(study, RunMode::Simulated);
  storage::Statement count(study.database(), "SELECT max(rowid) FROM answer");
  count.step();
  const auto answers = count.number(0);
  count.reset();
  std::vector<TableRow> rows;
  constexpr std::int64_t kStride = 7919;  // a prime: all over the place
  for (int i = 0; i < repetitions; ++i) {
    const Stopwatch writing;
    changeAnAnswer(study, 1 + i * kStride % answers);
    fmt::print("writing {}\n", writing.seconds());
    const Stopwatch watch;
    pooled.refresh();
    rows = tableOf(study, pooled);
    fmt::print("edit {}\n", watch.seconds());
  }
  const auto counted = tableOf(study, PooledAnswers(study, RunMode::Simulated));
  fmt::print("same {}\n", largestDifference(rows, counted) == 0.0 ? 1 : 0);
}

void readLine(const std::string& line, StatsMeasurement& measured) {
  std::istringstream words(line);
  std::string what;
  words >> what;
  if (what == "row") {
    measured.ours.rows.push_back(tableRowIn(words));
    return;
  }
  double number = 0.0;
  words >> number;
  if (what == "seconds") measured.ours.seconds.push_back(number);
  if (what == "processor") measured.processor.push_back(number);
  if (what == "before") measured.memoryBefore = number;
  if (what == "memory") measured.memory = number;
  if (what == "edit") measured.edits.push_back(number);
  if (what == "writing") measured.writing.push_back(number);
  if (what == "same") measured.isSameAfterEdits = number == 1.0;
}

void runPart(
    const fs::path& folder, const std::string& part, int repetitions, StatsMeasurement& measured) {
  std::fprintf(stderr, "%s, %d times\n", part.c_str(), repetitions);
  runAnotherOfUs(
      {"bench",
       "stats",
       "--worker",
       part,
       "--study",
       folder.string(),
       "--repetitions",
       std::to_string(repetitions)},
      [&](const std::string& line) { readLine(line, measured); });
}

bool isOfTheSame(const TableRow& a, const TableRow& b) {
  return a.cohort == b.cohort && ((a.first == b.first && a.second == b.second) ||
                                  (a.first == b.second && a.second == b.first));
}

double differenceOf(const TableRow& a, TableRow b) {
  if (a.first != b.first) {
    std::swap(b.mean1, b.mean2);
    std::swap(b.variance1, b.variance2);
    b.t = -b.t;
  }
  const double ofMeans = std::max(std::abs(a.mean1 - b.mean1), std::abs(a.mean2 - b.mean2));
  const double ofVariances =
      std::max(std::abs(a.variance1 - b.variance1), std::abs(a.variance2 - b.variance2));
  const double ofT = a.t == b.t ? 0.0 : std::abs(a.t - b.t) / std::abs(a.t);
  return std::max({ofMeans, ofVariances, ofT});
}

}  // namespace

TableRow tableRowIn(std::istream& words) {
  TableRow row;
  words >> row.cohort >> row.first >> row.second;
  for (double* number : {&row.mean1, &row.mean2, &row.variance1, &row.variance2, &row.t, &row.p}) {
    std::string word;
    words >> word;
    *number = std::strtod(word.c_str(), nullptr);  // also "nan"
  }
  return row;
}

double quantileOf(std::vector<double> values, double q) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const auto place = static_cast<std::size_t>(q * static_cast<double>(values.size()));
  return values[std::min(place, values.size() - 1)];
}

double largestDifference(const std::vector<TableRow>& ours, const std::vector<TableRow>& theirs) {
  constexpr double kNotTheSame = std::numeric_limits<double>::infinity();
  if (ours.empty() || ours.size() != theirs.size()) return kNotTheSame;
  double largest = 0.0;
  for (const auto& row : ours) {
    const auto other = std::find_if(theirs.begin(), theirs.end(), [&](const auto& candidate) {
      return isOfTheSame(row, candidate);
    });
    if (other == theirs.end()) return kNotTheSame;
    largest = std::max(largest, differenceOf(row, *other));
  }
  return largest;
}

int measureStatsPart(const std::string& folder, const std::string& part, int repetitions) {
  part == "table" ? measureTable(folder, repetitions) : measureEdits(folder, repetitions);
  return 0;
}

StatsMeasurement measureStats(const StatsBenchOptions& options) {
  const TemporaryFolder folder(options.disk);
  StatsMeasurement measured{.answers = options.answers};
  measured.ours.way = "palpate, from the database";
  std::fprintf(
      stderr,
      "making a synthetic study of %lld answers\n",
      static_cast<long long>(options.answers));
  const Stopwatch watch;
  const auto study = makeSyntheticStudy(folder.path(), options.answers, options.withPeers);
  measured.making = watch.seconds();
  measured.sessions = study.sessions;
  const auto database = study.folder / "study.db";
  measured.databaseSize = static_cast<double>(fs::file_size(database)) / 1e6;
  runPart(study.folder, "table", options.repetitions, measured);
  if (options.withPeers) {
    constexpr int kMostOfPeers = 5;
    measured.peers = runPeers(
        study.answers.string(),
        study.keys.string(),
        database.string(),
        std::min(options.repetitions, kMostOfPeers));
  }
  runPart(study.folder, "edits", options.edits, measured);
  return measured;
}

}  // namespace study::app
