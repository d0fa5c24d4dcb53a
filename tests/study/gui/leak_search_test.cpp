// Checks that no window reveals the condition of an alternative. The texts of a session must be the
// same whichever conditions are assigned to the labels, and no text may name a condition.
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <QApplication>
#include <QClipboard>
#include <QRegularExpression>

#include "protocols/load_protocol.h"
#include "study/gui/operator/operator_window.h"
#include "study/storage/records.h"
#include "tests/study/gui/participant.h"
#include "tests/study/known_secret.h"
#include "tests/support/long_form.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace leak_search_test {

/// Collects all log messages during its lifetime.
class Log {
 public:
  Log() { before_ = qInstallMessageHandler(&Log::take); }
  ~Log() { qInstallMessageHandler(before_); }

  static std::set<QString>& lines() {
    static std::set<QString> lines;
    return lines;
  }

 private:
  static void take(QtMsgType /*type*/, const QMessageLogContext& /*where*/, const QString& words) {
    lines().insert(words);
  }

  QtMessageHandler before_ = nullptr;
};

/// All texts in both windows during a whole session.
struct Sitting {
  std::set<QString> byParticipant;
  std::set<QString> byOperator;
  SessionState state = SessionState::Enrolled;
};

/// Removes numbers, which differ from run to run, and texts whose presence depends on timing: those
/// shown during a cut only, and those that appear after the first picture.
std::set<QString> withoutNumbers(const std::set<QString>& words) {
  static const QRegularExpression number(QStringLiteral("[-−]?\\d+([.,]\\d+)?(e[+-]?\\d+)?|—"));
  static const QRegularExpression passing(QStringLiteral(
      " · # pictures a second, # ms old$|^[●▲✖] (Timing|Force at its limit|Leaps).*$"));
  std::set<QString> bare;
  for (auto text : words) {
    bare.insert(text.replace(number, QStringLiteral("#")).remove(passing));
  }
  return bare;
}

class LeakSearch : public testing::TestWithParam<std::string> {
 protected:
  /// The shipped protocol with the scenes of its conditions rotated by @p shift places.
  nlohmann::ordered_json permuted(std::size_t shift) const {
    questionnaires::Problems problems;
    const auto shipped = protocols::loadProtocolFile(GetParam(), problems);
    auto json = nlohmann::ordered_json::parse(shipped->text);
    const auto original = json["conditions"];
    for (std::size_t i = 0; i < original.size(); ++i) {
      auto& scene = json["conditions"][i]["scene"];
      scene = original[(i + shift) % original.size()]["scene"];
      if (scene["device"] == "reamer") scene["reamer"] = {{"speed", 50}};  // saves time
    }
    for (auto& phase : json["phases"]) {
      // In the short form each condition is rendered once: the texts are the same.
      if (phase.contains("minimum_cuts") && !tests::isLong()) phase["minimum_cuts"] = 1;
    }
    return json;
  }

  Sitting felt(std::size_t shift) {
    const auto name = std::to_string(shift);
    const auto file = folder_.write("protocol-" + name + ".json", permuted(shift).dump(1));
    questionnaires::Problems problems;
    const auto protocol = protocols::loadProtocolFile(file, problems);
    if (!protocol) throw std::runtime_error(questionnaires::describe(problems.all()));
    SystemClock clock;
    auto study =
        Study::create(folder_ / ("study-" + name), *protocol, clock, 7, tests::knownSecret());
    OperatorWindow window(study);
    window.show();
    window.enrol(
        {.cohort = protocol->protocol.cohorts.front().id,
         .runMode = RunMode::Live,
         .language = "en",
         .code = {}});
    tests::Participant participant(window);
    participant.takePart();
    return {
        participant.seen(),
        participant.seenByOperator(),
        storage::Records(study.database()).sessions().front().state};
  }

  /// The names of the conditions and of their models, which must not be visible.
  std::set<std::string> secrets() const {
    std::set<std::string> secrets;
    const auto json = permuted(0);
    for (const auto& condition : json["conditions"]) {
      secrets.insert(condition["id"].get<std::string>());
      secrets.insert(condition["title"].get<std::string>());
      secrets.insert(condition["scene"]["model"].get<std::string>());
    }
    for (const auto* word : {"kalman", "finite element", "parametric", "hysteresis", "hardness-"}) {
      secrets.insert(word);
    }
    return secrets;
  }

  void expectNoSecretIn(const std::set<QString>& words) const {
    QStringList parts;
    for (const auto& secret : secrets()) {
      parts << QRegularExpression::escape(QString::fromStdString(secret));
    }
    const QRegularExpression secret(
        QStringLiteral("\\b(%1)\\b").arg(parts.join(QLatin1Char('|'))),
        QRegularExpression::CaseInsensitiveOption);
    for (const auto& text : words) {
      const auto found = secret.match(text);
      EXPECT_FALSE(found.hasMatch())
          << '"' << text.toStdString() << "\" says " << found.captured().toStdString();
    }
  }

  tests::ScratchFolder folder_;
};

TEST_P(LeakSearch, FindsTheSameTextsForPermutedConditions) {
  QApplication::clipboard()->clear();
  Log::lines().clear();
  const Log log;
  const auto asItShips = felt(0);
  const auto permuted = felt(1);
  ASSERT_EQ(asItShips.state, SessionState::Completed);
  ASSERT_EQ(permuted.state, SessionState::Completed);
  ASSERT_GT(asItShips.byParticipant.size(), 60U) << "the search read the windows";
  ASSERT_GT(asItShips.byOperator.size(), 60U);

  EXPECT_EQ(withoutNumbers(asItShips.byParticipant), withoutNumbers(permuted.byParticipant));
  EXPECT_EQ(withoutNumbers(asItShips.byOperator), withoutNumbers(permuted.byOperator));
  for (const auto* sitting : {&asItShips, &permuted}) {
    expectNoSecretIn(sitting->byParticipant);
    expectNoSecretIn(sitting->byOperator);
  }
  expectNoSecretIn(Log::lines());
  EXPECT_TRUE(QApplication::clipboard()->text().isEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    ShippedStudies,
    LeakSearch,
    testing::Values("punch-face-validity", "reaming-hardness"),
    [](const auto& example) { return example.param == "reaming-hardness" ? "Reaming" : "Punch"; });

}  // namespace leak_search_test
}  // namespace study::gui
