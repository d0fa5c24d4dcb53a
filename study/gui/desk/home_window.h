#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QMainWindow>
#include <QTableWidget>

#include "study/gui/desk/study_panel.h"
#include "study/gui/operator/operator_window.h"

namespace study::gui {

/// The first window: the studies of this computer, a new one, and everything that is done with one
/// besides running it. Opens the operator's window, and is there again when that is closed.
class HomeWindow final : public QMainWindow {
  Q_OBJECT

 public:
  /// @param deviceFile  of the laboratory; empty: each study's own, or virtual instruments.
  explicit HomeWindow(std::string deviceFile = {}, QWidget* parent = nullptr);
  ~HomeWindow() override;

  /// Looks at all studies again.
  void refresh();
  /// Chooses a study of the list, and puts it there first if it is new.
  void choose(const QString& folder);
  /// The operator's window; nothing where no study is open.
  OperatorWindow* operatorWindow() const noexcept;

 public slots:
  /// Opens the operator's window of a study, and goes on with a session where one is given.
  void openStudy(const QString& folder, std::optional<SessionId> session = std::nullopt);
  void makeStudy();
  void chooseFolder();
  void readProtocol(const QString& source);
  void showTour();
  void testComputer();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct OpenStudy;
  QWidget* makeList();
  void makeMenus();
  void connectPanel();
  void fillRow(int row);
  const StudySummary* chosen() const;
  void showChosen();
  void closeStudy();
  void forgetChosen();
  void askForProtocol();
  template <typename Dialog>
  void openDialog();  ///< about the chosen study
  template <typename Dialog>
  void openTool();  ///< about none

  std::string deviceFile_;
  std::vector<StudySummary> studies_;  ///< as in the list
  QTableWidget* list_;
  StudyPanel* panel_;
  std::unique_ptr<OpenStudy> open_;
};

}  // namespace study::gui
