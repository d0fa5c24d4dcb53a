#include "study/gui/participant/side_by_side.h"

#include <algorithm>

#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

constexpr int kLeastWidthOfTwoColumns =
    1160;                          // [px] at scale 1: two columns of about 60 characters
constexpr int kBetweenParts = 40;  // [px] at scale 1, between the columns
constexpr int kBelowPart = 16;

}  // namespace

SideBySide::SideBySide(QWidget* first, QWidget* second, QWidget* parent)
    : QWidget(parent), parts_(new QBoxLayout(QBoxLayout::TopToBottom, this)) {
  parts_->setContentsMargins(0, 0, 0, 0);
  parts_->setSpacing(scaled(*this, kBelowPart));
  for (auto* part : {first, second}) {
    auto* column = new QWidget(this);
    // Ignores the preferred widths of the parts, so that both are equally wide.
    column->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* rows = new QVBoxLayout(column);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(part);
    rows->addStretch(1);
    parts_->addWidget(column);
  }
}

bool SideBySide::isSideBySide() const noexcept {
  return parts_->direction() == QBoxLayout::LeftToRight;
}

/// The minimum size with one part below the other. Two parts side by side would prevent the window
/// from being made narrower.
QSize SideBySide::minimumSizeHint() const {
  int width = 0;
  for (int i = 0; i < parts_->count(); ++i) {
    width = std::max(width, parts_->itemAt(i)->widget()->minimumSizeHint().width());
  }
  return {width, QWidget::minimumSizeHint().height()};
}

void SideBySide::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool isWide = width() >= scaled(*this, kLeastWidthOfTwoColumns);
  if (isWide == isSideBySide()) return;
  parts_->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  parts_->setSpacing(scaled(*this, isWide ? kBetweenParts : kBelowPart));
  for (int i = 0; i < parts_->count(); ++i) parts_->setStretch(i, isWide ? 1 : 0);
  parts_->activate();  // at once, before anything is painted
}

}  // namespace study::gui
