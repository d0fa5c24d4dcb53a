#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "questionnaires/json/problem.h"
#include "study/model/user_error.h"
#include "study/results/results.h"
#include "study/session/verification.h"
#include "study/storage/records.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"
#include "tests/support/scratch_folder.h"

// Fuzzes the pages of a study's three files: whatever bytes are changed, the study is read or
// refused in words. Four bytes of input are a file (2 bits), a place in it (22 bits), and the byte
// that is written there.

namespace {

namespace fs = std::filesystem;
using study::storage::StorageError;

constexpr std::array<const char*, 3> kFiles{"study.db", "traces.db", "identity.db"};

/// A study with sessions, answers of all types, trials with traces, votes, names, an erasure's
/// place, a note.
class Walked {
 public:
  Walked() {
    for (const bool isWhole : {true, false}) {
      auto session = study::Session::enrol(*study_, {.cohort = "surgeons"});
      session.note("what an operator typed");
      tests::walkTo(session, study::StepKind::Form);
      tests::answerStep(session, true);
      tests::walkTo(session, study::StepKind::Trial);
      session.beginTrial();
      const std::size_t samples = isWhole ? 500 : 50;
      const auto ticks = static_cast<std::int64_t>(samples);
      study_->traces().add(session.visit(), 0, std::vector<study::storage::TraceSample>(samples));
      session.abortTrial(
          {.ending = study::TrialEnding::Stopped, .ticks = ticks, .traceSamples = ticks});
      session.repeatStep("another attempt");
      if (isWhole) tests::walkToTheEnd(session);
    }
    study_.close();
    fs::remove(study_.file("ballast"));
    for (const auto* name : kFiles) intact_.push_back(tests::contentOf(study_.file(name)));
  }

  /// Puts the files there with the bytes of @p data changed.
  std::string folderWith(const std::uint8_t* data, std::size_t count) const {
    auto files = intact_;
    for (std::size_t i = 0; i + 4 <= count; i += 4) {
      auto& bytes = files[(data[i] >> 6U) % kFiles.size()];
      const std::size_t place = 65536U * (data[i] & 63U) + 256U * data[i + 1] + data[i + 2];
      bytes[place % bytes.size()] = static_cast<char>(data[i + 3]);
    }
    fs::remove_all(study_.folder());
    fs::create_directory(study_.folder());
    for (std::size_t i = 0; i < kFiles.size(); ++i) {
      std::ofstream(study_.file(kFiles[i]), std::ios::binary) << files[i];
    }
    return study_.folder();
  }

 private:
  tests::MadeStudy study_{tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}})};
  std::vector<std::string> intact_;
};

/// Runs @p action; what it refuses, it refuses in words.
template <typename Action>
void orWords(const Action& action) {
  const auto require = [](const std::exception& error) {
    if (std::string(error.what()).empty()) std::abort();
  };
  try {
    action();
  } catch (const StorageError& error) {
    require(error);
  } catch (const study::UserError& error) {
    require(error);
  } catch (const base::UserError& error) {
    require(error);
  }
}

void readAll(study::Study& study) {
  orWords([&] { study::verify(study); });
  orWords([&] {
    for (const auto& event : study.events().read()) describe(event);
  });
  orWords([&] { study.identities().names(); });
  orWords([&] {
    for (const auto& visit : study.traces().visits()) study.traces().read(visit);
  });
  const study::storage::Records records(study.database());
  orWords([&] { records.sessions(); });
  orWords([&] { records.answers(); });
  orWords([&] { records.trials(); });
  orWords([&] { records.cuts(); });
  orWords([&] { computeResults(study, study::RunMode::Live); });
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
  static const Walked kWalked;
  const auto folder = kWalked.folderWith(data, count);
  orWords([&] {
    study::SimulatedClock clock;
    auto study = study::Study::open(folder, clock, study::storage::Database::Access::ReadOnly);
    readAll(study);
    // Control: it is this study that is read.
    if (count < 4 && (!verify(study).isSound() || study.traces().visits().size() != 2)) {
      std::abort();
    }
  });
  return 0;
}
