// The library's protocols are valid, match their descriptions and are as balanced as they claim.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/engine/scene_spec.h"
#include "protocols/load_protocol.h"
#include "protocols/model/loaded_protocol.h"
#include "protocols/orders/schedule.h"
#include "questionnaires/reading/instrument_file.h"

namespace protocols {
namespace library_test {

using Words = std::vector<std::string>;

const Words kShipped{
    "punch-counterbalanced",
    "punch-face-validity",
    "punch-paper-equations",
    "reaming-hardness",
    "two-devices"};

/// A shipped protocol, and what is said about it.
struct Reading {
  LoadedProtocol loaded;
  std::vector<questionnaires::Problem> problems;
};

Reading read(const std::string& name) {
  questionnaires::Problems problems;
  auto loaded = loadProtocolFile(name, problems);
  EXPECT_TRUE(loaded.has_value()) << name << "\n" << describe(problems.all());
  return {loaded ? std::move(*loaded) : LoadedProtocol(), problems.all()};
}

/// The warnings that are about the protocol itself and not a template that it uses.
Words designWarnings(const std::string& name) {
  Words said;
  for (const auto& problem : read(name).problems) {
    if (problem.path.starts_with("$"))
      said.push_back(problem.path + ": " + base::describe(problem.what));
  }
  return said;
}

TEST(ProtocolLibrary, HoldsTheFiveShippedProtocolsAndTheirSchema) {
  Words names;
  for (const auto& file : libraryFiles()) names.emplace_back(file.name);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(
      names,
      (Words{
          "protocol-1.schema.json",
          "punch-counterbalanced.json",
          "punch-face-validity.json",
          "punch-paper-equations.json",
          "reaming-hardness.json",
          "two-devices.json"}));
}

TEST(ProtocolLibrary, HasNoErrors) {
  for (const auto& name : kShipped) {
    for (const auto& problem : read(name).problems) {
      EXPECT_EQ(problem.severity, questionnaires::Severity::Warning)
          << name << base::describe(problem.what);
    }
  }
}

TEST(ProtocolLibrary, CallsEveryFileAfterItsStudy) {
  for (const auto& name : kShipped) EXPECT_EQ(read(name).loaded.protocol.study.id, name);
}

TEST(ProtocolLibrary, NeedsNoOtherFile) {
  for (const auto& name : kShipped) {
    for (const auto& file : read(name).loaded.files) {
      EXPECT_TRUE(file.name.starts_with(kLibraryCopyPrefix)) << name << " " << file.name;
    }
    EXPECT_TRUE(read(name).loaded.protocol.instrumentFiles.empty()) << name;
  }
}

TEST(ProtocolLibrary, IsCompleteInThreeLanguages) {
  for (const auto& name : kShipped) {
    const auto reading = read(name);
    EXPECT_EQ(reading.loaded.protocol.languages, (Words{"en", "de", "nb"})) << name;
    for (const auto& cohort : reading.loaded.protocol.cohorts) {
      for (const auto* language : {"en", "de", "nb"}) {
        EXPECT_TRUE(cohort.title.has(language)) << name << " " << cohort.id;
      }
    }
    for (const auto& problem : reading.problems) {
      EXPECT_NE(problem.what.key(), "no_text") << problem.path;
    }
  }
}

TEST(ProtocolLibrary, LeavesNoLabelThatGivesAConditionAway) {
  for (const auto& name : kShipped) {
    const auto protocol = read(name).loaded.protocol;
    const auto prefix = protocol.labels.prefix.in("en");
    for (const auto& condition : protocol.conditions) {
      EXPECT_EQ(prefix.find(condition.id), std::string::npos);
      EXPECT_EQ(prefix.find(condition.title), std::string::npos);
    }
  }
}

TEST(ProtocolLibrary, AsksForAsManyBenchmarkCutsAsItRequires) {
  for (const auto& name : kShipped) {
    for (const auto& phase : read(name).loaded.protocol.phases) {
      if (phase.type != PhaseType::Benchmark) continue;
      for (const auto& [language, text] : phase.text.all()) {
        EXPECT_NE(text.find(" " + std::to_string(phase.minimumCuts) + " "), std::string::npos)
            << name << " " << language << ": " << text;
      }
    }
  }
}

TEST(ProtocolLibrary, SaysInItsTitlesThatCutsAndBonesAreSynthetic) {
  for (const auto& name : kShipped) {
    const auto loaded = read(name).loaded;
    EXPECT_TRUE(std::any_of(loaded.sources.begin(), loaded.sources.end(), [](const auto& source) {
      return source.isSynthetic;
    })) << name;
    EXPECT_NE(loaded.protocol.study.title.find("(synthetic "), std::string::npos) << name;
  }
}

TEST(ProtocolLibrary, HasNoRecordedCutThatEndsAtOnce) {
  for (const auto& name : kShipped) {
    for (const auto& condition : read(name).loaded.protocol.conditions) {
      EXPECT_TRUE(haptics::engine::jumpsOf(*condition.model).empty()) << name << condition.id;
    }
  }
}

TEST(ProtocolLibrary, RendersThePublishedStudyByItsCodeAndByItsEquations) {
  using haptics::models::BoundaryCondition;
  using haptics::models::ToolInterpolation;
  const auto partsOf = [](const Protocol& protocol) {
    return std::get<haptics::engine::KalmanSpec>(*protocol.condition("kalman")->model);
  };
  const auto code = partsOf(read("punch-face-validity").loaded.protocol);
  EXPECT_EQ(code.scheme, haptics::models::KalmanScheme::AuthorsFirmware);
  EXPECT_EQ(code.smoothing, haptics::models::Smoothing::AuthorsFirmware);
  EXPECT_EQ(code.finiteElements.parameters.boundary, BoundaryCondition::B);
  EXPECT_EQ(code.finiteElements.parameters.weights, ToolInterpolation::AuthorsFirmware);
  EXPECT_EQ(code.interpolation.options.extrapolation, haptics::models::Extrapolation::AuthorsClamp);
  EXPECT_TRUE(code.isProcessAsPrinted);
  const auto paper = partsOf(read("punch-paper-equations").loaded.protocol);
  EXPECT_EQ(paper.scheme, haptics::models::KalmanScheme::PaperText);
  EXPECT_EQ(paper.smoothing, haptics::models::Smoothing::TwoPoint);
  EXPECT_EQ(paper.finiteElements.parameters.boundary, BoundaryCondition::A);
  EXPECT_EQ(paper.finiteElements.parameters.weights, ToolInterpolation::Paper);
  EXPECT_EQ(paper.interpolation.options.extrapolation, haptics::models::Extrapolation::Absent);
}

TEST(ProtocolLibrary, KeepsWhatIsUnwiseAboutThePublishedPunchStudyAndSaysSo) {
  EXPECT_EQ(designWarnings("punch-paper-equations"), designWarnings("punch-face-validity"));
  EXPECT_EQ(
      designWarnings("punch-face-validity"),
      (Words{
          "$.phases[4].order: everybody feels this block in the same order",
          "$.phases[6].questionnaires[0]: item '3.1' compares with the previous, and 'kalman' can "
          "come first in this block, where there is none",
          "$.analysis.families[0]: conditions answer different statements in 'round-1'",
          "$.labels.policy: the number of an alternative says which condition it is",
          "$.phases[4].order: the position in 'round-1' says which condition it is",
          "$.phases[4].questionnaires[0]: the statements that are asked in 'round-1' say which "
          "condition it is",
          "$.phases[6].questionnaires[0]: the statements that are asked in 'round-2' say which "
          "condition it is",
          "$.analysis.families[0].test: Welch's test takes all answers for independent, and each "
          "person gives several"}));
}

TEST(ProtocolLibrary, HasNoUnwiseDesignOtherwise) {
  for (const auto* name : {"punch-counterbalanced", "reaming-hardness", "two-devices"}) {
    EXPECT_EQ(designWarnings(name), Words{}) << name;
  }
}

TEST(ProtocolLibrary, AsksThePublishedStatementsSetBySet) {
  const auto protocol = read("punch-face-validity").loaded.protocol;
  for (const auto* round : {"round-1", "round-2"}) {
    const auto& asked = protocol.phase(round)->trials.questionnaires.at(0);
    EXPECT_EQ(asked.instrument, "punch-face-validity");
    EXPECT_EQ(asked.itemSetFor("interpolation"), "1");
    EXPECT_EQ(asked.itemSetFor("finite-elements"), "2");
    EXPECT_EQ(asked.itemSetFor("kalman"), "3");
  }
  EXPECT_FALSE(*protocol.phase("round-1")->trials.isVisualised);
  EXPECT_TRUE(*protocol.phase("round-2")->trials.isVisualised);
}

TEST(ProtocolLibrary, DeclaresTestsOfParticipantsMeansInStudiesOfOurOwn) {
  for (const auto* name : {"punch-counterbalanced", "reaming-hardness", "two-devices"}) {
    for (const auto& family : read(name).loaded.protocol.analysis.families) {
      EXPECT_EQ(family.test, TestType::PairedT) << name << " " << family.id;
      EXPECT_EQ(family.correction, CorrectionType::Holm) << name << " " << family.id;
    }
  }
}

TEST(ProtocolLibrary, AsksOfReamingWhatThePaperProposes) {
  const auto loaded = read("reaming-hardness").loaded;
  const auto& reaming = loaded.protocol;
  std::set<std::string> asked;
  for (const auto& use : instrumentUses(reaming)) asked.insert(use.instrument);
  for (const auto* instrument :
       {"ueq-s",
        "usability-short",
        "nasa-tlx-raw",
        "presence-single-item",
        "reaming-quality",
        "training-capacity",
        "interview-felt"}) {
    EXPECT_EQ(asked.count(instrument), 1U) << instrument;
  }
  EXPECT_EQ(loaded.instrument("interview-felt")->item("picture"), nullptr) << "none is shown";
  EXPECT_EQ(reaming.cohorts.size(), 3U);
}

TEST(ProtocolLibrary, ComparesThePublishedPairsAsPublished) {
  const auto protocol = read("punch-face-validity").loaded.protocol;
  ASSERT_EQ(protocol.analysis.families.size(), 1U);
  const auto& family = protocol.analysis.families[0];
  EXPECT_EQ(family.test, TestType::Welch);
  EXPECT_EQ(family.correction, CorrectionType::Bonferroni);
  EXPECT_EQ(family.alpha, 0.05);
  EXPECT_EQ(family.comparisons.size(), 3U);  // all pairs of three
}

/// Checks every count of a design with @p participants of a cohort.
void expectBalanced(const Balance& balance, std::size_t participants, bool hasNeighbours) {
  const auto k = balance.conditions.size();
  const auto atEach = static_cast<int>(participants / k);
  const auto afterEach = static_cast<int>(participants / k);  // k − 1 successions, k(k − 1) pairs
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) {
      EXPECT_EQ(balance.positionCounts[i][j], atEach);
      if (hasNeighbours) {
        EXPECT_EQ(balance.after[i][j], i == j ? 0 : afterEach);
      }
    }
  }
}

