#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/model/clock.h"
#include "study/session/session.h"
#include "study/session/study.h"
#include "tests/study/known_secret.h"
#include "tests/support/scratch_folder.h"

namespace tests {

/// A protocol of protocols/library/ by name.
protocols::LoadedProtocol libraryProtocol(const std::string& name);

/// The protocol of a JSON text; the files that it names are in @p files.
/// @throws std::runtime_error  with all problems in words, if it has errors.
protocols::LoadedProtocol protocolFrom(
    const std::string& json, const std::vector<protocols::SourceFile>& files = {});

/// @p protocol with every blank of its texts filled in, as a live session needs it.
protocols::LoadedProtocol filledIn(const protocols::LoadedProtocol& protocol);

/// Options of a short protocol.
struct ShortProtocol {
  std::string order = "balancedLatinSquare";
  std::string labels = "random";
  std::vector<std::string> conditions{"interpolation", "finite-elements", "kalman"};
  std::string questionnaire = "realism-cuts";  ///< after each condition; empty: none
  std::string form;                            ///< an instrument after the consent; empty: none
  std::string files;                           ///< instrument files: "\"everything.json\""
  bool hasPreference = true;
  bool offersAgain = false;  ///< before the preference
  int minimumCuts = 1;
};

/// Consent, an optional form, a block of conditions on a punch, an optional preference, a
/// debriefing; two cohorts, `surgeons` and `students`; in English, German and Norwegian.
std::string shortProtocol(const ShortProtocol& options = {});

/// A station's own folder, as long as it exists: no test meets what another one noted.
class OwnStation {
 public:
  explicit OwnStation(const std::string& folder);
  ~OwnStation();
  OwnStation(const OwnStation&) = delete;
  OwnStation& operator=(const OwnStation&) = delete;

 private:
  std::optional<std::string> before_;
};

/// Removes what the station noted, and leaves its keys. For tests that go on with copies
/// of one study, each by itself: a station takes them for branches.
void forgetWhatWasSigned();

/// A study in its own folder and of its own station, with a clock that the test advances.
class MadeStudy {
 public:
  explicit MadeStudy(
      const protocols::LoadedProtocol& protocol = protocolFrom(shortProtocol()),
      std::uint64_t seed = 1,
      const study::storage::BlindingSecret& secret = knownSecret());

  study::Study& operator*() { return *study_; }
  study::Study* operator->() { return &*study_; }
  std::string folder() const { return scratch_ / "study"; }
  std::string file(const std::string& name) const { return folder() + "/" + name; }
  const ScratchFolder& scratch() const noexcept { return scratch_; }

  /// Closes the study as at the end of the program; reopen() opens it again.
  void close() { study_.reset(); }
  void reopen();

  study::SimulatedClock clock;

 private:
  ScratchFolder scratch_;
  OwnStation station_{scratch_ / "station"};
  std::optional<study::Study> study_;
};

}  // namespace tests
