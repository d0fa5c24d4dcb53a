#pragma once

#include <QBoxLayout>
#include <QWidget>

namespace study::gui {

/// Two parts of a page: side by side, equally wide, where there is room for two columns of text,
/// and else one below the other.
class SideBySide final : public QWidget {
  Q_OBJECT

 public:
  /// Takes ownership of both.
  SideBySide(QWidget* first, QWidget* second, QWidget* parent = nullptr);

  bool isSideBySide() const noexcept;

  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QBoxLayout* parts_;
};

}  // namespace study::gui
