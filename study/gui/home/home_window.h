#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QAction>
#include <QBoxLayout>
#include <QMainWindow>
#include <QTimer>

#include "protocols/model/loaded_protocol.h"
#include "study/gui/home/study_list.h"
#include "study/gui/home/study_panel.h"
#include "study/gui/home/welcome.h"
#include "study/gui/operator/operator_window.h"

namespace study::gui {

/// The first window: the list of this computer's studies, a button for a new one, and every task
/// apart from running sessions; a welcome if there is no study. It hides while the operator's
/// window is open and returns afterwards.
class HomeWindow final : public QMainWindow {
  Q_OBJECT

 public:
  /// @param deviceFile  the laboratory's device file; empty: each study's own, or virtual devices.
  explicit HomeWindow(std::string deviceFile = {}, QWidget* parent = nullptr);
  ~HomeWindow() override;

  /// Reads the summaries of all studies again.
  void refresh();
  /// Selects a study in the list. A new one is added at the top.
  void choose(const QString& folder);
  /// The operator's window; nullptr if no study is open.
  OperatorWindow* operatorWindow() const noexcept;

 public slots:
  /// Opens a study in the operator's window and resumes @p session if one is given.
  void openStudy(const QString& folder, std::optional<SessionId> session = std::nullopt);
  void makeStudy();
  void chooseFolder();
  /// @param shown  the protocol with texts that are not in the file yet; nullptr: none
  void openProtocolWindow(const QString& source, const protocols::LoadedProtocol* shown = nullptr);
  void showTour();
  void testComputer();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct OpenStudy;
  /// Makes everything that the window shows, in the language of the desk.
  void makeContents();
  /// Arranges the list and the study side by side, or one above the other in a narrow window.
  void arrange();
  QWidget* makeList();
  QWidget* makeTools(QWidget* parent);
  void makeMenus();
  void connectPanel();
  void connectWelcome();
  void fillRow(int row);
  const StudySummary* chosen() const;
  /// Selects a study in the list; the first one if it is not there.
  void select(const QString& folder);
  void showChosen();
  void read(int row);
  void loadNextVisibleSummary();
  void lookElsewhere();
  void closeStudy();
  void removeSelectedFromList();
  void askForProtocol();
  /// Opens the form for the blanks of the selected study, and amends its protocol.
  void fillInTexts();
  void previewChosen();
  template <typename Dialog>
  void openDialog();  ///< a dialog about the selected study
  template <typename Dialog>
  void openTool();  ///< a dialog that needs no study

  std::string deviceFile_;
  /// A study of the list. Its database is read when its row first becomes visible.
  struct Row {
    StudySummary summary;
    QString opened;  ///< when last, local time
    bool isRead = false;
  };
  std::vector<Row> studies_;  ///< in the order of the list
  QAction* removeAction_ = nullptr;
  QTimer lookTimer_;      ///< looks whether sessions are still open elsewhere
  QTimer readTimer_;      ///< reads the next visible row that was not read yet
  std::string language_;  ///< of the present contents
  QBoxLayout* columns_ = nullptr;
  QWidget* listColumn_ = nullptr;  ///< the list, with what needs no chosen study
  StudyList* list_ = nullptr;
  StudyPanel* panel_ = nullptr;
  Welcome* welcome_ = nullptr;  ///< in place of both where there are no studies
  std::unique_ptr<OpenStudy> openStudy_;
};

}  // namespace study::gui
