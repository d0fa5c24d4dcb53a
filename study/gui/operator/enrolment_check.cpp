#include "study/gui/operator/enrolment_check.h"

#include <algorithm>

#include <QStringList>

#include "protocols/model/loaded_protocol.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/message_box.h"
#include "study/session/backup.h"

namespace study::gui {
namespace {

/// What is not filled in, one line each: the titles of blanks, as in the form that fills them in.
QStringList openBlanksIn(const protocols::LoadedProtocol& protocol) {
  QStringList lines;
  for (const auto& blank : protocols::blanksOf(protocol)) {
    if (blank.text.isEmpty()) lines << deskText(blank.title);
  }
  if (!lines.isEmpty()) return lines;
  for (const auto& place : protocols::unfilledPlaceholdersIn(protocol)) {
    lines << QString::fromStdString(place.where + ": " + place.words);
  }
  return lines;
}

/// The first lines, as a list.
QString listOf(const QStringList& lines) {
  constexpr int kMost = 6;
  QString list;
  for (const auto& line : lines.first(std::min<qsizetype>(lines.size(), kMost))) {
    list += QStringLiteral("•  ") + line + u'\n';
  }
  if (lines.size() > kMost) {
    list += QString::fromStdString(translated("and {} more", lines.size() - kMost));
  }
  return list.trimmed();
}

}  // namespace

bool confirmTexts(
    const protocols::LoadedProtocol& protocol, const Enrolment& enrolment, QWidget* parent) {
  const auto blanks = openBlanksIn(protocol);
  if (blanks.isEmpty()) return true;
  const QStringList count{QString::number(blanks.size())};
  if (enrolment.runMode == RunMode::Pilot) {
    return ask(parent, MessageTopic::PilotSessionHasBlanks, count, listOf(blanks));
  }
  showMessage(parent, MessageTopic::LiveSessionHasBlanks, count, listOf(blanks));
  return false;
}

bool confirmNewestCopy(Study& study, const Enrolment& enrolment, QWidget* parent) {
  if (enrolment.runMode != RunMode::Live || headsMissingIn(study) == 0) return true;
  return ask(parent, MessageTopic::LiveSessionInOlderCopy);
}

}  // namespace study::gui
