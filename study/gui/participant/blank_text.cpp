#include "study/gui/participant/blank_text.h"

#include <QRegularExpression>

#include "study/gui/participant/participant_window.h"

namespace study::gui {

QString withBlanksNamed(const QString& text) {
  QString named = text;
  return named.replace(
      QStringLiteral("]]"), ParticipantWindow::tr(": to be filled in") + QStringLiteral("]]"));
}

QString withUnbrokenNumbers(const QString& text) {
  // A number at the start of a line is one of a list in Markdown.
  static const QRegularExpression kBeforeWord(
      QStringLiteral("([^\\n\\d.]\\d{1,4}\\.?) (?=\\p{L})"));
  static const QRegularExpression kBeforeYear(QStringLiteral("(\\p{L}) (?=\\d{4}\\b)"));
  static const QRegularExpression kAfterTitle(QStringLiteral("\\b((?:Dr|Prof)\\.?) (?=\\p{Lu})"));
  static const QRegularExpression kInName(
      QStringLiteral("\\b((?:Dr|Prof)\\.?\\x{00A0}\\p{Lu}[\\p{L}.-]*) (?=\\p{Lu})"));
  const auto bound = QStringLiteral("\\1") + QChar(QChar::Nbsp);
  QString whole = text;
  for (const auto& torn : {kBeforeWord, kBeforeYear, kAfterTitle, kInName}) {
    whole.replace(torn, bound);
  }
  return whole;
}

}  // namespace study::gui
