#include "study/report/pdf_report.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <QAbstractTextDocumentLayout>
#include <QImage>
#include <QRegularExpression>
#include <QString>
#include <QTextDocument>
#include <QTextTable>

#include "study/report/figures/figures.h"
#include "study/report/html_report.h"
#include "study/report/page_layout.h"
#include "study/report/print_html.h"
#include "tests/study/report/section.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"

namespace study::report {
namespace pdf_report_test {

TEST(PdfReport, HasPagesWithTheFiguresInThem) {
  auto section = tests::madeUpSection();
  paintFigures(section);
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
/// @param layout  the option of pdftotext: "-bbox" for each word with its place.
std::optional<std::string> textOf(const std::string& pdf, const char* layout = "-layout") {
  const tests::ScratchFolder folder;
  const auto file = folder.write("page.pdf", pdf);
  try {
    const auto finished = tests::run({"pdftotext", layout, file, "-"});
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

TEST(PdfReport, HasTheWordsOfFiguresAsText) {
  auto section = tests::madeUpSection();
  paintFigures(section);
  const auto said = textOf(asPdf(asHtml({section}), "A study"));
  if (!said) GTEST_SKIP() << "needs pdftotext: ./setup --check";
  for (const auto* drawn : {"force [N]", "Interpolation − FEM", "n = 36, M = 4.06"}) {
    EXPECT_GE(timesIn(*said, drawn), 1U) << drawn;
  }
  const auto alone = textOf(figureAsPdf(section.figures.renderedForce.front()));
  EXPECT_NE(alone.value_or("").find("force [N]"), std::string::npos);
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

/// The pages of a report on a shipped protocol with simulated participants, made by the release
/// program.
std::optional<std::vector<std::string>> pagesOfStudy(const char* protocol, int participants) {
  const tests::ScratchFolder folder;
  const std::string study = folder / "study";
  const std::string file = folder / "report.pdf";
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"study", "create", study, "--protocol", protocol, "--seed", "3"},
        {"study", "simulate", study, "--participants", std::to_string(participants)},
        {"report", study, "--run-mode", "simulated", "--out", file}}) {
    std::vector<std::string> words{tests::releaseProgram()};
    words.insert(words.end(), call.begin(), call.end());
    const auto finished = tests::run(words);
    EXPECT_EQ(finished.status, 0) << finished.error;
  }
  return pagesOf(tests::contentOf(file));
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
        Expected{"reaming-hardness", 12, 2}}) {
    const auto pages = pagesOfStudy(protocol, participants);
    if (!pages) GTEST_SKIP() << "needs pdftotext: ./setup --check";
    const auto answering = pageOfAppendix(*pages);
    ASSERT_LT(answering, pages->size()) << protocol;
    for (std::size_t i = 0; i + 1 < pages->size(); ++i) {  // the last one is what follows the end
      const auto number = std::to_string(i + 1) + " of " + std::to_string(pages->size() - 1);
      EXPECT_NE((*pages)[i].find(number), std::string::npos) << protocol << ", " << number;
      EXPECT_NE((*pages)[i].find("SIMULATED · "), std::string::npos) << protocol << ", " << number;
    }
    EXPECT_LE(answering, most) << protocol << ", " << participants;
    EXPECT_EQ(pageWith(*pages, "Figure 1."), 0U) << protocol << ", " << participants;
    const bool isOfOne = participants == 1;
    EXPECT_LE(
        pageWith(*pages, isOfOne ? "Limitations" : "What weakens the answer"), isOfOne ? 0U : 1U)
        << protocol << ", " << participants;
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
      EXPECT_NE((*pages)[i].find_first_not_of(" \nof0123456789"), std::string::npos)
          << "empty page " << i << " after " << paragraphs;
    }
    rowsAtFirst.insert(rows);
  }
  EXPECT_GT(rowsAtFirst.size(), 2U) << "or this test sees no table that is divided";
}

