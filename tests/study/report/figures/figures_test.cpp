#include "study/report/figures/figures.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <QImage>
#include <QString>
#include <QXmlStreamReader>

#include "study/report/figures/palette.h"
#include "study/report/pdf_report.h"
#include "study/results/apa_text.h"
#include "tests/study/report/section.h"
#include "tests/support/colour_vision.h"

namespace study::report {
namespace figures_test {

/// Every text in an SVG, with a space after each.
std::string textsIn(const std::string& svg) {
  QXmlStreamReader reader(QString::fromStdString(svg));
  QString texts;
  while (!reader.atEnd()) {
    if (reader.readNext() == QXmlStreamReader::Characters)
      texts += reader.text().toString() + QLatin1Char(' ');
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
  ASSERT_EQ(figures.families.size(), 1U);
  EXPECT_FALSE(figures.families.front().participantMeans.empty());
  EXPECT_EQ(figures.renderedForce.size(), 1U);
  EXPECT_FALSE(figures.votes.empty());
}

/// The smallest difference between two of @p colours, for every kind of colour vision.
double smallestDifference(const std::vector<QColor>& colours) {
  double least = 1e9;
  const auto compare = [&](const tests::Matrix& eye) {
    for (std::size_t i = 0; i < colours.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        least = std::min(least, tests::colourDifference(colours[i], colours[j], eye));
      }
    }
  };
  compare(tests::kNormal);
  for (const auto& eye : tests::kColourBlind) compare(eye);
  return least;
}

TEST(Palette, IsToldApartByEveryColourVision) {
  constexpr double kClearly = 15.0;  // ΔE of CIE 1976; what is below about 2.3 is invisible
  std::vector<QColor> categories;
  for (int i = 0; i < 7; ++i) categories.push_back(categoryColour(i));
  EXPECT_GT(smallestDifference(categories), kClearly);
  std::vector<QColor> points;
  for (int i = 0; i < 5; ++i) points.push_back(divergingColour(i, 5));
  EXPECT_GT(smallestDifference(points), kClearly);
  EXPECT_LT(smallestDifference({QColor("#cc0000"), QColor("#2f7f00")}), kClearly);  // red and green
}

TEST(Figures, TellLinesApartByMarksToo) {
  const auto section = painted();
  const auto& felt = section.figures.renderedForce.front();
  std::size_t marks = 0;  // only they have a white edge
  const std::string edge = "stroke=\"#ffffff\"";
  for (auto at = felt.find(edge); at != std::string::npos; at = felt.find(edge, at + 1)) ++marks;
  EXPECT_GT(marks, section.curves.size());
}

TEST(Figures, SayHowOftenEachPointWasChosen) {
  const auto texts = textsIn(painted().figures.families.front().answers);
  for (const auto* words :
       {"Interpolation",
        "FEM",
        "KF",
        "Orthopaedic surgeons",
        "17",
        "13",
        "n = 36, M = 4.06",
        "n = 36, M = 2.64",
        "strongly disagree",
        "strongly agree"}) {
    EXPECT_NE(texts.find(words), std::string::npos) << words << " in " << texts;
  }
}

TEST(Figures, NameTheirAxesAndUnits) {
  const auto texts = textsIn(painted().figures.renderedForce.front());
  EXPECT_NE(texts.find("force [N]"), std::string::npos);
  EXPECT_NE(texts.find("travel [travel units]"), std::string::npos);
  EXPECT_NE(texts.find("13 cuts or strokes"), std::string::npos) << "as the caption counts";
}

TEST(Figures, ShowEffectsWithTheirNumbers) {
  const auto section = painted();
  const auto texts = textsIn(section.figures.families.front().effects);
  const auto& comparison = section.results.families.front().cohorts.front().within.rows.front();
  const auto& row = comparison.test("paired_t");
  EXPECT_NE(
      texts.find(rounded(row.estimate.value, 2) + " " + formatInterval(row.interval)),
      std::string::npos)
      << texts;
  EXPECT_NE(texts.find("Interpolation − FEM"), std::string::npos);
  EXPECT_NE(texts.find("difference of participants’ means [points]"), std::string::npos);
}

TEST(Figures, ShowBesideTheAnswerWhatItsSentencesState) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  family.family.test = protocols::TestType::PairedT;
  const auto& figures = section.figures.families;
  paintFigures(section);
  EXPECT_NE(textsIn(figures.front().mainEffects).find("KF − FEM"), std::string::npos)
      << "all of three";
  family.family.comparisons.push_back(family.family.comparisons.front());
  paintFigures(section);
  EXPECT_NE(textsIn(figures.front().mainEffects).find("Interpolation − KF"), std::string::npos);
  EXPECT_EQ(textsIn(figures.front().mainEffects).find("KF − FEM"), std::string::npos);
  EXPECT_NE(textsIn(figures.front().effects).find("KF − FEM"), std::string::npos)
      << "in its own file";
}

TEST(Figures, ShowTheSitesAndTheirPooledDifference) {
  auto section = tests::madeUpSectionOfSites();
  paintFigures(section);
  const auto texts = textsIn(section.figures.families.front().sites);
  const auto& row = section.results.families.front().cohorts.front().sites->rows.back();
  const auto& all = row.pooled.value().knappHartung;
  EXPECT_NE(
      texts.find(rounded(all.estimate, 2) + " " + formatInterval(all.interval)), std::string::npos)
      << texts;
  for (const auto* words :
       {"Orthopaedic surgeons: Interpolation − KF",
        "oslo (n = 3)",
        "tromso (n = 1)",
        "All sites"}) {
    EXPECT_NE(texts.find(words), std::string::npos) << words << " in " << texts;
  }
  EXPECT_TRUE(painted().figures.families.front().sites.empty());
}

TEST(Figures, ShowEveryParticipantOnce) {
  const auto section = painted();
  const auto& svg = section.figures.families.front().participantMeans;
  std::size_t dots = 0;
  for (auto at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1))
    ++dots;
  EXPECT_EQ(dots, 3U * 6U + 3U * 5U);
}

