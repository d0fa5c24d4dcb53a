#include "study/gui/operator/travel_plot.h"

#include <QEvent>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include "haptics/registry/device_kinds.h"
#include "study/gui/operator/travel_scale.h"
#include "study/gui/widgets/plot_axes.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

constexpr std::int64_t kSamplesPerPoint = 4;  // of a thousand samples a second, 250 are drawn

}  // namespace

TravelPlot::TravelPlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->setAccessibleName(tr("Force over travel"));
  plot_->yAxis->setLabel(tr("force [N]"));
  setMinimumSize(160, 150);
  begin(*haptics::deviceKinds().front());
}

void TravelPlot::begin(const haptics::devices::DeviceKind& device) {
  plot_->clearPlottables();
  curves_.clear();
  detector_ = haptics::engine::CutDetector(device.stroke);
  sampleCount_ = 0;
  const auto travel = travelScaleOf(device);
  scale_ = travel.factor;
  plot_->xAxis->setLabel(tr("travel [%1]").arg(travel.unit));
  plot_->xAxis->setRange(0.0, device.plot.travel);
  plot_->yAxis->setRange(0.0, device.plot.force);
  beginStroke();
}

void TravelPlot::beginStroke() {
  curves_.push_back(new QCPCurve(plot_->xAxis, plot_->yAxis));
  if (curves_.size() > kStrokes) {
    plot_->removePlottable(curves_.front());
    curves_.erase(curves_.begin());
  }
  applyThemeColours();
}

void TravelPlot::applyThemeColours() {
  const auto& colours = themeOf(*this);
  paintAxes(*plot_, colours, {plot_->xAxis, plot_->yAxis});
  const auto latest = curves_.size() < 2 ? 0 : curves_.size() - 2;  // the one that is complete
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    // A wider pen is many times slower.
    curves_[i]->setPen(QPen(i >= latest ? colours.force : colours.quiet, 1));
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void TravelPlot::changeEvent(QEvent* event) {
  if (event->type() == QEvent::StyleChange) applyThemeColours();
  QWidget::changeEvent(event);
}

void TravelPlot::add(const haptics::engine::TickSample& sample) {
  using haptics::engine::TickSample;
  if ((sample.marks & (TickSample::Invalid | TickSample::Stopped)) != 0) return;
  using Event = haptics::engine::CutDetector::Event;
  const bool isSettling = (sample.marks & TickSample::SoftStart) != 0;
  const bool isOver =
      detector_.feed(sample.travel, sample.force, isSettling) == Event::CutCompleted;
  if (sampleCount_++ % kSamplesPerPoint == 0)
    curves_.back()->addData(scale_ * sample.travel, sample.force);
  if (isOver) beginStroke();
}

void TravelPlot::refresh() {
  for (auto* curve : curves_) {
    curve->rescaleKeyAxis(true);
    curve->rescaleValueAxis(true);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

std::vector<std::vector<QPointF>> TravelPlot::strokes() const {
  std::vector<std::vector<QPointF>> all;
  for (const auto* curve : curves_) {
    auto& points = all.emplace_back();
    const auto drawn = curve->data();
    for (auto point = drawn->constBegin(); point != drawn->constEnd(); ++point) {
      points.emplace_back(point->key, point->value);
    }
  }
  return all;
}

}  // namespace study::gui