TEST(PdfReport, KeepsANoteOnThePageWhereItsTableEnds) {
  std::string table =
      "<table><caption>Caption</caption><thead><tr><th>Column</th></tr></thead><tbody>";
  for (int row = 10; row < 22; ++row) table += "<tr><td>row" + std::to_string(row) + "</td></tr>";
  table += "</tbody></table><p class=\"note\">noted</p>";
  std::set<std::size_t> pagesOfNote;
  for (int paragraphs = 20; paragraphs < 60; ++paragraphs) {
    std::string body;
    for (int i = 0; i < paragraphs; ++i) body += "<p>line</p>";
    const auto pages = pagesOf(
        asPdf("<html><head><style></style></head><body>" + body + table + "</body></html>", "A"));
    if (!pages) GTEST_SKIP() << "needs pdftotext: ./setup --check";
    EXPECT_EQ(pageWith(*pages, "noted"), pageWith(*pages, "row21")) << paragraphs;
    pagesOfNote.insert(pageWith(*pages, "noted"));
  }
  EXPECT_GT(pagesOfNote.size(), 1U) << "or no note comes near the end of a page";
}

TEST(PdfReport, KeepsAHeadingWithItsTextAndANoteWithTheListAboveIt) {
  const std::string end =
      "<h3>Headed</h3><dl class=\"flags\"><dt>Title</dt><dd><p>Explained</p></dd></dl>"
      "<ul><li>Listed</li></ul><p class=\"note\">Noted</p>";
  std::set<std::size_t> pagesOfEnd;
  for (int paragraphs = 20; paragraphs < 60; ++paragraphs) {
    std::string body;
    for (int i = 0; i < paragraphs; ++i) body += "<p>line</p>";
    const auto pages = pagesOf(
        asPdf("<html><head><style></style></head><body>" + body + end + "</body></html>", "A"));
    if (!pages) GTEST_SKIP() << "needs pdftotext: ./setup --check";
    EXPECT_EQ(pageWith(*pages, "Headed"), pageWith(*pages, "Explained")) << paragraphs;
    EXPECT_EQ(pageWith(*pages, "Listed"), pageWith(*pages, "Noted")) << paragraphs;
    pagesOfEnd.insert(pageWith(*pages, "Headed"));
  }
  EXPECT_GT(pagesOfEnd.size(), 1U) << "or nothing comes near the end of a page";
}

/// A word on a page, with the distance of its ends from the top of the paper [pt].
struct PrintedWord {
  std::string text;
  double top = 0.0;
  double bottom = 0.0;
};

/// The words of each page; std::nullopt if no tool can read them.
std::optional<std::vector<std::vector<PrintedWord>>> wordsOnPages(const std::string& pdf) {
  const auto text = textOf(pdf, "-bbox");
  if (!text) return std::nullopt;
  static const QRegularExpression kPageOrWord(QStringLiteral(
      "<page |<word xMin=\"[^\"]*\" yMin=\"([^\"]*)\" xMax=\"[^\"]*\" yMax=\"([^\"]*)\">([^<]*)<"));
  std::vector<std::vector<PrintedWord>> pages;
  auto found = kPageOrWord.globalMatch(QString::fromStdString(*text));
  while (found.hasNext()) {
    const auto match = found.next();
    if (match.capturedLength(1) == 0) {
      pages.emplace_back();
    } else {
      pages.back().push_back(
          {match.captured(3).toStdString(),
           match.captured(1).toDouble(),
           match.captured(2).toDouble()});
    }
  }
  return pages;
}

/// @p pages pages that begin with "begin" and end with a table, lower by 5 px on each, and what @p
/// follows.
std::string tablesAtTheEndOf(int pages, const std::string& follows) {
  std::string body;
  for (int i = 0; i < pages; ++i) {
    body += i == 0 ? "<h2>begin</h2>" : "<h2 class=\"appendix\">begin</h2>";
    body += "<p style=\"margin-top: " + std::to_string(745 + 5 * i) + "px\">gap</p>";
    body += "<table><caption>Caption</caption><thead><tr><th>Column</th></tr></thead><tbody>";
    for (int row = 0; row < 4; ++row) body += "<tr><td>row</td></tr>";
    body += "</tbody></table>" + follows;
  }
  return "<html><head><style></style></head><body>" + body + "</body></html>";
}

