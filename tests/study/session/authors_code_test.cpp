// The shipped protocol of the published study renders what the authors' code computes: boundary,
// weights, clamp, filter and smoothing, written here from their program with plain matrices. Of
// that program there are two versions, which differ in boundary and smoothing.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/engine/compiled_scene.h"
#include "haptics/recordings/cut.h"
#include "protocols/load_protocol.h"
#include "protocols/reading/cut_file.h"
#include "study/session/import_recording.h"
#include "tests/haptics/recordings/printed_table.h"
#include "tests/study/made_study.h"
#include "tests/support/test_data.h"

namespace study {
namespace authors_code_test {

using haptics::engine::CompiledScene;
using haptics::recordings::CurvePoint;
using haptics::recordings::Cut;

const char* const kCopy = "punch/matlab/11_meniscus_fast_1826 - Copy.txt";
constexpr double kSame = 1e-9;  // [N]
/// The filter of the code begins with P = 0 and ours with P = Q, which a hand at rest forgets:
/// after two seconds the forces differ by less than 10 nN.
constexpr double kSameFilter = 1e-7;  // [N]

/// The versions of the authors' program, by commit.
enum class Version {
  At420bed5,  ///< all springs alike; the filtered force is averaged with its own output
  At705a92e,  ///< the outer springs as in eq. (6); the filtered force goes to the motor as it is
};

/// What the authors' program computes, step by step.
class AuthorsCode {
 public:
  explicit AuthorsCode(std::vector<CurvePoint> table, Version version = Version::At420bed5)
      : table_(std::move(table)), version_(version) {}

  /// Its table between two lines, and never less than 0.01 N nor more than 4.29 N.
  double recorded(double travel) const {
    double force = 0.0;
    for (std::size_t i = 0; i + 1 < table_.size(); ++i) {
      const auto& a = table_[i];
      const auto& b = table_[i + 1];
      if (travel > a.travel && travel <= b.travel) {
        force = a.force + (b.force - a.force) * (travel - a.travel) / (b.travel - a.travel);
      }
    }
    return std::clamp(force, 0.01, 4.29);
  }

  /// Five elements from 0.5 to 2; the tool at 1.5 lies in the fourth and is put onto the midpoints
  /// of the fourth and the fifth. K u = c by elimination.
  double elements(double travel) const {
    constexpr double kSpring = 1.0 / (2.0 * 0.3);
    const std::array<double, 5> c{0.0, 0.0, 0.0, (1.85 - 1.5) / 0.3, (1.5 - 1.55) / 0.3};
    std::array<double, 5> diagonal{};
    std::array<double, 5> u = c;
    diagonal.fill(2.0 * kSpring);
    if (version_ == Version::At705a92e) diagonal.front() = diagonal.back() = 3.0 * kSpring;
    for (std::size_t i = 1; i < 5; ++i) {
      const double factor = -kSpring / diagonal[i - 1];
      diagonal[i] += factor * kSpring;
      u[i] -= factor * u[i - 1];
    }
    for (std::size_t i = 5; i-- > 0;) {
      if (i < 4) u[i] += kSpring * u[i + 1];
      u[i] /= diagonal[i];
    }
    double compliance = 0.0;
    for (std::size_t i = 0; i < 5; ++i) compliance += c[i] * u[i];
    return std::clamp((travel - 4.0) / compliance, 0.0, 7.0);
  }

  /// Predicts and corrects with the elements, then again with the table; then the moving average of
  /// the version that has one.
  double filtered(double travel) {
    const double moved = hasStarted_ ? travel - last_ : 0.0;
    last_ = travel;
    correct(moved, elements(travel), 0.001);
    correct(moved, recorded(travel), 7.742);
    if (version_ == Version::At705a92e) {
      hasStarted_ = true;
      return force_;
    }
    if (!hasStarted_) average_ = before_ = beforeThat_ = force_;
    hasStarted_ = true;
    average_ = (average_ + before_ + beforeThat_) / 3.0;
    beforeThat_ = before_;
    before_ = force_;
    return average_;
  }

 private:
  /// x ← A x, P ← A P Aᵀ + Q with Q as printed, and one measurement of the force.
  void correct(double moved, double measured, double variance) {
    force_ += moved * slope_;
    const double a = p_[0] + moved * p_[2];
    const double b = p_[1] + moved * p_[3];
    const std::array<double, 4> p{
        a + moved * b + 7.0275, b + 0.02772, p_[2] + moved * p_[3] + 0.2772, p_[3] + 6.1024};
    const double gain = p[0] / (p[0] + variance);
    const double slopeGain = p[2] / (p[0] + variance);
    const double error = measured - force_;
    force_ += gain * error;
    slope_ += slopeGain * error;
    p_ = {
        (1.0 - gain) * p[0], (1.0 - gain) * p[1], p[2] - slopeGain * p[0], p[3] - slopeGain * p[1]};
  }

