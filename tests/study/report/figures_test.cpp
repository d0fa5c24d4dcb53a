#include "study/report/figures.h"

#include <gtest/gtest.h>

#include <QString>
#include <QXmlStreamReader>

#include "tests/study/report/section.h"

namespace study::report {
namespace {

/// Every text in an SVG, with a space after each.
std::string textsIn(const std::string& svg) {
  QXmlStreamReader reader(QString::fromStdString(svg));
  QString texts;
  while (!reader.atEnd()) {
    if (reader.readNext() == QXmlStreamReader::Characters) texts += reader.text().toString() + QLatin1Char(' ');
  }
  EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString();
  return texts.simplified().toStdString();
}

ReportSection painted() {
  auto section = tests::madeUpSection();
  paintFigures(section);
  return section;
}

TEST(Figures, AreOneForEachFamilyEachDeviceAndTheVotes) {
  const auto figures = painted().figures;
  EXPECT_EQ(figures.likert.size(), 1U);
  EXPECT_EQ(figures.felt.size(), 1U);
  EXPECT_FALSE(figures.votes.empty());
}

TEST(Figures, SayHowOftenEachPointWasChosen) {
  const auto texts = textsIn(painted().figures.likert.front());
  for (const auto* words : {"Interpolation", "FEM", "KF", "Orthopaedic surgeons", "17", "13", "μ 4.1",
                            "μ 2.6", "strongly disagree", "strongly agree"}) {
    EXPECT_NE(texts.find(words), std::string::npos) << words << " in " << texts;
  }
}

TEST(Figures, NameTheirAxesAndUnits) {
  const auto texts = textsIn(painted().figures.felt.front());
  EXPECT_NE(texts.find("force [N]"), std::string::npos);
  EXPECT_NE(texts.find("travel [travel units]"), std::string::npos);
  EXPECT_NE(texts.find("4 trials"), std::string::npos);
}

TEST(Figures, AreTheSameBytesEveryTime) {
  const auto first = painted().figures;
  const auto second = painted().figures;
  EXPECT_EQ(first.likert, second.likert);
  EXPECT_EQ(first.votes, second.votes);
  EXPECT_EQ(first.felt, second.felt);
}

TEST(Figures, SurviveAStudyWithoutAnyAnswer) {
  auto section = tests::madeUpSection();
  for (auto& cohort : section.results.families.front().cohorts) {
    for (auto& condition : cohort.conditions) condition.counts = analysis::LikertCounts(1, 5);
  }
  section.results.votes.front().votes = analysis::VoteCounts({"interpolation", "kalman"});
  section.curves.clear();
  paintFigures(section);
  for (const auto& svg : {section.figures.likert.front(), section.figures.votes}) {
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_FALSE(textsIn(svg).empty());
  }
}

}  // namespace
}  // namespace study::report
