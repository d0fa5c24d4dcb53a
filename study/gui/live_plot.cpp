#include "study/gui/live_plot.h"

#include <QVBoxLayout>

namespace study::gui {
namespace {
constexpr double kShown = 10.0;  // [s]
}

LivePlot::LivePlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  plot_->setNoAntialiasingOnDrag(true);
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->addGraph(plot_->xAxis, plot_->yAxis);
  plot_->addGraph(plot_->xAxis, plot_->yAxis2);
  plot_->graph(0)->setPen(QPen(QColor(0x00, 0x72, 0xb2), 1));
  plot_->graph(1)->setPen(QPen(QColor(0xd5, 0x5e, 0x00), 1));
  plot_->xAxis->setLabel(tr("time [s]"));
  plot_->yAxis->setLabel(tr("force [N]"));
  plot_->yAxis->setLabelColor(QColor(0x00, 0x72, 0xb2));
  plot_->yAxis2->setVisible(true);
  plot_->yAxis2->setLabel(tr("travel"));
  plot_->yAxis2->setLabelColor(QColor(0xd5, 0x5e, 0x00));
  setMinimumHeight(220);
  clear();
}

void LivePlot::clear() {
  plot_->graph(0)->data()->clear();
  plot_->graph(1)->data()->clear();
  last_ = 0.0;
  plot_->xAxis->setRange(0.0, kShown);
  plot_->yAxis->setRange(0.0, 8.0);
  plot_->yAxis2->setRange(0.0, 12.0);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void LivePlot::add(double time, double force, double travel) {
  plot_->graph(0)->addData(time, force);
  plot_->graph(1)->addData(time, travel);
  last_ = time;
}

void LivePlot::refresh() {
  for (int i = 0; i < 2; ++i) plot_->graph(i)->data()->removeBefore(last_ - kShown);
  plot_->xAxis->setRange(std::max(0.0, last_ - kShown), std::max(kShown, last_));
  plot_->graph(0)->rescaleValueAxis(true);
  plot_->graph(1)->rescaleValueAxis(true);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace study::gui
