#include "study/gui/operator/enrolment_check.h"

#include <algorithm>

#include <QStringList>

#include "protocols/model/loaded_protocol.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/message_box.h"

namespace study::gui {
namespace {

/// The first blanks, one line each.
QString listOf(const std::vector<protocols::Placeholder>& blanks) {
  constexpr std::size_t kMost = 6;
  QStringList lines;
  for (std::size_t i = 0; i < std::min(blanks.size(), kMost); ++i) {
    lines << QStringLiteral("•  ") +
                 QString::fromStdString(blanks[i].where + ": " + blanks[i].words);
  }
  if (blanks.size() > kMost) {
    lines << QString::fromStdString(translated("and {} more", blanks.size() - kMost));
  }
  return lines.join(u'\n');
}

}  // namespace

bool confirmTexts(
    const protocols::LoadedProtocol& protocol, const Enrolment& enrolment, QWidget* parent) {
  const auto blanks = protocols::unfilledPlaceholdersIn(protocol);
  if (blanks.empty()) return true;
  const QStringList count{QString::number(blanks.size())};
  if (enrolment.runMode == RunMode::Pilot) {
    return ask(parent, MessageTopic::PilotSessionHasBlanks, count, listOf(blanks));
  }
  showMessage(parent, MessageTopic::LiveSessionHasBlanks, count, listOf(blanks));
  return false;
}

}  // namespace study::gui
