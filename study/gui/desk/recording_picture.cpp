#include "study/gui/desk/recording_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QEvent>
#include <QScreen>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/plot_axes.h"
#include "study/gui/widgets/theme.h"
#include "study/session/import_recording.h"

namespace study::gui {
namespace {

constexpr double kMilli = 1e-3;

/// Two plots and the buttons fit on a laptop's screen; a larger one has room for larger plots.
int heightOfPlotOn(const QScreen& screen) {
  constexpr int kLarge = 1000;  // [px]
  constexpr int kOnALaptop = 170;
  constexpr int kOnALargeScreen = 260;
  return screen.availableSize().height() >= kLarge ? kOnALargeScreen : kOnALaptop;
}

QString sourceOfForce(const RecordingPreview& preview) {
  if (preview.recording.readingUnit == "N") return RecordingPlot::tr("force in newtons");
  return RecordingPlot::tr("force from %1 by calibration %2")
      .arg(
          QString::fromStdString(preview.recording.readingUnit),
          QString::fromStdString(preview.trace.calibration.name));
}

QString describe(const RecordingPreview& preview) {
  const auto& [recording, trace, survey] = preview;
  QString words = RecordingPlot::tr("%1 rows at %2 Hz; %3; %4 cuts")
                      .arg(survey.rows)
                      .arg(survey.sampling.rate, 0, 'f', 0)
                      .arg(sourceOfForce(preview))
                      .arg(survey.closures.size());
  words +=
      RecordingPlot::tr("; largest force of the recording %1 N").arg(survey.maxForce, 0, 'f', 2);
  if (survey.saturatedRows > 0) {
    words += RecordingPlot::tr("; in %1 rows the sensor was at its limit, and the force was larger")
                 .arg(survey.saturatedRows);
  }
  if (survey.uncalibratedRows > survey.saturatedRows) {
    words +=
        RecordingPlot::tr("; %1 rows are outside of the calibration").arg(survey.uncalibratedRows);
  }
  if (survey.refusedLines > 0) {
    words += RecordingPlot::tr("; %1 lines could not be read").arg(survey.refusedLines);
  }
  return words + QLatin1Char('.');
}

}  // namespace

RecordingPreview previewOf(
    const std::string& recording,
    const std::optional<haptics::recordings::RecordingColumns>& columns) {
  RecordingPreview preview{
      .recording = readRecordingWithColumns(recording, columns), .trace = {}, .survey = {}};
  preview.trace = haptics::recordings::traceOf(
      preview.recording, haptics::recordings::calibrationFor(preview.recording), {});
  preview.survey = haptics::recordings::summariseCuts(preview.recording, preview.trace);
  return preview;
}

RecordingPlot::RecordingPlot(QWidget* parent)
    : QWidget(parent), plot_(new QCustomPlot(this)), words_(quietLabel({}, this)) {
  words_->setObjectName(QStringLiteral("recording-words"));
  plot_->setMinimumHeight(heightOfPlotOn(*screen()));
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->xAxis->setLabel(tr("time [s]"));
  plot_->yAxis->setLabel(tr("force [N]"));
  plot_->yAxis2->setLabel(tr("travel [units]"));
  plot_->yAxis2->setVisible(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  layout->addWidget(words_);
  layout->addStretch(1);
  show(std::nullopt);
}

void RecordingPlot::show(std::optional<RecordingPreview> preview) {
  preview_ = std::move(preview);
  words_->setText(preview_ ? describe(*preview_) : QString());
  setVisible(preview_.has_value());
  draw();
}

void RecordingPlot::choose(int cut) {
  chosen_ = cut;
  draw();
}

int RecordingPlot::cuts() const {
  return preview_ ? static_cast<int>(preview_->survey.closures.size()) : 0;
}

void RecordingPlot::draw() {
  plot_->clearPlottables();
  plot_->clearItems();
  const auto& colours = themeOf(*this);
  paintAxes(*plot_, colours, {plot_->xAxis, plot_->yAxis, plot_->yAxis2});
  if (!preview_) return plot_->replot();
  const auto& rows = preview_->recording.rows;
  const auto timeOf = [&](std::size_t row) {  // from 1
    return kMilli * (rows[row - 1].time - rows.front().time);
  };
  auto* force = plot_->addGraph(plot_->xAxis, plot_->yAxis);
  auto* travel = plot_->addGraph(plot_->xAxis, plot_->yAxis2);
  force->setPen(QPen(colours.force, 1));
  travel->setPen(QPen(colours.travel, 1));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    force->addData(timeOf(i + 1), preview_->trace.force[i]);
    travel->addData(timeOf(i + 1), preview_->trace.travel[i]);
  }
  int number = 0;
  for (const auto& closure : preview_->survey.closures) {
    auto* shade = new QCPItemRect(plot_);
    shade->topLeft->setTypeY(QCPItemPosition::ptAxisRectRatio);
    shade->bottomRight->setTypeY(QCPItemPosition::ptAxisRectRatio);
    shade->topLeft->setCoords(timeOf(closure.rows.first), 0.0);
    shade->bottomRight->setCoords(timeOf(closure.rows.last), 1.0);
    QColor fill = ++number == chosen_ ? colours.accent.background : colours.quiet;
    constexpr float kFaint = 0.22F;
    fill.setAlphaF(kFaint);
    shade->setBrush(fill);
    shade->setPen(Qt::NoPen);
    auto* label = new QCPItemText(plot_);
    label->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    label->position->setCoords(
        0.5 * (timeOf(closure.rows.first) + timeOf(closure.rows.last)), 0.05);
    label->setText(QString::number(number));
    label->setColor(colours.field.text);
  }
  plot_->rescaleAxes();
  constexpr double kAbove = 1.18;  // room for the numbers of the cuts above the curves
  for (auto* axis : {plot_->yAxis, plot_->yAxis2}) {
    axis->setRangeUpper(axis->range().lower + kAbove * axis->range().size());
  }
  plot_->replot();
}

void RecordingPlot::changeEvent(QEvent* event) {
  if (event->type() == QEvent::StyleChange) draw();
  QWidget::changeEvent(event);
}

namespace {

using haptics::recordings::CurvePoint;
using haptics::recordings::CutLandmarks;

/// The graphs of a CutPlot, in the order in which it adds them.
enum Graph { Recorded, Rendered, Landmarks };

QString landmark(const QString& name, const std::optional<CurvePoint>& point) {
  if (!point) return CutPlot::tr("%1 not found").arg(name);
  return CutPlot::tr("%1 %2 N at %3")
      .arg(name)
      .arg(point->force, 0, 'f', 2)
      .arg(point->travel, 0, 'f', 2);
}

QString describe(const CutLandmarks& landmarks) {
  return CutPlot::tr(
             "Landmarks of the cut, by travel (0: open; 10: closed; more: pressed on): %1, %2, %3, "
             "%4.")
      .arg(
          landmark(CutPlot::tr("interception"), landmarks.interception),
          landmark(CutPlot::tr("yield"), landmarks.yield),
          landmark(CutPlot::tr("bottom-out"), landmarks.bottomOut),
          landmark(CutPlot::tr("opening"), landmarks.opening));
}

QString describeChange(const haptics::recordings::ImportedCut& imported) {
  const auto& [cut, report] = imported;
  if (!report.isAltered()) {
    return CutPlot::tr("The cut keeps the shape of the recording: %1.").arg(peakInWords(report));
  }
  return CutPlot::tr(
             "The cut is not what was recorded: %1. Slopes above %2 N per travel unit are limited; "
             "the recording rises by up to %3.")
      .arg(peakInWords(report))
      .arg(cut.provenance.slopeLimit.value_or(0.0), 0, 'f', 2)
      .arg(report.steepness, 0, 'f', 2);
}

}  // namespace

QString peakInWords(const haptics::recordings::ImportReport& report) {
  const double change = report.peakAfter - report.peakBefore;
  constexpr double kShown = 0.005;  // [N]: two decimals
  if (std::abs(change) < kShown) {
    return CutPlot::tr("its largest force is %1 N, as recorded").arg(report.peakAfter, 0, 'f', 2);
  }
  const QString words = CutPlot::tr("its largest force was %1 N and is %2 N")
                            .arg(report.peakBefore, 0, 'f', 2)
                            .arg(report.peakAfter, 0, 'f', 2);
  if (!(report.peakBefore > 0.0)) return words;
  return words + QStringLiteral(" (%1%2\u00a0%)")
                     .arg(change > 0.0 ? QStringLiteral("+") : QStringLiteral("\u2212"))
                     .arg(100.0 * std::abs(change) / report.peakBefore, 0, 'f', 1);
}

CutPlot::CutPlot(QWidget* parent)
    : QWidget(parent),
      plot_(new QCustomPlot(this)),
      change_(bodyLabel({}, this)),
      landmarks_(quietLabel({}, this)) {
  change_->setObjectName(QStringLiteral("cut-change"));
  landmarks_->setObjectName(QStringLiteral("cut-landmarks"));
  plot_->setMinimumHeight(heightOfPlotOn(*screen()));
  plot_->xAxis->setLabel(tr("travel [units]"));
  plot_->yAxis->setLabel(tr("force [N]"));
  plot_->legend->setVisible(true);
  plot_->legend->setFillOrder(QCPLegend::foColumnsFirst);
  plot_->plotLayout()->insertRow(0);  // above the axes: a legend inside them hides samples
  plot_->plotLayout()->addElement(0, 0, plot_->legend);
  plot_->plotLayout()->setRowStretchFactor(0, 1e-3);
  const auto add = [&](const QString& name, QCPGraph::LineStyle line, const QCPScatterStyle& dots) {
    auto* graph = plot_->addGraph();
    graph->setName(name);
    graph->setLineStyle(line);
    graph->setScatterStyle(dots);
  };
  add(tr("recorded"), QCPGraph::lsNone, QCPScatterStyle(QCPScatterStyle::ssDisc, 5));
  add(tr("the cut"), QCPGraph::lsLine, QCPScatterStyle::ssNone);
  add(tr("landmarks"), QCPGraph::lsNone, QCPScatterStyle(QCPScatterStyle::ssDiamond, 9));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  layout->addWidget(change_);
  layout->addWidget(landmarks_);
  layout->addStretch(1);
}

void CutPlot::show(
    const haptics::recordings::Trace& trace, const haptics::recordings::ImportedCut& imported) {
  const auto& [cut, report] = imported;
  for (int i = 0; i < plot_->graphCount(); ++i) plot_->graph(i)->data()->clear();
  for (const auto& rows : report.rows) {
    for (std::size_t row = rows.first - 1; row < rows.last; ++row) {
      plot_->graph(Recorded)->addData(trace.travel[row], trace.force[row]);
    }
  }
  for (const auto& point : cut.curve.nodes()) {
    plot_->graph(Rendered)->addData(point.travel, point.force);
  }
  const auto& found = cut.landmarks;
  for (const auto& point : {found.interception, found.yield, found.bottomOut, found.opening}) {
    if (point) plot_->graph(Landmarks)->addData(point->travel, point->force);
  }
  plot_->rescaleAxes();
  constexpr double kMargin = 1.08;  // the marks at the ends are not cut off
  plot_->xAxis->scaleRange(kMargin);
  plot_->yAxis->scaleRange(kMargin);
  setRole(*change_, report.isAltered() ? "warn" : "quiet");
  change_->setText(
      (report.isAltered() ? QStringLiteral("!  ") : QString()) + describeChange(imported));
  landmarks_->setText(describe(cut.landmarks));
  paint();
}

void CutPlot::paint() {
  const auto& colours = themeOf(*this);
  paintAxes(*plot_, colours, {plot_->xAxis, plot_->yAxis});
  constexpr double kWidth = 2.0;  // [px]
  plot_->graph(Recorded)->setPen(QPen(colours.quiet, 1));
  plot_->graph(Rendered)->setPen(QPen(colours.force, kWidth));
  plot_->graph(Landmarks)->setPen(QPen(colours.travel, kWidth));
  plot_->legend->setBrush(colours.field.background);
  plot_->legend->setBorderPen(Qt::NoPen);
  plot_->legend->setTextColor(colours.field.text);
  plot_->replot();
}

void CutPlot::changeEvent(QEvent* event) {
  if (event->type() == QEvent::StyleChange) paint();
  QWidget::changeEvent(event);
}

}  // namespace study::gui