  std::vector<CurvePoint> table_;
  Version version_;
  std::array<double, 4> p_{};  ///< P by rows
  double force_ = 0.0;
  double slope_ = 0.0;
  double last_ = 0.0;
  double average_ = 0.0;
  double before_ = 0.0;
  double beforeThat_ = 0.0;
  bool hasStarted_ = false;
};

std::string shippedStudy() {
  for (const auto& file : protocols::libraryFiles()) {
    if (file.name == "punch-face-validity.json") return std::string(file.content);
  }
  return {};
}

/// Holds the three conditions against the authors' code, at the points of @p table in order.
void expectAuthorsForces(
    const protocols::Protocol& protocol,
    const std::vector<CurvePoint>& table,
    Version version = Version::At420bed5) {
  CompiledScene interpolation(protocol.condition("interpolation")->scene());
  CompiledScene elements(protocol.condition("finite-elements")->scene());
  CompiledScene kalman(protocol.condition("kalman")->scene());
  AuthorsCode authors(table, version);
  const auto feel = [](CompiledScene& scene, double travel) {
    return scene.respond({.travel = travel, .dt = 0.001}).force;
  };
  for (int i = 0; i < 2000; ++i) {  // a hand that rests at the first point for two seconds
    EXPECT_NEAR(
        feel(kalman, table.front().travel), authors.filtered(table.front().travel), kSameFilter);
  }
  for (const auto& point : table) {
    const double x = point.travel;
    EXPECT_NEAR(feel(interpolation, x), authors.recorded(x), kSame) << x;
    EXPECT_NEAR(feel(elements, x), authors.elements(x), kSame) << x;
    EXPECT_NEAR(feel(kalman, x), authors.filtered(x), kSameFilter) << x;
  }
}

TEST(AuthorsCode, IsWhatThePublishedStudyRendersFromTheSyntheticCut) {
  const auto protocol = tests::libraryProtocol("punch-face-validity").protocol;
  expectAuthorsForces(protocol, haptics::recordings::parametricCut({.release = 1.5}).curve.nodes());
}

TEST(AuthorsCode, HasElementsOfThePublishedStiffness) {
  // docs/force-models.md, at N = 5: B and A with the weights of the code
  EXPECT_NEAR(AuthorsCode({}, Version::At420bed5).elements(5.0), 1.055718, 1e-6);
  EXPECT_NEAR(AuthorsCode({}, Version::At705a92e).elements(5.0), 1.276596, 1e-6);
}

TEST(AuthorsCode, OfTheOtherVersionIsRenderedWithBoundaryAAndWithoutSmoothing) {
  std::string text = shippedStudy();
  const auto replace = [&](const std::string& part, const std::string& other) {
    ASSERT_NE(text.find(part), std::string::npos) << part;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at)) {
      text.replace(at, part.size(), other);
    }
  };
  replace("\"boundary\": \"B\"", "\"boundary\": \"A\"");
  replace("\"smoothing\": \"authors-firmware\"", "\"smoothing\": \"none\"");
  expectAuthorsForces(
      tests::protocolFrom(text).protocol,
      haptics::recordings::parametricCut({.release = 1.5}).curve.nodes(),
      Version::At705a92e);
}

TEST(AuthorsCode, IsWhatThePublishedStudyRendersFromItsOwnRecordingAtThe76Points) {
  SKIP_WITHOUT_FETCHED_DATA(kCopy);
  const auto recording = haptics::recordings::readRecordingFile(tests::fetchedData(kCopy).string());
  const auto imported = importPublishedCut(recording);
  const auto& table = imported.cut.curve.nodes();
  ASSERT_EQ(table.size(), 76U);
  EXPECT_EQ(imported.cut.provenance.filter, "authors-fir-333");
  for (const auto& printed : tests::kPrintedTable) {
    EXPECT_NEAR(table[printed.index].travel, printed.travel, tests::kPrintedRounding);
    EXPECT_NEAR(table[printed.index].force, printed.force, tests::kPrintedRounding);
  }
  const auto loaded = tests::protocolFrom(
      withRecordedCut(shippedStudy(), "recorded-cut.json"),
      {{"recorded-cut.json", protocols::cutAsJson(imported.cut, std::string(64, '0'))}});
  EXPECT_NE(loaded.protocol.study.title.find("(recorded cut)"), std::string::npos);
  for (const auto& source : loaded.sources) EXPECT_FALSE(source.isSynthetic) << source.kind;
  expectAuthorsForces(loaded.protocol, table);
}

/// A recording of 100 rows whose rows 11 to 86 have the times of the published cut.
haptics::recordings::Recording madeRecording(double lastTime) {
  haptics::recordings::Recording recording{.source = "made.txt"};
  for (int i = 0; i < 100; ++i) {
    recording.rows.push_back({.travel = 0.1 * i, .time = 1'820'425.0 + 3.0 * (i - 10)});
  }
  recording.rows[85].time = lastTime;
  return recording;
}

TEST(PublishedCut, IsKnownByTheTimesOfIts76Rows) {
  using haptics::recordings::publishedCutIn;
  const auto found = publishedCutIn(madeRecording(1'820'659.0));
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, (haptics::recordings::RowRange{11, 86}));
  EXPECT_FALSE(publishedCutIn(madeRecording(1'820'650.0)));
  auto cutOff = madeRecording(1'820'659.0);
  cutOff.rows.resize(85);
  EXPECT_FALSE(publishedCutIn(cutOff));
}

TEST(RecordedCut, TakesThePlaceOfTheSyntheticOneInTheProtocolAndItsTitle) {
  const auto text = withRecordedCut(shippedStudy(), "mine.json");
  EXPECT_EQ(text.find("parametric"), std::string::npos);
  EXPECT_EQ(text.find("synthetic"), std::string::npos);
  EXPECT_NE(text.find("\"cut\": \"mine.json\""), std::string::npos);
}

}  // namespace authors_code_test
}  // namespace study
