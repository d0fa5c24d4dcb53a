#include "study/gui/operator/page_mirror.h"

#include <QVBoxLayout>

#include "study/gui/widgets/labels.h"

namespace study::gui {
namespace {

constexpr int kPictureInterval = 1000;  // [ms]

}  // namespace

PageMirror::PageMirror(QWidget* parent)
    : QWidget(parent, Qt::Tool), picture_(new QLabel(this)), heading_(bodyLabel({}, this)) {
  setWindowTitle(tr("Participant's page"));
  setObjectName(QStringLiteral("mirror"));
  setAttribute(Qt::WA_ShowWithoutActivating);
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  picture_->setAccessibleName(windowTitle());
  auto* layout = withMargins<QVBoxLayout>(this, {8, 6, 8, 8});
  heading_->setProperty("role", QStringLiteral("section"));
  layout->addWidget(heading_);
  layout->addWidget(picture_, 1);
  setPage(nullptr);
  resize(640, 440);
  connect(&timer_, &QTimer::timeout, this, &PageMirror::refreshPicture);
}

void PageMirror::setPage(QWidget* page, const std::string& participant) {
  page_ = page;
  const auto what = tr("Participant's screen (view only)");
  heading_->setText(
      page == nullptr ? what : QString::fromStdString(participant) + QStringLiteral(" · ") + what);
  refreshPicture();
}

void PageMirror::refreshPicture() {
  if (!isVisible()) return;
  if (page_ == nullptr) return picture_->setText(tr("No session is open."));
  picture_->setPixmap(
      page_->grab().scaled(picture_->size(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

void PageMirror::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  timer_.start(kPictureInterval);
  refreshPicture();
}

void PageMirror::hideEvent(QHideEvent* event) {
  timer_.stop();
  QWidget::hideEvent(event);
}

}  // namespace study::gui
