#pragma once

#include <QStringList>
#include <QWidget>

namespace study::gui {

/// The last page of a completed session: thanks, the debrief, and what happens now.
class ThanksPage final : public QWidget {
  Q_OBJECT

 public:
  /// @param debrief  Markdown; may be empty. @param now  what happens now, one text per line.
  ThanksPage(
      const QString& title,
      const QString& debrief,
      const QStringList& now,
      QWidget* parent = nullptr);
};

}  // namespace study::gui
