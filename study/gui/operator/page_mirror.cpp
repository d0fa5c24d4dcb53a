#include "study/gui/operator/page_mirror.h"

#include <QVBoxLayout>

#include "study/gui/widgets/labels.h"

namespace study::gui {
namespace {

constexpr int kPictureInterval = 1000;  // [ms]

}  // namespace

PageMirror::PageMirror(QWidget* parent) : QWidget(parent, Qt::Tool), picture_(new QLabel(this)) {
  setObjectName(QStringLiteral("mirror"));
  setAttribute(Qt::WA_ShowWithoutActivating);
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  picture_->setAccessibleName(tr("Participant's page"));
  withoutMargins<QVBoxLayout>(this)->addWidget(picture_);
  setPage(nullptr);
  connect(&timer_, &QTimer::timeout, this, &PageMirror::refreshPicture);
}

void PageMirror::setPage(QWidget* page, const std::string& participant) {
  page_ = page;
  const auto what = tr("Participant's screen (view only)");
  setWindowTitle(
      page == nullptr ? what : QString::fromStdString(participant) + QStringLiteral(" · ") + what);
  refreshPicture();
}

void PageMirror::refreshPicture() {
  if (!isVisible()) return;
  if (page_ == nullptr) return picture_->setText(tr("No session is open."));
  picture_->setPixmap(
      page_->grab().scaled(picture_->size(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

/// As wide and high as the page, so that its words are as large as they can be.
void PageMirror::showEvent(QShowEvent* event) {
  constexpr QSize kMost(860, 760);
  constexpr QSize kEmpty(640, 360);
  if (!event->spontaneous()) {
    resize(
        page_ == nullptr
            ? kEmpty
            : page_->size().scaled(kMost.boundedTo(page_->size()), Qt::KeepAspectRatio));
  }
  QWidget::showEvent(event);
  timer_.start(kPictureInterval);
  refreshPicture();
}

void PageMirror::hideEvent(QHideEvent* event) {
  timer_.stop();
  QWidget::hideEvent(event);
}

}  // namespace study::gui
