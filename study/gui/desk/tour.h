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
#include "study/gui/session/catalogue_translator.h"

namespace study::gui {
class TrialPage;
class LivePlot;
class TravelPlot;
}  // namespace study::gui

namespace study::gui {

/// A tour of three steps for new users: feel a virtual punch, see what a participant sees, see the
/// recorded data. Nothing is saved.
class Tour final : public QDialog {
  Q_OBJECT

 public:
  explicit Tour(QWidget* parent = nullptr);
  ~Tour() override;

  int step() const { return steps_->currentIndex(); }
  /// The record of the tour's trial; std::nullopt before the trial has ended.
  const std::optional<TrialRecord>& trialRecord() const noexcept { return trialRecord_; }

  /// Whether the tour has neither been seen nor dismissed on this computer.
  static bool isUnseen();

 public slots:
  void done(int result) override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeTrialDemonstration();
  QWidget* makeQuestions();
  QWidget* makeRecord();
  void goTo(int step);
  void begin();
  void showTrialState();
  void endTrial();
  void showRecord();
  void fitRecord();

  CatalogueTranslator translator_;  ///< of the participant's pages
  protocols::LoadedProtocol protocol_;
  VirtualPunch punch_;
  std::optional<TrialRecord> trialRecord_;
  QTimer watch_;
  QLabel* stepCount_;  ///< "Step 1 of 3"
  QLabel* heading_;
  QStackedWidget* steps_;
  TrialPage* trialPage_ = nullptr;
  LivePlot* plot_ = nullptr;
  TravelPlot* travelPlot_ = nullptr;
  QTableWidget* record_ = nullptr;
  QLabel* storedDataLabel_ = nullptr;
  QPushButton* back_;
  QPushButton* next_;
};

}  // namespace study::gui
