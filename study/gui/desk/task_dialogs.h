#pragma once

#include <string>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSpinBox>

#include "study/gui/authoring/checked_protocol.h"
#include "study/gui/desk/study_summary.h"
#include "study/gui/desk/work_dialog.h"
#include "study/gui/widgets/path_field.h"

namespace study::gui {

/// Amends the protocol of a study with a protocol file, which is checked when it is chosen.
class AmendDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit AmendDialog(const StudySummary& study, QWidget* parent = nullptr);

 signals:
  void amended();

 protected:
  void work() override;

 private:
  void check();
  void updateButton();

  std::string folder_;
  bool hasBegun_ = false;  ///< a live session has begun: a change needs a reason
  CheckedProtocol checked_;
  PathField* file_;
  QLineEdit* reason_;
};

/// Adds simulated participants to a study, as `palpate study simulate` does.
class SimulateDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit SimulateDialog(const StudySummary& study, QWidget* parent = nullptr);

 signals:
  void simulated();

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
};

/// Shows the tables of a study, as `palpate stats run` prints them.
class StatisticsDialog final : public WorkDialog {
  Q_OBJECT

 public:
  explicit StatisticsDialog(const StudySummary& study, QWidget* parent = nullptr);

 protected:
  void work() override;

 private:
  void updateChoices();

  std::string folder_;
  QComboBox* mode_;
  QComboBox* profile_;
  QLineEdit* reason_;
};

}  // namespace study::gui
