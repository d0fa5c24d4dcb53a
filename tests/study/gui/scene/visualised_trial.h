// A session of a protocol with its windows, at the first trial.
#pragma once

#include <cstdlib>
#include <functional>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include <QLabel>
#include <QTest>

#include "protocols/load_protocol.h"
#include "protocols/model/loaded_protocol.h"
#include "study/gui/operator/operator_window.h"
#include "study/gui/scene/simulation_view.h"
#include "tests/study/gui/participant.h"
#include "tests/study/known_secret.h"
#include "tests/support/scratch_folder.h"

namespace tests {

using study::RunMode;
using study::StepKind;
using study::Study;
using study::SystemClock;
using study::gui::OperatorWindow;
using study::gui::scene::SimulationView;

class VisualisedTrial : public testing::Test {
 protected:
  /// Starts a session of a shipped protocol and takes it to its first trial.
  void begin(const std::string& protocol) {
    questionnaires::Problems problems;
    beginWith(*protocols::loadProtocolFile(protocol, problems));
  }

  void beginWith(const protocols::LoadedProtocol& loaded, RunMode mode = RunMode::Live) {
    study_.emplace(Study::create(folder_ / "study", loaded, clock_, 7, tests::knownSecret()));
    window_.emplace(*study_);
    window_->show();
    window_->enrol(
        {.cohort = loaded.protocol.cohorts.front().id,
         .runMode = mode,
         .language = "en",
         .code = {}});
    const auto& plan = window_->controller()->session().plan();
    int trial = 0;
    while (plan[static_cast<std::size_t>(trial)].kind != StepKind::Trial) ++trial;
    participant_.emplace(*window_);
    participant_->takePart(trial);
  }

  SimulationView* view() const {
    QTest::qWait(100);  // the view is created shortly after its page
    return window_->participantWindow()->findChild<SimulationView*>();
  }

  /// Takes a picture of the participant's page with its trial running, once @p isThere or after 20
  /// s. Does nothing if no pictures are wanted.
  void photographTrial(const char* name, const std::function<bool()>& isThere) {
    if (std::getenv("PALPATE_PICTURES") == nullptr) return;
    window_->participantWindow()->resize(1920, 1080);
    // As with an instrument in the hand.
    window_->participantWindow()->findChild<QLabel*>(QStringLiteral("pointer-hint"))->hide();
    static_cast<void>(QTest::qWaitFor(isThere, 20'000));
    QTest::qWait(200);  // the picture is drawn after the simulation
    photograph(*window_->participantWindow(), QString::fromUtf8(name));
  }

  std::vector<std::string> viewEvents() {
    std::vector<std::string> details;
    for (const auto& event : study_->events().read()) {
      if (event.kind == study::EventKind::View) details.push_back(study::storage::describe(event));
    }
    return details;
  }

  ScratchFolder folder_;
  SystemClock clock_;
  std::optional<Study> study_;
  std::optional<OperatorWindow> window_;
  std::optional<Participant> participant_;
};

/// The shipped reaming study with visualisation and a bone of spheres that are removed.
inline protocols::LoadedProtocol reamingThatIsSeen() {
  std::string json;
  for (const auto& file : protocols::libraryFiles()) {
    if (file.name == "reaming-hardness.json") json = file.content;
  }
  const auto replace = [&](const std::string& what, const std::string& with) {
    for (std::size_t at = json.find(what); at != std::string::npos;
         at = json.find(what, at + with.size())) {
      json.replace(at, what.size(), with);
    }
  };
  replace(R"("model": "material")", R"("model": "packing", "visualisation": true)");
  questionnaires::Problems problems;
  return *protocols::loadProtocol(
      json, [](const std::string&) { return std::nullopt; }, problems);
}

}  // namespace tests
