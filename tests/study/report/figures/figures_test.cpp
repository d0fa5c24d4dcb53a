#include "study/report/figures/figures.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <QImage>
#include <QRegularExpression>
#include <QString>
#include <QXmlStreamReader>

#include "study/cohort/simulated_participant.h"
#include "study/report/figures/palette.h"
#include "study/report/html_report.h"
#include "study/report/pdf_report.h"
#include "study/results/apa_text.h"
#include "tests/study/made_study.h"
#include "tests/study/report/section.h"
#include "tests/support/child_process.h"
#include "tests/support/colour_vision.h"
#include "tests/support/scratch_folder.h"

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
  EXPECT_FALSE(figures.families.front().people.empty());
  EXPECT_EQ(figures.felt.size(), 1U);
  EXPECT_FALSE(figures.votes.empty());
  EXPECT_FALSE(figures.timing.empty());
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
  const auto& felt = section.figures.felt.front();
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
        "μ 4.1",
        "μ 2.6",
        "strongly disagree",
        "strongly agree"}) {
    EXPECT_NE(texts.find(words), std::string::npos) << words << " in " << texts;
  }
}

TEST(Figures, NameTheirAxesAndUnits) {
  const auto texts = textsIn(painted().figures.felt.front());
  EXPECT_NE(texts.find("force [N]"), std::string::npos);
  EXPECT_NE(texts.find("travel [travel units]"), std::string::npos);
  EXPECT_NE(texts.find("4 trials"), std::string::npos);
}

TEST(Figures, ShowEffectsWithTheirNumbers) {
  const auto section = painted();
  const auto texts = textsIn(section.figures.families.front().effects);
  const auto& comparison = section.results.families.front().cohorts.front().within.rows.front();
  const auto& row = comparison.test("paired_t");
  EXPECT_NE(
      texts.find(rounded(row.estimate.value, 2) + " " + intervalInWords(row.interval)),
      std::string::npos)
      << texts;
  EXPECT_NE(texts.find("Interpolation − FEM"), std::string::npos);
  EXPECT_NE(texts.find("difference of participants’ means [points]"), std::string::npos);
}