/// Whether every block of a shipped protocol is balanced, counted, for each cohort and seed.
void expectBalancedThroughout(const std::string& name, std::size_t participants) {
  const auto protocol = read(name).loaded.protocol;
  for (const auto& phase : protocol.phases) {
    if (phase.type != PhaseType::Block) continue;
    for (const auto& cohort : protocol.cohorts) {
      for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2026}}) {
        SCOPED_TRACE(name + " " + phase.id + " " + cohort.id);
        const auto balance = balanceOf(protocol, phase, seed, cohort.id, participants);
        EXPECT_TRUE(balance.isBalanced);
        expectBalanced(balance, participants, true);
      }
    }
  }
}

TEST(ProtocolLibrary, IsBalancedForEveryNumberThatBalancesIt) {
  for (const std::size_t participants : {6U, 12U, 18U, 60U}) {
    expectBalancedThroughout("punch-counterbalanced", participants);
  }
  for (const std::size_t participants : {4U, 8U, 12U, 40U}) {
    expectBalancedThroughout("reaming-hardness", participants);
  }
  expectBalancedThroughout("two-devices", 6);
}

TEST(ProtocolLibrary, IsNotBalancedForAnyNumberBetween) {
  for (const auto& [name, multiple] :
       {std::pair{"punch-counterbalanced", 6U}, std::pair{"reaming-hardness", 4U}}) {
    const auto protocol = read(name).loaded.protocol;
    for (const auto& phase : protocol.phases) {
      if (phase.type != PhaseType::Block) continue;
      for (std::size_t n = 1; n < 3 * multiple; ++n) {
        const auto balance = balanceOf(protocol, phase, 1, protocol.cohorts.front().id, n);
        EXPECT_EQ(balance.multipleOf, multiple);
        EXPECT_EQ(balance.isBalanced, n % multiple == 0) << name << " " << n;
      }
    }
  }
}

