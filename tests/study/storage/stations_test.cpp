// Several stations write to one study at the same time.
#include <sys/wait.h>
#include <unistd.h>

#include <iostream>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "study/session/verification.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace stations_test {

constexpr int kStations = 3;
constexpr int kSessions = 12;  // for each of them

/// Starts a process that runs sessions one after another; it ends with 0 if all succeeded.
pid_t startStation(const std::string& folder) {
  const pid_t id = fork();
  if (id != 0) return id;
  try {
    SimulatedClock clock;
    auto study = Study::open(folder, clock);
    for (int i = 0; i < kSessions; ++i) {
      auto session = Session::enrol(study, {.cohort = i % 2 == 0 ? "surgeons" : "students"});
      tests::walkToTheEnd(session);
    }
    _exit(0);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    _exit(1);
  }
}

TEST(Stations, ShareAStudyWithoutSharingPlacesOrCodes) {
  tests::MadeStudy study;
  study.close();  // SQLite connections must not be used across fork()
  std::vector<pid_t> stations;
  for (int i = 0; i < kStations; ++i) stations.push_back(startStation(study.folder()));
  for (const pid_t id : stations) {
    int status = -1;
    EXPECT_EQ(waitpid(id, &status, 0), id);
    EXPECT_EQ(status, 0);
  }
  study.reopen();
  const auto rows = study->sessions().all();
  std::set<std::string> names;
  std::set<std::tuple<std::string, std::int64_t>> places;
  for (const auto& row : rows) {
    EXPECT_EQ(row.state, SessionState::Completed);
    names.insert(row.participant);
    places.emplace(row.cohort, row.slot);
  }
  const std::size_t all = std::size_t{kStations} * kSessions;
  EXPECT_EQ(rows.size(), all);
  EXPECT_EQ(names.size(), all);
  EXPECT_EQ(places.size(), all);
  EXPECT_LT(
      std::get<1>(*places.rbegin()), static_cast<std::int64_t>(all) / 2);  // no place is left out
  EXPECT_TRUE(verify(*study).isSound());
}

}  // namespace stations_test
}  // namespace study
