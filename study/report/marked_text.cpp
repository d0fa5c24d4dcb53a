#include "study/report/marked_text.h"

#include <QRegularExpression>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextList>

namespace study::report {
namespace {

constexpr auto kCommonMarkWithoutHtml =
    QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectCommonMark) |
    QTextDocument::MarkdownNoHTML;

/// Whether @p line begins a Markdown block: a heading, or an entry of a list.
bool beginsBlock(const QString& line) {
  static const QRegularExpression kBeginning(QStringLiteral("^\\s*([-*+]\\s|\\d+[.)]\\s|#)"));
  return kBeginning.match(line).hasMatch();
}

/// Replaces line breaks within paragraphs by line separators, which Markdown keeps.
QString withKeptBreaks(const QString& text) {
  const auto lines = text.split(u'\n');
  QString kept = lines.front();
  for (qsizetype i = 1; i < lines.size(); ++i) {
    const bool isWithin = !lines[i].isEmpty() && !lines[i - 1].isEmpty() &&
                          !beginsBlock(lines[i]) && !lines[i - 1].startsWith(u'#');
    kept += (isWithin ? QChar(QChar::LineSeparator) : QChar(u'\n')) + lines[i];
  }
  return kept;
}

QString htmlOf(const QTextFragment& fragment) {
  const auto format = fragment.charFormat();
  if (format.isImageFormat()) return {};
  QString words = fragment.text().toHtmlEscaped();
  words.replace(QChar::LineSeparator, QStringLiteral("<br/>"));
  const bool isBold = format.fontWeight() > QFont::Normal;
  if (format.fontItalic()) words = QStringLiteral("<i>%1</i>").arg(words);
  return isBold ? QStringLiteral("<b>%1</b>").arg(words) : words;
}

QString wordsOf(const QTextBlock& block) {
  QString words;
  for (auto at = block.begin(); !at.atEnd(); ++at) words += htmlOf(at.fragment());
  return words;
}

QString tagOf(const QTextList& list) {
  const bool isNumbered = list.format().style() == QTextListFormat::ListDecimal;
  return isNumbered ? QStringLiteral("ol") : QStringLiteral("ul");
}

QString htmlOf(const QTextBlock& block) {
  const QString words = wordsOf(block);
  if (words.isEmpty()) return {};
  const int level = block.blockFormat().headingLevel();
  if (level > 0) {
    return QStringLiteral("<h%1>%2</h%1>\n")
        .arg(level > 1 ? 3 : 2)
        .arg(block.text().toHtmlEscaped());
  }
  const auto* list = block.textList();
  if (list == nullptr) return QStringLiteral("<p>%1</p>\n").arg(words);
  QString item = QStringLiteral("<li>%1</li>\n").arg(words);
  if (list->itemNumber(block) == 0) item.prepend(QStringLiteral("<%1>").arg(tagOf(*list)));
  if (list->itemNumber(block) == list->count() - 1) {
    item.append(QStringLiteral("</%1>\n").arg(tagOf(*list)));
  }
  return item;
}

}  // namespace

QString asHtml(const QString& markdown) {
  QTextDocument document;
  document.setMarkdown(withKeptBreaks(markdown), kCommonMarkWithoutHtml);
  QString html;
  for (auto block = document.begin(); block.isValid(); block = block.next()) html += htmlOf(block);
  return html;
}

}  // namespace study::report
