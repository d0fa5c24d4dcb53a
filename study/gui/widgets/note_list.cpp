#include "study/gui/widgets/note_list.h"

#include <QGridLayout>
#include <QLabel>

namespace study::gui {
namespace {

QLabel* markLabel(Mark mark, QWidget* parent) {
  static constexpr const char* kRoles[]{"mark-good", "mark-warn", "mark-bad", "quiet"};
  auto* label = quietLabel(mark == Mark::None ? QStringLiteral("–") : signOf(mark), parent);
  label->setProperty("role", QString::fromLatin1(kRoles[static_cast<std::size_t>(mark)]));
  label->setAlignment(Qt::AlignCenter);
  label->setWordWrap(false);
  return label;
}

}  // namespace

NoteList::NoteList(QWidget* parent) : QWidget(parent) {
  setProperty("role", QStringLiteral("plain"));
}

void NoteList::show(const std::vector<Note>& notes) {
  constexpr int kBetweenNotes = 8;  // [px]
  constexpr int kBesideMark = 10;
  text_.clear();
  qDeleteAll(findChildren<QLabel*>(Qt::FindDirectChildrenOnly));
  delete layout();
  auto* rows = new QGridLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setHorizontalSpacing(kBesideMark);
  rows->setVerticalSpacing(0);
  rows->setColumnStretch(1, 1);
  const bool isOne = notes.size() == 1 && notes.front().mark == Mark::None;
  int row = 0;
  const auto add = [&](const QString& words, QLabel* label) {
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    rows->addWidget(label, row++, 1);
    text_ += (text_.isEmpty() ? QString() : QStringLiteral("\n")) + words;
  };
  for (const auto& note : notes) {
    if (row > 0) rows->setRowMinimumHeight(row++, kBetweenNotes);
    if (!isOne) rows->addWidget(markLabel(note.mark, this), row, 0, Qt::AlignTop);
    const auto sign = signOf(note.mark);
    add(sign.isEmpty() ? note.text : sign + QStringLiteral("  ") + note.text,
        bodyLabel(note.text, this));
    for (const auto& detail : note.details) {
      add(QStringLiteral("      ") + detail, quietLabel(detail, this));
    }
  }
  // Labels that are made while the window is open are hidden until they are shown.
  for (auto* label : findChildren<QLabel*>(Qt::FindDirectChildrenOnly)) label->show();
  rows->activate();
  updateGeometry();
}

}  // namespace study::gui