TEST(PdfReport, LeavesNoPageEmptyAndCutsNothingWhereverATableEnds) {
  const std::string figure =
      "<figure><svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 800 300\" width=\"800\" "
      "height=\"300\"><text x=\"10\" y=\"20\" font-size=\"20\">drawn</text></svg><figcaption>Words "
      "below</figcaption></figure>";
  for (const auto& follows :
       {figure,
        std::string("<p>after</p>"),
        std::string("<h3>Heading</h3><p>after</p>"),
        "<h3>Heading</h3>" + figure,
        std::string("<ul><li>after</li></ul>"),
        std::string("<table><caption>Second</caption><thead><tr><th>Column</th></tr></thead><tbody>"
                    "<tr><td>after</td></tr></tbody></table>")}) {
    constexpr int kPages = 18;
    const auto pages = wordsOnPages(asPdf(tablesAtTheEndOf(kPages, follows), "A study"));
    if (!pages) GTEST_SKIP() << "needs pdftotext: ./setup --check";
    int moved = 0;  // pages that "follows" moves to
    for (std::size_t i = 0; i < pages->size(); ++i) {
      const auto& words = (*pages)[i];
      ASSERT_GE(words.size(), 5U) << "page " << i + 1 << " is empty before " << follows;
      if (words.front().text != "begin") ++moved;
      for (const auto& word : words) {
        constexpr double kTop = 18.0 / 25.4 * 72.0;
        constexpr double kEnd = (297.0 - 14.0) / 25.4 * 72.0;
        EXPECT_GE(word.top, kTop - 1.0) << word.text << " on page " << i + 1 << " of " << follows;
        EXPECT_LE(word.bottom, kEnd + 1.0)
            << word.text << " on page " << i + 1 << " of " << follows;
      }
    }
    EXPECT_GT(moved, 3) << "or this test sees nothing that moves to the next page: " << follows;
    EXPECT_LE(moved, kPages);
  }
}

TEST(PdfReport, HasHeadingsWhoseSizeSaysTheirLevel) {
  const auto pages = wordsOnPages(asPdf(
      "<html><head><style></style></head><body><h1>first</h1><h2>second</h2><h3>third</h3>"
      "<h4>fourth</h4><p>text</p></body></html>",
      "A study"));
  if (!pages) GTEST_SKIP() << "needs pdftotext: ./setup --check";
  const auto& words = pages->front();
  for (std::size_t i = 0; i + 2 < 5; ++i) {
    EXPECT_GT(words[i].bottom - words[i].top, 1.1 * (words[i + 1].bottom - words[i + 1].top))
        << words[i].text;
  }
}

TEST(PdfReport, HasThreeRulesInATable) {
  const std::string table =
      "<table><caption>Caption</caption><thead><tr><th>Column</th></tr></thead><tbody><tr><td>row"
      "</td></tr><tr><td>row</td></tr></tbody></table>";
  QTextDocument document;
  const QImage paper(1, 1, QImage::Format_RGB32);
  document.documentLayout()->setPaintDevice(const_cast<QImage*>(&paper));
  document.setHtml(QString::fromStdString(
      toPrintHtml("<html><head><style></style></head><body>" + table + "</body></html>").html));
  document.setPageSize({500.0, 800.0});
  const auto* layout = document.documentLayout();
  const auto* drawn = qobject_cast<QTextTable*>(document.rootFrame()->childFrames().front());
  ASSERT_NE(drawn, nullptr);
  std::vector<double> middles;  // of the caption, the head and the rows
  for (int row = 0; row < drawn->rows(); ++row) {
    const auto cell = drawn->cellAt(row, 0);
    middles.push_back(layout->blockBoundingRect(cell.firstCursorPosition().block()).center().y());
    const auto format = cell.format().toTableCellFormat();
    EXPECT_EQ(format.topBorder() + format.bottomBorder(), 0.0) << "Qt would repeat it on each page";
  }
  ASSERT_EQ(middles.size(), 4U);
  const auto rules = rulesOf(document);
  ASSERT_EQ(rules.size(), 3U);
  EXPECT_GT(rules[0].line.y1(), middles[0]);
  EXPECT_LT(rules[0].line.y1(), middles[1]);
  EXPECT_GT(rules[1].line.y1(), middles[1]);
  EXPECT_LT(rules[1].line.y1(), middles[2]);
  EXPECT_GT(rules[2].line.y1(), middles[3]);
  EXPECT_GT(rules[0].thickness, rules[1].thickness);
  EXPECT_GT(rules[0].line.length(), 0.0);
}

TEST(PdfReport, HasNoLigaturesThatCannotBeSearched) {
  const std::string words = "section first affluent office Caption attach";
  const auto said = textOf(asPdf("<html><body><p>" + words + "</p></body></html>", "A study"));
  if (!said) GTEST_SKIP() << "needs pdftotext: ./setup --check";
  EXPECT_NE(said->find(words), std::string::npos) << *said;
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

}  // namespace pdf_report_test
}  // namespace study::report