TEST(ProtocolLibrary, PlansNumbersThatBalanceEveryBlockButThePublishedOnes) {
  for (const auto* name : {"punch-counterbalanced", "reaming-hardness", "two-devices"}) {
    const auto protocol = read(name).loaded.protocol;
    for (const auto& phase : protocol.phases) {
      if (phase.type != PhaseType::Block) continue;
      for (const auto& cohort : protocol.cohorts) {
        ASSERT_GT(cohort.planned, 0);
        const auto planned = static_cast<std::size_t>(cohort.planned);
        EXPECT_TRUE(balanceOf(protocol, phase, 1, cohort.id, planned).isBalanced)
            << name << " " << phase.id << " " << cohort.id;
      }
    }
  }
}

// What 'protocol check' says of a template in English stands for the other languages too.
TEST(ProtocolLibrary, UsesTemplatesThatHaveTheSameBlanksInEveryLanguage) {
  for (const auto& file : questionnaires::libraryFiles()) {
    if (file.name.ends_with(".schema.json")) continue;
    const auto instrument =
        questionnaires::readValidInstrument(file.content, std::string(file.name));
    std::map<std::string, std::set<std::string>> blanks;
    for (const auto& problem : problemsOf(instrument).all()) {
      if (base::describe(problem.what).find("filled in") == std::string::npos) continue;
      const auto dot = problem.path.rfind('.');
      blanks[problem.path.substr(0, dot)].insert(problem.path.substr(dot + 1));
    }
    for (const auto& [place, languages] : blanks) {
      EXPECT_EQ(languages, (std::set<std::string>{"de", "en", "nb"})) << file.name << " " << place;
    }
  }
}

}  // namespace library_test
}  // namespace protocols
