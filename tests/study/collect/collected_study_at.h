#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "study/collect/exchange/pull.h"
#include "study/collect/exchange/push.h"
#include "study/collect/server/connection.h"
#include "study/collect/server/private_server.h"
#include "study/session/session.h"
#include "study/session/study.h"
#include "tests/study/made_study.h"
#include "tests/support/scratch_folder.h"

namespace tests {

/// A study on a private PostgreSQL server, with a database of its own for each test, and stations
/// with folders of their own. Skipped where PostgreSQL is not installed.
class CollectTest : public testing::Test {
 protected:
  void SetUp() override;

  /// As the owner of the server.
  study::collect::Connection admin() const;
  /// As a role. @param role  "station_oslo"
  study::collect::Connection as(const std::string& role) const;
  /// One for all tests of a process. It is stopped, by its id, when that ends.
  static study::collect::PrivateServer& postgres();

  const std::string& database() const noexcept { return database_; }

  /// Enrols a station, and makes its folder.
  void addStation(const std::string& site, const std::string& label = {});
  std::string folderOf(const std::string& label) const { return scratch_ / ("study-" + label); }
  /// The station's own account, as long as it exists.
  OwnStation accountOf(const std::string& label) const {
    return OwnStation(scratch_ / ("account-" + label));
  }

  /// Sessions of simulated participants, with traces.
  void simulate(const std::string& label, int participants, std::uint64_t seed = 7);
  /// Feels one trial after another, with cuts and samples, and answers everything.
  /// @param trials  as many at most; then it stops before the next
  static void feelAll(study::Study& study, study::Session& session, int trials = 100);
  /// A live session in which feelAll() was done. @return  the participant's code
  std::string runSession(const std::string& label, const std::string& code = {});

  study::collect::PushResult push(const std::string& label) const;
  /// … over another way to the server. @param server  as libpq reads it
  study::collect::PushResult pushOver(
      const std::string& label,
      const std::string& server,
      std::chrono::milliseconds patience = std::chrono::minutes(1)) const;
  /// … from another folder of the station.
  study::collect::PushResult pushFrom(const std::string& folder, const std::string& label) const;

  /// Pulls the study into folderOfPull(), as an analyst.
  study::collect::PullResult pull(const std::string& name = "union") const;
  std::string folderOfPull(const std::string& name = "union") const { return scratch_ / name; }

  /// The SHA-256 of every session's facts, and the samples of every trace without their seal, by
  /// participant and session number: of studies together.
  std::map<std::string, std::string> contentOf(const std::vector<std::string>& folders) const;
  /// The same of what the server has.
  std::map<std::string, std::string> contentOfServer() const;
  std::vector<std::string> incidents() const;

  ScratchFolder scratch_;
  mutable study::SimulatedClock clock_;

 private:
  study::storage::SealingKey keyOf(const std::string& label) const;

  std::string database_;
};

}  // namespace tests
