#pragma once

#include <QPointer>
#include <QPushButton>

#include "study/gui/scene/cup_window.h"
#include "study/gui/session/session_controller.h"

namespace study::gui {

/// Why the operator of @p session may not see its bones in colours: they could tell the condition
/// where labels are drawn, so that the operator does not know it either. Empty where nothing keeps
/// them from it.
QString whyNoColours(const Session& session);

/// For the operator: opens a window with the bone in colours while a participant reams one that
/// they see. There is nothing of that window before, and it goes with the trial.
class CupButton final : public QPushButton {
  Q_OBJECT

 public:
  explicit CupButton(QWidget* parent = nullptr);
  ~CupButton() override;

  /// Nothing where no session is open. The controller outlives the next call.
  void follow(SessionController* controller);
  /// Whether there is something to see may have changed.
  void refresh();
  void closeWindow();

 private:
  /// Asks where a participant would see the window, too; No is what Enter says.
  bool mayShow();
  void openWindow();
  scene::CupWindow::Present present() const;

  SessionController* controller_ = nullptr;
  bool isAllowed_ = false;
  QPointer<scene::CupWindow> window_;
};

}  // namespace study::gui
