#include "study/gui/participant/blank_text.h"

#include "study/gui/participant/participant_window.h"

namespace study::gui {

QString withBlanksNamed(const QString& text) {
  QString named = text;
  return named.replace(
      QStringLiteral("]]"), ParticipantWindow::tr(": to be filled in") + QStringLiteral("]]"));
}

}  // namespace study::gui