TEST(Figures, ShowTheSitesAndTheirPooledDifference) {
  auto section = tests::madeUpSectionOfSites();
  paintFigures(section);
  const auto texts = textsIn(section.figures.families.front().sites);
  const auto& row = section.results.families.front().cohorts.front().sites->rows.back();
  const auto& all = row.pooled.value().knappHartung;
  EXPECT_NE(
      texts.find(rounded(all.estimate, 2) + " " + intervalInWords(all.interval)), std::string::npos)
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
  const auto& svg = section.figures.families.front().people;
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

TEST(PdfReport, HasPagesWithTheFiguresInThem) {
  const auto section = painted();
  const auto pdf = asPdf(asHtml({section}), "A study");
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  const auto bare = asPdf("<html><body><p>Nothing</p></body></html>", "A study");
  const auto pagesOf = [](const std::string& bytes) {
    std::size_t pages = 0;
    for (auto at = bytes.find("/Type /Page\n"); at != std::string::npos;
         at = bytes.find("/Type /Page\n", at + 1)) {
      ++pages;
    }
    return pages;
  };
  EXPECT_EQ(pagesOf(bare), 1U);
  EXPECT_GE(pagesOf(pdf), 4U);
}

/// The text of a PDF as it is searched or copied; std::nullopt if no tool can read it.
std::optional<std::string> textOf(const std::string& pdf) {
  const tests::ScratchFolder folder;
  const auto file = folder.write("page.pdf", pdf);
  try {
    const auto finished = tests::run({"pdftotext", "-layout", file, "-"});
    if (finished.status == 0) return finished.out;
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return std::nullopt;
}

std::size_t timesIn(const std::string& text, const std::string& words) {
  std::size_t times = 0;
  for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++times;
  return times;
}

TEST(PdfReport, HasEveryLineOnceAlsoAtPageBreaks) {
  constexpr int kWords = 6000;
  std::string body;
  for (int i = 0; i < kWords; ++i) {
    if (i % 240 == 0) body += i == 0 ? "<p>" : i % 480 == 0 ? "</li></ul><p>" : "</p><ul><li>";
    body += "w" + std::to_string(10000 + i) + " ";
  }
  const auto said = textOf(asPdf(
      "<html><head><style></style></head><body>" + body + "</li></ul></body></html>", "A study"));
  if (!said) GTEST_SKIP() << "needs pdftotext: ./setup --check";
  EXPECT_GE(timesIn(*said, "\f"), 4U) << "pages";
  for (int i = 0; i < kWords; ++i) {
    const auto word = "w" + std::to_string(10000 + i);
    EXPECT_EQ(timesIn(*said, word), 1U) << word;
  }
}

/// The pages of a PDF as text; std::nullopt if no tool can read it.
std::optional<std::vector<std::string>> pagesOf(const std::string& pdf) {
  const auto text = textOf(pdf);
  if (!text) return std::nullopt;
  std::vector<std::string> pages{""};
  for (const char c : *text) {
    if (c == '\f') {
      pages.emplace_back();
    } else {
      pages.back() += c;
    }
  }
  return pages;
}

/// The place of the first page that holds @p words.
std::size_t pageWith(const std::vector<std::string>& pages, const std::string& words) {
  const auto found = std::find_if(pages.begin(), pages.end(), [&](const auto& page) {
    return page.find(words) != std::string::npos;
  });
  return static_cast<std::size_t>(found - pages.begin());
}

/// Paragraphs, then a heading, a table of 12 rows, and a figure.
std::string pageAfter(int paragraphs) {
  std::string body;
  for (int i = 0; i < paragraphs; ++i) body += "<p>paragraph " + std::to_string(i) + "</p>";
  body +=
      "<h3>Heading of it</h3><table><caption>Caption of it</caption><thead><tr><th>Column</th>"
      "</tr></thead><tbody>";
  for (int i = 10; i < 22; ++i) body += "<tr><td>row" + std::to_string(i) + "</td></tr>";
  body +=
      "</tbody></table><figure><svg xmlns=\"http://www.w3.org/2000/svg\" "
      "viewBox=\"0 0 800 300\" width=\"800\" height=\"300\"><text x=\"10\" "
      "y=\"290\" font-size=\"20\">drawn</text></svg><figcaption>Words below</figcaption>"
      "</figure>";
  return "<html><head><style></style></head><body>" + body + "</body></html>";
}

/// How many rows of pageAfter() are on a page.
int rowsOn(const std::string& page) {
  int rows = 0;
  for (int i = 10; i < 22; ++i) {
    if (page.find("row" + std::to_string(i)) != std::string::npos) ++rows;
  }
  return rows;
}

/// The place of the page that begins the appendix, whose heading is a line of its own.
std::size_t pageOfAppendix(const std::vector<std::string>& pages) {
  static const QRegularExpression kHeading(
      QStringLiteral("^\\s*Appendix\\s*$"), QRegularExpression::MultilineOption);
  const auto found = std::ranges::find_if(pages, [](const auto& page) {
    return kHeading.match(QString::fromStdString(page)).hasMatch();
  });
  return static_cast<std::size_t>(found - pages.begin());
}

/// The pages of a report on a shipped protocol with simulated participants.
std::optional<std::vector<std::string>> pagesOfStudy(const char* protocol, int participants) {
  tests::MadeStudy study(tests::libraryProtocol(protocol));
  simulateCohorts(*study, study.clock, participants, 3, [](const auto&) {});
  auto section = gather(*study, RunMode::Simulated);
  paintFigures(section);
  return pagesOf(asPdf(asHtml({section}), "A study"));
}

TEST(PdfReport, AnswersOnAtMostThreePagesAndOnOneOfASingleParticipant) {
  struct Expected {
    const char* protocol;
    int participants;
    std::size_t pages;
  };
  for (const auto& [protocol, participants, most] :
       {Expected{"punch-counterbalanced", 1, 1},
        Expected{"reaming-hardness", 1, 1},
        Expected{"punch-face-validity", 12, 3},
        Expected{"reaming-hardness", 12, 3}}) {
    const auto pages = pagesOfStudy(protocol, participants);
    if (!pages) GTEST_SKIP() << "needs pdftotext: ./setup --check";
    const auto answering = pageOfAppendix(*pages);
    ASSERT_LT(answering, pages->size()) << protocol;
    EXPECT_LE(answering, most) << protocol << ", " << participants;
  }
}

TEST(PdfReport, DividesATableOnlyWithRowsOnEachSideAndKeepsItWithItsHeading) {
  std::set<int> rowsAtFirst;
  for (int paragraphs = 0; paragraphs < 60; ++paragraphs) {
    const auto pages = pagesOf(asPdf(pageAfter(paragraphs), "A study"));
    if (!pages) GTEST_SKIP() << "needs pdftotext: ./setup --check";
    const auto first = pageWith(*pages, "row10");
    ASSERT_LT(first, pages->size()) << paragraphs;
    const int rows = rowsOn((*pages)[first]);
    EXPECT_TRUE(rows == 12 || (rows >= 4 && rows <= 8)) << rows << " after " << paragraphs;
    EXPECT_EQ(pageWith(*pages, "Caption of it"), first) << paragraphs;
    EXPECT_EQ(pageWith(*pages, "Heading of it"), first) << paragraphs;
    for (std::size_t i = 0; i + 1 < pages->size(); ++i) {
      EXPECT_NE((*pages)[i].find_first_not_of(" \n0123456789"), std::string::npos)
          << "empty page " << i << " after " << paragraphs;
    }
    rowsAtFirst.insert(rows);
  }
  EXPECT_GT(rowsAtFirst.size(), 2U) << "or this test sees no table that is divided";
}

TEST(PdfReport, WrapsNoNameWhereThereIsRoom) {
  const std::string name = "Softest bone (2.29) vs. Softer bone (4.48)";
  const auto said = textOf(asPdf(
      "<html><head><style></style></head><body><table><caption>A caption that is longer than all "
      "cells of the table together, and so is widened by the names alone</caption><thead><tr>"
      "<th>Comparison</th><th>Difference</th><th>p</th></tr></thead><tbody><tr><td "
      "colspan=\"3\"><em>A cohort</em></td></tr><tr><td>" +
          name + "</td><td>-2.19</td><td>.003</td></tr></tbody></table></body></html>",
      "A study"));
  if (!said) GTEST_SKIP() << "needs pdftotext: ./setup --check";
  EXPECT_NE(said->find(name), std::string::npos) << *said;
}

TEST(PdfReport, HasPagesOfTheSizeThatIsAskedFor) {
  const std::string html = "<html><body><p>Nothing</p></body></html>";
  EXPECT_NE(asPdf(html, "A study", Paper::Letter).find("/MediaBox [0 0 612.0"), std::string::npos);
  EXPECT_NE(asPdf(html, "A study").find("/MediaBox [0 0 595.0"), std::string::npos);
}

TEST(PdfReport, BreaksNoWordInANarrowColumn) {
  auto section = tests::madeUpSection();
  section.words = words::wordsIn("de");
  const auto said = textOf(asPdf(asHtml({section}), "A study"));
  if (!said) GTEST_SKIP() << "needs pdftotext: ./setup --check";
  for (const auto* whole : {"Gruppe", "nommen", "schlossen", "gezogen", "Vorzeichentausch"}) {
    EXPECT_GE(timesIn(*said, whole), 1U) << whole;
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
       {&FamilyFigures::answers,
        &FamilyFigures::people,
        &FamilyFigures::effects,
        &FamilyFigures::positions}) {
    EXPECT_EQ(first.families.front().*part, second.families.front().*part);
  }
  EXPECT_EQ(first.timing, second.timing);
  EXPECT_EQ(first.votes, second.votes);
  EXPECT_EQ(first.felt, second.felt);
}

TEST(Figures, ArePaintedForAStudyWithoutAnswers) {
  auto section = tests::madeUpSection();
  for (auto& cohort : section.results.families.front().cohorts) {
    for (auto& condition : cohort.conditions) condition.answers = analysis::LikertCounts(1, 5);
    cohort.table.answers.clear();
    cohort.within = analysis::compareWithin(
        cohort.table, std::vector<analysis::DeclaredPair>{{"interpolation", "kalman"}}, {});
    cohort.position = analysis::positionEffect(cohort.table);
  }
  section.results.votes.front().votes = analysis::VoteCounts({"interpolation", "kalman"});
  section.curves.clear();
  paintFigures(section);
  const auto& family = section.figures.families.front();
  for (const auto& svg :
       {family.answers, family.people, family.effects, family.positions, section.figures.votes}) {
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_FALSE(textsIn(svg).empty());
  }
}

}  // namespace figures_test
}  // namespace study::report
