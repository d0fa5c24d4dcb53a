#pragma once

#include <QString>
#include <QWidget>

namespace study::gui {

/// The last page of a completed session: thanks, the participant's code, the debrief, and what
/// happens now.
class ThanksPage final : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString title;
    QString now;  ///< what the participant does now
    bool isCompleted = true;
    QString code;     ///< under which the data are saved
    QString debrief;  ///< Markdown; may be empty
    QString contact;  ///< for questions; may be empty
  };

  explicit ThanksPage(const Content& content, QWidget* parent = nullptr);

 private:
  QWidget* makeCode(const Content& content);
  QWidget* makeDebrief(const Content& content);
};

}  // namespace study::gui
