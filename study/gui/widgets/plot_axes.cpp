#include "study/gui/widgets/plot_axes.h"

namespace study::gui {

void paintAxes(QCustomPlot& plot, const Theme& colours, std::initializer_list<QCPAxis*> axes) {
  plot.setBackground(colours.field.background);
  for (auto* axis : axes) {
    axis->setBasePen(QPen(colours.quiet));
    axis->setTickPen(QPen(colours.quiet));
    axis->setSubTickPen(QPen(colours.quiet));
    axis->setTickLabelColor(colours.field.text);
    axis->setLabelColor(colours.field.text);
    axis->grid()->setPen(QPen(colours.line, 0, Qt::DotLine));
    axis->grid()->setZeroLinePen(QPen(colours.line));
  }
}

}  // namespace study::gui
