#pragma once

#include <optional>
#include <string>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSpinBox>

#include "study/gui/authoring/checked_protocol.h"
#include "study/gui/authoring/file_watch.h"
#include "study/gui/desk/study_summary.h"
#include "study/gui/desk/work_dialog.h"
#include "study/gui/widgets/path_field.h"
#include "study/gui/widgets/result_view.h"
#include "study/report/report_section.h"

namespace study::gui {

/// Amends the protocol of a study with a protocol file, which is checked when it is chosen and
/// again whenever it changes.
class AmendDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit AmendDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  void check();
  void updateButton();
  /// What the chosen protocol changes in the meaning of answers that were given so far.
  std::vector<Note> changesInMeaning();
  void savePresentProtocol();

  std::string folder_;
  std::optional<protocols::LoadedProtocol> present_;  ///< the study's; std::nullopt: not readable
  CheckedProtocol checked_;
  FileWatch watch_;
  bool isDone_ = false;  ///< with the file as it is: nothing is left to be changed
  PathField* file_;
};

/// Adds simulated participants to a study, as `palpate study simulate` does.
class SimulateDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit SimulateDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  std::string folder_;
  QSpinBox* participants_;
};

/// Shows what a study can find and how long it takes, as `palpate plan` does: balanced orders,
/// sample sizes, power. It reads the protocol only.
class PlanDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit PlanDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  std::string folder_;
  QSpinBox* participants_;
  QDoubleSpinBox* effect_;
  QDoubleSpinBox* power_;
  ResultView* result_;
};

/// Shows what a study found: the answer as the report says it, then the tables of `palpate stats
/// run`, of which those of the declared tests come first.
class StatisticsDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit StatisticsDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  void updateChoices();
  void showResults();

  std::string folder_;
  std::optional<report::ReportSection> section_;  ///< what is shown
  QComboBox* mode_;
  QComboBox* profile_;
  ResultView* result_;
};

}  // namespace study::gui
