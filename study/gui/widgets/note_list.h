#pragma once

#include <vector>

#include <QString>
#include <QStringList>
#include <QWidget>

#include "study/gui/widgets/labels.h"

namespace study::gui {

/// A sentence with its mark, and below it its details, in quieter text.
struct Note {
  QString text;
  Mark mark = Mark::None;
  QStringList details{};
};

/// Notes, one below the other. It is as high as its texts, and is scrolled by the page that it is
/// on.
class NoteList final : public QWidget {
  Q_OBJECT

 public:
  explicit NoteList(QWidget* parent);

  void show(const std::vector<Note>& notes);
  using QWidget::show;

  /// All of it, each note on a line after its sign.
  QString text() const { return text_; }

 private:
  QString text_;
};

}  // namespace study::gui
