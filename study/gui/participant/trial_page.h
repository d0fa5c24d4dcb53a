#pragma once

#include <array>
#include <string>

#include <QLabel>
#include <QPushButton>
#include <QVariantAnimation>
#include <QWidget>

#include "haptics/devices/device_kind.h"

namespace study::gui {

class CutCounter;
class Stage;

/// The participant's page during a trial. It shows only the alternative's name and the number of
/// cuts made and required.
///
/// With a virtual device the page moves the handle: holding the space bar closes it in 1.2 s, about
/// as long as a cut of the published recordings takes, and dragging closes it in proportion to the
/// distance.
class TrialPage final : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString name;   ///< the alternative's label: "Alternative 2"
    QString title;  ///< the label, and of how many: "Alternative 2 of 3"
    int minimumCuts = 3;
    bool isOptionalTrial = false;  ///< an optional further trial, which may be declined
    bool reusesLabels = false;     ///< an earlier block had an alternative of this name
    const haptics::devices::DeviceKind* device;  ///< whose words for strokes are shown
    std::string language = "en";
    bool isByFeelAlone = false;  ///< without a picture, which another round has
  };

  /// @param picture  a view of the simulation, of which the page takes ownership; nullptr: no view.
  TrialPage(const Content& content, QWidget* picture, QWidget* parent = nullptr);

  /// Switches between the running trial and the offer to begin it.
  /// @param isVirtual  whether this page moves the instrument, and says how.
  void setRunning(bool isRunning, bool isVirtual = true);
  void setCuts(int cuts);

 signals:
  void beginRequested();
  void finishRequested();
  /// The participant declined the optional trial.
  void declined();
  /// The key that switches the reamer on or off was pressed: R, or a foot switch that types it.
  void reamerSwitched();
  /// The wanted hand position, from 0 (open) to 1 (closed).
  void handMoved(double share);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;

 private:
  void addWords(bool hasPicture);
  QString howTo() const;
  void moveHandTo(double share, int duration);

  Content content_;
  Stage* stage_;
  CutCounter* cutCounter_;
  QLabel* numberingHint_;  ///< says that numbers start again, where they do
  QLabel* takeHint_;       ///< the first step: to take the instrument
  QLabel* strokeHint_;     ///< the second one
  QLabel* doneHint_;       ///< the third one
  std::array<QLabel*, 3> stepNumbers_;
  QLabel* pointerHint_;  ///< how this page moves a virtual instrument
  QPushButton* beginButton_;
  QPushButton* doneButton_;
  QPushButton* declineButton_;
  bool isRunning_ = false;
  double pressedAt_ = 0.0;
  QVariantAnimation hand_;  ///< the position of the handle that the space bar moves
};

}  // namespace study::gui
