#pragma once

#include <memory>
#include <optional>

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableWidget>
#include <QTimer>

#include "protocols/model/loaded_protocol.h"
#include "study/gui/desk/virtual_punch.h"

namespace study::gui {
class TrialPage;
class LivePlot;
}  // namespace study::gui

namespace study::gui {

/// Three steps for whoever opens the studio for the first time: feel a punch that is not there, see
/// what a participant sees, see what is kept. Nothing of it is written anywhere.
class Tour final : public QDialog {
  Q_OBJECT

 public:
  explicit Tour(QWidget* parent = nullptr);
  ~Tour() override;

  int step() const { return steps_->currentIndex(); }
  /// What was felt; nothing before.
  const std::optional<TrialRecord>& felt() const noexcept { return felt_; }

  /// Whether nobody has seen it on this computer, or closed it.
  static bool isNew();

 public slots:
  void done(int result) override;

 private:
  QWidget* makeFeeling();
  QWidget* makeQuestions();
  QWidget* makeRecord();
  void goTo(int step);
  void begin();
  void look();
  void endFeeling();
  void showRecord();

  protocols::LoadedProtocol protocol_;
  VirtualPunch punch_;
  std::optional<TrialRecord> felt_;
  QTimer watch_;
  QLabel* heading_;
  QStackedWidget* steps_;
  TrialPage* page_ = nullptr;
  LivePlot* plot_ = nullptr;
  QTableWidget* record_ = nullptr;
  QLabel* kept_ = nullptr;
  QPushButton* back_;
  QPushButton* next_;
};

}  // namespace study::gui
