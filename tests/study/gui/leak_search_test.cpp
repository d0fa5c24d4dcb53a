// Nobody in front of a screen learns what an alternative is: whatever ran, the same words are to be
// seen and heard, and none of them is a condition's.
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
#include "tests/support/long_form.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace leak_search_test {

/// What was logged while it lives.
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

/// All that two people could come upon in a whole session.
struct Sitting {
  std::set<QString> byParticipant;
  std::set<QString> byOperator;
  SessionState state = SessionState::Enrolled;
};

/// Measured numbers differ from run to run; words must not, but for those that stand there only
/// when somebody looks in the middle of a cut, or when a picture has been drawn by then.
std::set<QString> withoutNumbers(const std::set<QString>& words) {
  static const QRegularExpression number(QStringLiteral("-?\\d+([.,]\\d+)?(e[+-]?\\d+)?|—"));
  static const QRegularExpression passing(
      QStringLiteral("^after # s$| · # pictures a second, # ms old$"));
  std::set<QString> bare;
  for (auto text : words) {
    bare.insert(text.replace(number, QStringLiteral("#")).remove(passing));
  }
  return bare;
}

class LeakSearch : public testing::TestWithParam<std::string> {
 protected:
  /// The shipped protocol; every condition renders what the one @p shift places on did.
  nlohmann::ordered_json permuted(std::size_t shift) const {
    questionnaires::Problems problems;
    const auto shipped = protocols::loadProtocolFile(GetParam(), problems);
    auto json = nlohmann::ordered_json::parse(shipped->text);
    const auto original = json["conditions"];
    for (std::size_t i = 0; i < original.size(); ++i) {
      json["conditions"][i]["scene"] = original[(i + shift) % original.size()]["scene"];
    }
    for (auto& phase : json["phases"]) {
      // The short form feels everything once: the words are the same.
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
    auto study = Study::create(folder_ / ("study-" + name), *protocol, clock, 7);
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

  /// What must not be seen: what conditions are called, and what renders them.
  std::set<std::string> secrets() const {
    std::set<std::string> secrets;
    const auto json = permuted(0);
    for (const auto& condition : json["conditions"]) {
      secrets.insert(condition["id"].get<std::string>());
      secrets.insert(condition["title"].get<std::string>());
    }
    for (const auto* word : {"kalman", "finite element", "parametric", "hysteresis", "hardness-"}) {
      secrets.insert(word);
    }
    return secrets;
  }

  void expectNoSecretIn(const std::set<QString>& words) const {
    for (const auto& text : words) {
      for (const auto& secret : secrets()) {
        const auto whole = QStringLiteral("\\b%1\\b")
                               .arg(QRegularExpression::escape(QString::fromStdString(secret)));
        const QRegularExpression wanted(whole, QRegularExpression::CaseInsensitiveOption);
        EXPECT_FALSE(text.contains(wanted)) << '"' << text.toStdString() << "\" says " << secret;
      }
    }
  }

  tests::ScratchFolder folder_;
};

TEST_P(LeakSearch, FindsTheSameWordsWhateverTheAlternativesAre) {
  QApplication::clipboard()->clear();
  Log::lines().clear();
  const Log log;
  const auto asItShips = felt(0);
  const auto permuted = felt(1);
  ASSERT_EQ(asItShips.state, SessionState::Completed);
  ASSERT_EQ(permuted.state, SessionState::Completed);
  ASSERT_GT(asItShips.byParticipant.size(), 60U) << "it has really looked";
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
