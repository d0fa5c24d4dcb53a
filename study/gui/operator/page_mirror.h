#pragma once

#include <string>

#include <QLabel>
#include <QPointer>
#include <QTimer>
#include <QWidget>

namespace study::gui {

/// A small window with a picture of what the participant sees, updated once a second while it is
/// open.
class PageMirror final : public QWidget {
  Q_OBJECT

 public:
  explicit PageMirror(QWidget* parent);

  /// Shows @p page, the window of @p participant; nullptr: nothing.
  void setPage(QWidget* page, const std::string& participant = {});

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void refreshPicture();

  QPointer<QWidget> page_;
  QLabel* picture_;
  QTimer timer_;
};

}  // namespace study::gui
