#pragma once

#include <QLabel>
#include <QTreeWidget>
#include <QWidget>

#include "protocols/model/loaded_protocol.h"
#include "study/gui/authoring/timeline_bar.h"

namespace study::gui {

/// The phases and steps of a session, with the minutes that `palpate plan` estimates for each.
class TimelinePage final : public QWidget {
  Q_OBJECT

 public:
  explicit TimelinePage(QWidget* parent = nullptr);

  void show(const protocols::LoadedProtocol& loaded);
  using QWidget::show;
  void clear();

 signals:
  /// A phase was selected: its index, from 0.
  void phaseChosen(int phase);

 private:
  TimelineBar* bar_;
  QLabel* total_;
  QTreeWidget* steps_;
};

}  // namespace study::gui
