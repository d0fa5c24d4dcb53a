#pragma once

#include <QString>
#include <QWidget>

namespace study::gui {

/// The last page of a completed session: thanks, the debrief, and what happens now.
class ThanksPage final : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString title;
    QString now;      ///< what the participant does now
    QString debrief;  ///< Markdown; may be empty
    QString saved;    ///< under which code
    QString contact;  ///< for questions; may be empty
  };

  explicit ThanksPage(const Content& content, QWidget* parent = nullptr);
};

}  // namespace study::gui
