#pragma once

#include <QPointer>
#include <QPushButton>

#include "study/gui/scene/bone_colours_window.h"
#include "study/gui/session/session_controller.h"

namespace study::gui {

/// Why the operator of @p session may not see the bone in colours: in a double-blind session the
/// colours could reveal the condition. Empty if the operator may see them.
QString reasonForNoColours(const Session& session);

/// Opens a window that shows the operator the bone in colours while a participant reams a bone on
/// the screen. The window is created on the click and closes when the trial ends.
class BoneColoursButton final : public QPushButton {
  Q_OBJECT

 public:
  explicit BoneColoursButton(QWidget* parent = nullptr);
  ~BoneColoursButton() override;

  /// Shows @p controller's trials; nullptr: no session is open. The controller must live until the
  /// next call.
  void setController(SessionController* controller);
  /// Enables the button if there is a bone to show now; otherwise disables it and closes the
  /// window.
  void refresh();
  void closeWindow();

 private:
  /// Asks for confirmation if the participant would see the window, too. Enter means No.
  bool confirmOpening();
  void openWindow();
  scene::BoneColoursWindow::FollowedTrial present() const;

  SessionController* controller_ = nullptr;
  bool isAllowed_ = false;
  QPointer<scene::BoneColoursWindow> window_;
};

}  // namespace study::gui