TEST(Figures, ShowVotesAndTheirTotal) {
  const auto texts = textsIn(painted().figures.votes);
  for (const auto* words : {"4 / 6", "0 / 6", "2 / 6", "Wilson’s 95 % interval"}) {
    EXPECT_NE(texts.find(words), std::string::npos) << words << " in " << texts;
  }
}

/// Answers to a choice and to a number, each about two alternatives.
ReportSection withItemsAboutAlternatives() {
  auto section = tests::madeUpSection();
  questionnaires::Item choice;
  choice.id = "grip";
  choice.type = questionnaires::ItemType::SingleChoice;
  choice.options = {
      {.id = "firm", .text = questionnaires::LocalizedText({{"en", "Firm"}})},
      {.id = "loose", .text = questionnaires::LocalizedText({{"en", "Loose"}})}};
  questionnaires::Item number;
  number.id = "seconds";
  number.type = questionnaires::ItemType::Number;
  auto& instrument = section.instruments.emplace_back();
  instrument.id = "mine";
  instrument.items = {choice, number};
  for (const auto* condition : {"interpolation", "kalman"}) {
    auto& items = section.results.answers.items;
    items.push_back(
        {.instrument = "mine",
         .item = "grip",
         .cohort = "professional",
         .condition = condition,
         .answers = 5,
         .options = {{"firm", 4}, {"loose", 1}}});
    items.push_back(
        {.instrument = "mine",
         .item = "seconds",
         .cohort = "professional",
         .condition = condition,
         .values = {12.0, 15.5, 20.0},
         .least = 12.0,
         .most = 20.0});
  }
  return section;
}

TEST(Figures, ShowChoicesAndNumbersAboutAlternatives) {
  auto section = withItemsAboutAlternatives();
  paintFigures(section);
  ASSERT_EQ(section.figures.items.size(), 2U);
  const auto choice = textsIn(section.figures.items[0].svg);
  for (const auto* words : {"Orthopaedic surgeons, KF", "Firm", "Loose", "4 / 5", "1 / 5"}) {
    EXPECT_NE(choice.find(words), std::string::npos) << words << " in " << choice;
  }
  const auto number = textsIn(section.figures.items[1].svg);
  for (const auto* words : {"Orthopaedic surgeons", "KF", "n = 3, M = 15.83"}) {
    EXPECT_NE(number.find(words), std::string::npos) << words << " in " << number;
  }
}

