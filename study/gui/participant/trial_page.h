#pragma once

#include <string>

#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "haptics/devices/device_kind.h"

namespace study::gui {

/// A calm page while something is felt: which alternative, how many cuts of how many, nothing else.
///
/// Without a device the page is the handle: whoever holds the space bar closes it, whoever drags on
/// the page closes it as far as they drag.
class TrialPage final : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString name;  ///< "Alternative 2"
    int minimumCuts = 3;
    bool isOffered = false;                      ///< once more, to whoever wants to
    const haptics::devices::DeviceKind* device;  ///< whose words are shown
    std::string language = "en";
  };

  /// @param picture  of what is felt, which the page takes in; nothing where it is not seen.
  TrialPage(const Content& content, QWidget* picture, QWidget* parent = nullptr);

  /// The trial has begun, or not yet.
  void setRunning(bool isRunning);
  void setCuts(int cuts);

 signals:
  void beginRequested();
  void enoughRequested();
  /// It is not wanted once more.
  void declined();
  /// Where the hand means to be, from 0 (open) to 1 (closed).
  void handMoved(double share);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;

 private:
  QString cutsInWords(int cuts) const;

  Content content_;
  QLabel* count_;
  QLabel* hint_;
  QPushButton* begin_;
  QPushButton* enough_;
  QPushButton* decline_;
  bool isRunning_ = false;
  double pressedAt_ = 0.0;
};

}  // namespace study::gui
