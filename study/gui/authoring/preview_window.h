#pragma once

#include <memory>

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QMainWindow>
#include <QScrollArea>

#include "protocols/model/loaded_protocol.h"
#include "study/gui/participant/participant_window.h"
#include "study/gui/session/catalogue_translator.h"
#include "study/gui/session/cut_key.h"
#include "study/gui/session/stop_key.h"

class QTemporaryDir;
class QVBoxLayout;

namespace study::gui {

/// Previews a participant's session: every page in any language and for any size of screen, with
/// scenes that can be felt with the mouse or the space bar. It begins with the participant's
/// screen; a screen that is too large for the window is shown smaller. The session runs in a new
/// study in a temporary folder, which is removed with the window, so nothing is kept.
class PreviewWindow final : public QMainWindow {
  Q_OBJECT

 public:
  explicit PreviewWindow(const protocols::LoadedProtocol& loaded, QWidget* parent = nullptr);
  ~PreviewWindow() override;

  /// Shows the page of a step, numbered from 0. The steps before it are answered by a simulated
  /// participant.
  void goTo(int step);

  const SessionController& controller() const;
  ParticipantWindow& page();
  QString folder() const;  ///< the temporary one

 protected:
  void resizeEvent(QResizeEvent* event) override;
  /// Fits the page when its place is resized.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct PreviewSession;
  void makeBar(QVBoxLayout& layout);
  void fillSteps();
  void showSession();
  void updateStep();
  void chooseLanguage();
  void fitPage();
  std::string language() const;

  protocols::LoadedProtocol loaded_;
  CatalogueTranslator translator_;
  StopKey stopKey_;
  CutKey cutKey_;
  QListWidget* steps_;
  QLabel* languagesLabel_ = nullptr;
  QComboBox* languages_;
  QComboBox* sizes_;
  QString blanks_;  ///< says how many blanks the texts have; empty: none
  QLabel* messageLabel_;
  QBoxLayout* bar_;
  QScrollArea* scroll_;
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<PreviewSession> previewSession_;
};

/// Opens a preview in a new window. Shows the error's message if that fails.
void openPreview(const protocols::LoadedProtocol& loaded, QWidget* parent);

}  // namespace study::gui