TEST(Figures, ArePdfAndPngOfTheirSize) {
  const auto svg = painted().figures.families.front().effects;
  EXPECT_EQ(figureAsPdf(svg).substr(0, 5), "%PDF-");
  const auto png = figureAsPng(svg);
  QImage image;
  ASSERT_TRUE(
      image.loadFromData(reinterpret_cast<const uchar*>(png.data()), static_cast<int>(png.size())));
  EXPECT_EQ(image.width(), 2563);  // 820 px at 96 dpi, converted to 300 dpi
}

/// The value of an attribute of the SVG's first tag.
std::string attributeOf(const std::string& svg, const std::string& name) {
  const auto begin = svg.find(name + "=\"") + name.size() + 2;
  return svg.substr(begin, svg.find('"', begin) - begin);
}

TEST(Figures, HaveTheWidthOfAColumnAndLettersThatCanBeRead) {
  const FigureFormat column{.width = 85.0, .font = 8.0};
  auto section = tests::madeUpSection();
  const auto asInReports = textsIn([&] {
    paintFigures(section);
    return section.figures.families.front().effects;
  }());
  paintFigures(section, column);
  for (const auto& [name, svg] : namedFigures(section)) {
    EXPECT_EQ(attributeOf(svg, "width"), "85.000mm") << name;
    QImage image;
    const auto png = figureAsPng(svg, column.scale());
    ASSERT_TRUE(image.loadFromData(
        reinterpret_cast<const uchar*>(png.data()), static_cast<int>(png.size())));
    EXPECT_NEAR(image.width(), 85.0 / 25.4 * 300.0, 1.0) << name;
    const auto pdf = figureAsPdf(svg, column.scale());
    EXPECT_NE(pdf.find("/MediaBox [0 0 241"), std::string::npos) << name;  // 85 mm in pt
  }
  // Letters of 13 px in a layout that is scaled to 8 pt.
  const auto& effects = section.figures.families.front().effects;
  EXPECT_EQ(attributeOf(effects, "viewBox").substr(0, 9), "0 0 391.5") << effects.substr(0, 300);
  const auto narrow = textsIn(effects);
  for (const auto* words : {"Interpolation − FEM", "Orthopaedic surgeons"}) {
    EXPECT_NE(asInReports.find(words), std::string::npos) << words;
    EXPECT_NE(narrow.find(words), std::string::npos) << words;
  }
}

TEST(Figures, UseTheLanguageOfTheReport) {
  for (const auto& language : words::languages()) {
    if (language == "en") continue;
    auto section = tests::madeUpSection();
    section.words = words::wordsIn(language);
    paintFigures(section);
    EXPECT_TRUE(section.words.missing().empty())
        << language << ": " << *section.words.missing().begin();
  }
}

TEST(Figures, AreTheSameBytesEveryTime) {
  const auto first = painted().figures;
  const auto second = painted().figures;
  for (const auto part :
       {&FamilyFigures::answers, &FamilyFigures::participantMeans, &FamilyFigures::effects}) {
    EXPECT_EQ(first.families.front().*part, second.families.front().*part);
  }
  EXPECT_EQ(first.votes, second.votes);
  EXPECT_EQ(first.renderedForce, second.renderedForce);
}

TEST(Figures, ArePaintedForAStudyWithoutAnswers) {
  auto section = tests::madeUpSection();
  for (auto& cohort : section.results.families.front().cohorts) {
    for (auto& condition : cohort.conditions) condition.answers = analysis::LikertCounts(1, 5);
    cohort.table.answers.clear();
    cohort.within = analysis::compareWithin(
        cohort.table, std::vector<analysis::DeclaredPair>{{"interpolation", "kalman"}}, {});
  }
  section.results.votes.front().votes = analysis::VoteCounts({"interpolation", "kalman"});
  section.curves.clear();
  paintFigures(section);
  const auto& family = section.figures.families.front();
  for (const auto& svg :
       {family.answers, family.participantMeans, family.effects, section.figures.votes}) {
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_FALSE(textsIn(svg).empty());
  }
}

}  // namespace figures_test
}  // namespace study::report
