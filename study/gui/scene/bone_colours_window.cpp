#include "study/gui/scene/bone_colours_window.h"

#include <utility>

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "study/gui/widgets/labels.h"

namespace study::gui::scene {
namespace {

constexpr int kUpdateInterval = 67;      // [ms]
constexpr double kDepthOutside = -0.02;  // depth of the reamer without a trial [m]

}  // namespace

BoneColoursWindow::BoneColoursWindow(
    const haptics::engine::PackingSpec& spec, Trial trial, QWidget* parent)
    : QWidget(parent, Qt::Window),
      trial_(std::move(trial)),
      colours_(new QComboBox(this)),
      picture_(new QLabel(this)),
      legend_(new ColourLegend(this)) {
  setAttribute(Qt::WA_DeleteOnClose);
  setObjectName(QStringLiteral("cup-window"));
  setWindowTitle(tr("The bone in colours"));
  colours_->addItem(tr("how hard the bone is"), static_cast<int>(SphereColours::Density));
  colours_->addItem(tr("what has been removed"), static_cast<int>(SphereColours::Removal));
  colours_->addItem(
      tr("nothing, as participants see it"), static_cast<int>(SphereColours::Neutral));
  colours_->setAccessibleName(tr("What the colour shows"));
  picture_->setMinimumSize(320, 210);
  picture_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setAccessibleName(tr("The bone, cut open along the reamer's axis"));
  picture_->setText(tr("The bone is being drawn…"));

  auto* layout = new QVBoxLayout(this);
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Colour shows"), this));
  row->addWidget(colours_);
  row->addStretch(1);
  layout->addLayout(row);
  layout->addWidget(picture_, 1);
  layout->addWidget(legend_);
  auto* reading = quietLabel(tr("White: the reamer. The bone is cut open along its axis."), this);
  reading->setWordWrap(false);  // otherwise the window opens as low as it can
  layout->addWidget(reading);

  BoneColoursPainter::Changes past;
  if (trial_) {
    followed_ = trial_().participantView;
    if (followed_ != nullptr && followed_->spheres() != nullptr)
      past = followed_->spheres()->changesSoFar();
  }
  painter_ = new BoneColoursPainter(spec, std::move(past), this);
  if (followed_ != nullptr) {
    followed_->setListener([this](const auto& change) { painter_->addChange(change); });
  }
  connect(painter_, &BoneColoursPainter::painted, this, &BoneColoursWindow::showPicture);
  connect(painter_, &BoneColoursPainter::failed, this, [this](const QString& why) {
    picture_->setText(tr("This bone cannot be drawn: %1").arg(why));
  });
  connect(painter_, &BoneColoursPainter::measured, this, [this](const DensityRange& range) {
    range_ = range;
    choose(colours_->currentIndex());
  });
  connect(colours_, &QComboBox::currentIndexChanged, this, &BoneColoursWindow::choose);
  connect(&updateTimer_, &QTimer::timeout, this, &BoneColoursWindow::updatePicture);
  choose(0);
  updatePicture();
  updateTimer_.start(kUpdateInterval);
}

BoneColoursWindow::~BoneColoursWindow() {
  if (followed_ != nullptr && trial_().participantView == followed_) followed_->setListener({});
}

void BoneColoursWindow::removeColours(SphereColours colours) {
  colours_->removeItem(colours_->findData(static_cast<int>(colours)));
  colours_->setVisible(colours_->count() > 1);
}

void BoneColoursWindow::choose(int index) {
  const auto colours = static_cast<SphereColours>(colours_->itemData(index).toInt());
  painter_->choose(colours);
  switch (colours) {
    case SphereColours::Density:
      legend_->showDensity(range_);
      break;
    case SphereColours::Removal:
      legend_->showRemoval();
      break;
    case SphereColours::Neutral:
      legend_->showNothing();
      break;
  }
}

/// Draws the bone at the depth of the participant's view. The view is deleted with its page; then
/// this window closes.
void BoneColoursWindow::updatePicture() {
  if (!trial_) return painter_->submit(kDepthOutside, false);
  const FollowedTrial now = trial_();
  if (now.participantView == nullptr || now.participantView != followed_) {
    followed_ = nullptr;
    close();
    return;
  }
  painter_->submit(now.participantView->depth(), now.isRunning);
}

void BoneColoursWindow::showPicture(const QImage& picture) {
  QPixmap pixmap = QPixmap::fromImage(picture);
  pixmap.setDevicePixelRatio(devicePixelRatioF());
  picture_->setPixmap(pixmap);
}

QSize BoneColoursWindow::pictureSize() const {
  return (QSizeF(picture_->size()) * devicePixelRatioF()).toSize();
}

void BoneColoursWindow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  painter_->resize(pictureSize());
}

}  // namespace study::gui::scene
