#include "study/gui/operator/live_plot.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include "haptics/registry/device_kinds.h"
#include "study/gui/operator/travel_scale.h"
#include "study/gui/widgets/plot_axes.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {

void LivePlot::Slice::add(double time, double value) {
  if (isEmpty || value < least) {
    least = value;
    leastAt = time;
  }
  if (isEmpty || value > largest) {
    largest = value;
    largestAt = time;
  }
  isEmpty = false;
}

LivePlot::LivePlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  plot_->setNoAntialiasingOnDrag(true);
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->setAccessibleName(tr("Force over time"));
  auto* below = new QCPAxisRect(plot_);
  auto* time = below->axis(QCPAxis::atBottom);
  auto* torque = plot_->axisRect()->addAxis(QCPAxis::atLeft);
  plot_->addGraph(plot_->xAxis, plot_->yAxis);
  plot_->addGraph(time, below->axis(QCPAxis::atLeft));
  plot_->addGraph(plot_->xAxis, torque);
  plot_->xAxis->setTickLabels(false);
  time->setLabel(tr("time [s]"));
  plot_->yAxis->setLabel(tr("force [N]"));
  torque->setLabel(tr("torque [N·m]"));
  stack(*below);
  setMinimumHeight(150);
  applyThemeColours();
  begin(*haptics::deviceKinds().front(), 1000.0);
}

/// Puts the travel's axes below those of the force, with the same width.
void LivePlot::stack(QCPAxisRect& below) {
  auto* margins = new QCPMarginGroup(plot_);
  auto* rows = plot_->plotLayout();
  rows->addElement(1, 0, &below);
  rows->setRowSpacing(14);
  rows->setRowStretchFactors({1.4, 1.0});
  constexpr int kNumbers = 4;
  for (auto* rect : {plot_->axisRect(), &below}) {
    constexpr QMargins kLeast(0, 8, 12, 0);  // [px]
    rect->setMinimumMargins(kLeast);
    rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    rect->axis(QCPAxis::atLeft)->ticker()->setTickCount(kNumbers);
  }
}

void LivePlot::showTime(double from, double to) {
  for (const int graph : {0, 1}) plot_->graph(graph)->keyAxis()->setRange(from, to);
}

void LivePlot::applyThemeColours() {
  const auto& colours = themeOf(*this);
  paintAxes(*plot_, colours, {plot_->xAxis, plot_->graph(1)->keyAxis()});
  const std::array<QColor, 3> channels{colours.force, colours.travel, colours.torque};
  for (std::size_t i = 0; i < channels.size(); ++i) {
    auto* graph = plot_->graph(static_cast<int>(i));
    graph->setPen(QPen(channels[i], 1));
    paintAxes(*plot_, colours, {graph->valueAxis()});
    graph->valueAxis()->setLabelColor(channels[i]);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void LivePlot::changeEvent(QEvent* event) {
  if (event->type() == QEvent::StyleChange) applyThemeColours();
  QWidget::changeEvent(event);
}

void LivePlot::begin(const haptics::devices::DeviceKind& device, double rate) {
  for (int i = 0; i < plot_->graphCount(); ++i) plot_->graph(i)->data()->clear();
  slices_ = {};
  period_ = 1.0 / rate;
  slice_ = 0;
  lastTime_ = 0.0;
  showTime(0.0, kFirst);
  // The range of a normal hand movement. Larger values extend the axis.
  plot_->yAxis->setRange(0.0, device.plot.force);
  auto* position = plot_->graph(1)->valueAxis();
  position->setRange(0.0, device.plot.travel);
  const bool hasTorque = device.plot.torque > 0.0;
  plot_->graph(2)->setVisible(hasTorque);
  plot_->graph(2)->valueAxis()->setVisible(hasTorque);
  if (hasTorque) plot_->graph(2)->valueAxis()->setRange(-device.plot.torque, device.plot.torque);
  const auto travel = travelScaleOf(device);
  scale_ = travel.factor;
  position->setLabel(tr("travel [%1]").arg(travel.unit));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void LivePlot::add(const haptics::engine::TickSample& sample) {
  const double time = static_cast<double>(sample.tick) * period_;
  constexpr double kRounding = 1e-6;
  const auto slice = static_cast<std::int64_t>(std::floor(time / kSlice + kRounding));
  if (slice != slice_) endSlice();
  slice_ = slice;
  slices_[0].add(time, sample.force);
  slices_[1].add(time, scale_ * sample.travel);
  slices_[2].add(time, sample.torque);
  lastTime_ = time;
}

void LivePlot::endSlice() {
  for (std::size_t i = 0; i < slices_.size(); ++i) {
    auto& slice = slices_[i];
    if (slice.isEmpty) continue;
    auto* graph = plot_->graph(static_cast<int>(i));
    const bool leastFirst = slice.leastAt <= slice.largestAt;
    graph->addData(
        leastFirst ? slice.leastAt : slice.largestAt, leastFirst ? slice.least : slice.largest);
    if (slice.leastAt != slice.largestAt) {
      graph->addData(
          leastFirst ? slice.largestAt : slice.leastAt, leastFirst ? slice.largest : slice.least);
    }
    slice = {};
  }
}

std::vector<QPointF> LivePlot::channel(int index) const {
  std::vector<QPointF> points;
  const auto shown = plot_->graph(index)->data();
  for (auto point = shown->constBegin(); point != shown->constEnd(); ++point) {
    points.emplace_back(point->key, point->value);
  }
  return points;
}

void LivePlot::refresh() {
  for (int i = 0; i < plot_->graphCount(); ++i) {
    plot_->graph(i)->data()->removeBefore(lastTime_ - kShown);
    plot_->graph(i)->rescaleValueAxis(true);
  }
  showTime(std::max(0.0, lastTime_ - kShown), std::max(kFirst, lastTime_));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace study::gui
