#include "study/gui/desk/recording_plots.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <QEvent>
#include <QHeaderView>
#include <QScreen>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include "haptics/models/interpolation.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/plot_axes.h"
#include "study/gui/widgets/read_only_table.h"
#include "study/gui/widgets/theme.h"
#include "study/session/import_recording.h"

namespace study::gui {
namespace {

constexpr double kMilli = 1e-3;

/// Two plots and the buttons fit on a laptop's screen; a larger one has room for larger plots.
int heightOfPlotOn(const QScreen& screen) {
  constexpr int kLarge = 1000;  // [px]
  constexpr int kHeightOnLaptop = 190;
  constexpr int kHeightOnLargeScreen = 280;
  return screen.availableSize().height() >= kLarge ? kHeightOnLargeScreen : kHeightOnLaptop;
}

/// Gives the axes of all plots the same left and right ends, and few enough numbers to be read.
void alignAxes(QCPAxisRect& rect, int numbers) {
  constexpr QMargins kLeast(72, 6, 14, 0);  // [px]
  rect.setMinimumMargins(kLeast);
  rect.axis(QCPAxis::atLeft)->ticker()->setTickCount(numbers);
  for (auto* axis : rect.axes()) axis->setSubTicks(false);
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
    : QWidget(parent),
      plot_(new QCustomPlot(this)),
      force_(plot_->axisRect()),
      travel_(new QCPAxisRect(plot_)),
      words_(quietLabel({}, this)) {
  plot_->setMinimumHeight(heightOfPlotOn(*screen()));
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->setAccessibleName(tr("Force and travel over time"));
  plot_->plotLayout()->addElement(1, 0, travel_);
  plot_->plotLayout()->setRowStretchFactors({1.2, 1.0});
  plot_->plotLayout()->setRowSpacing(0);
  alignAxes(*force_, 4);
  alignAxes(*travel_, 2);
  force_->axis(QCPAxis::atBottom)->setTickLabels(false);
  force_->axis(QCPAxis::atLeft)->setLabel(tr("force [N]"));
  travel_->axis(QCPAxis::atLeft)->setLabel(tr("travel"));
  travel_->axis(QCPAxis::atBottom)->setLabel(tr("time [s]"));
  auto* layout = withoutMargins<QVBoxLayout>(this);
  layout->addWidget(sectionLabel(tr("The recording"), this));
  layout->addWidget(plot_, 1);
  layout->addWidget(words_);
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

namespace {

/// The time of a row, counted from 1 [s].
double timeOf(const RecordingPreview& preview, std::size_t row) {
  const auto& rows = preview.recording.rows;
  return kMilli * (rows[row - 1].time - rows.front().time);
}

/// Shades the height of @p rect over @p from to @p to [s].
QCPItemRect* shadeIn(QCPAxisRect& rect, double from, double to) {
  auto* shade = new QCPItemRect(rect.parentPlot());
  for (auto* corner : {shade->topLeft, shade->bottomRight}) {
    corner->setAxisRect(&rect);
    corner->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
  }
  shade->setClipAxisRect(&rect);
  shade->topLeft->setCoords(from, 0.0);
  shade->bottomRight->setCoords(to, 1.0);
  shade->setPen(Qt::NoPen);
  return shade;
}

}  // namespace

void RecordingPlot::draw() {
  plot_->clearPlottables();
  plot_->clearItems();
  const auto& colours = themeOf(*this);
  for (auto* rect : {force_, travel_}) {
    paintAxes(*plot_, colours, {rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft)});
  }
  if (preview_) {
    drawCurves(*preview_);
    shadeCuts(*preview_);
  }
  plot_->replot();
}

void RecordingPlot::drawCurves(const RecordingPreview& preview) {
  const auto& colours = themeOf(*this);
  const auto graphIn = [&](const QCPAxisRect& rect, const QColor& colour) {
    auto* graph = plot_->addGraph(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    graph->setPen(QPen(colour, 1));
    graph->valueAxis()->setLabelColor(colour);
    return graph;
  };
  auto* force = graphIn(*force_, colours.force);
  auto* travel = graphIn(*travel_, colours.travel);
  for (std::size_t i = 0; i < preview.recording.rows.size(); ++i) {
    force->addData(timeOf(preview, i + 1), preview.trace.force[i]);
    travel->addData(timeOf(preview, i + 1), preview.trace.travel[i]);
  }
  constexpr double kHeadroom = 1.25;  // room for the numbers of the cuts above the curve
  for (auto* graph : {force, travel}) {
    graph->rescaleAxes();
    auto* axis = graph->valueAxis();
    axis->setRangeUpper(axis->range().lower + kHeadroom * axis->range().size());
  }
}

void RecordingPlot::shadeCuts(const RecordingPreview& preview) {
  const auto& colours = themeOf(*this);
  int number = 0;
  for (const auto& closure : preview.survey.closures) {
    const double from = timeOf(preview, closure.rows.first);
    const double to = timeOf(preview, closure.rows.last);
    const bool isChosen = ++number == chosen_;
    QColor fill = isChosen ? colours.accent.background : colours.quiet;
    constexpr float kFaint = 0.16F;
    constexpr float kClear = 0.28F;
    fill.setAlphaF(isChosen ? kClear : kFaint);
    for (auto* rect : {force_, travel_}) shadeIn(*rect, from, to)->setBrush(fill);
    auto* label = new QCPItemText(plot_);
    label->position->setAxisRect(force_);
    label->position->setAxes(force_->axis(QCPAxis::atBottom), force_->axis(QCPAxis::atLeft));
    label->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    label->setClipAxisRect(force_);
    label->position->setCoords(0.5 * (from + to), 0.1);
    label->setText(QString::number(number));
    label->setColor(colours.field.text);
    QFont font = label->font();
    font.setBold(isChosen);
    label->setFont(font);
  }
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

/// The names of the landmarks, in the order of travel, with what was found.
std::vector<std::pair<QString, std::optional<CurvePoint>>> namedLandmarks(
    const CutLandmarks& found) {
  return {
      {CutPlot::tr("interception"), found.interception},
      {CutPlot::tr("yield"), found.yield},
      {CutPlot::tr("bottom-out"), found.bottomOut},
      {CutPlot::tr("opening begins"), found.opening}};
}

void fill(QTableWidget& table, const CutLandmarks& landmarks) {
  const auto rows = namedLandmarks(landmarks);
  table.setRowCount(static_cast<int>(rows.size()));
  for (int row = 0; row < table.rowCount(); ++row) {
    const auto& [name, point] = rows[static_cast<std::size_t>(row)];
    const QString none = QStringLiteral("–");  // it was not found
    const QString travel = point ? QString::number(point->travel, 'f', 2) : none;
    const QString force = point ? QString::number(point->force, 'f', 2) : none;
    table.setItem(row, 0, new QTableWidgetItem(capitalised(name)));
    table.setItem(row, 1, new QTableWidgetItem(travel));
    table.setItem(row, 2, new QTableWidgetItem(force));
    for (const int column : {1, 2}) {
      table.item(row, column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
  }
  constexpr int kTextMargin = 10;  // [px] of the words
  for (int row = 0; row < table.rowCount(); ++row) {
    table.setRowHeight(row, table.fontMetrics().height() + kTextMargin);
  }
  table.setFixedHeight(
      table.horizontalHeader()->sizeHint().height() + table.verticalHeader()->length() +
      2 * table.frameWidth());
}

QTableWidget* landmarkTable(QWidget* parent) {
  auto* table = new QTableWidget(0, 3, parent);
  table->setObjectName(QStringLiteral("cut-landmarks"));
  table->setAccessibleName(CutPlot::tr("Landmarks of the recording"));
  table->setHorizontalHeaderLabels(
      {CutPlot::tr("Landmark"), CutPlot::tr("Travel"), CutPlot::tr("Force [N]")});
  makeReadOnly(*table);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  for (const int column : {1, 2}) {
    table->horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  }
  return table;
}

/// The force to which protocols that render the published code limit a cut [N].
constexpr double kCodesLimit = haptics::models::Interpolation<double>::kAuthorsMaxForce;

double largestForceOf(const haptics::recordings::Cut& cut) {
  const auto& nodes = cut.curve.nodes();
  return std::ranges::max(nodes, {}, &haptics::recordings::CurvePoint::force).force;
}

QString describeChange(const haptics::recordings::ImportedCut& imported) {
  const auto& [cut, report] = imported;
  if (!report.isAltered())
    return CutPlot::tr("No part of this cut is that steep: it keeps the recorded shape.");
  return CutPlot::tr(
             "The cut is not what was recorded: %1. Slopes above %2 N per travel unit are limited; "
             "the recording rises by up to %3. A larger slope keeps the recorded shape.")
      .arg(peakInWords(report))
      .arg(cut.provenance.slopeLimit.value_or(0.0), 0, 'f', 2)
      .arg(report.steepness, 0, 'f', 2);
}

/// Says that the published code cuts off what is above its limit; empty if nothing is.
QString describeLimit(const haptics::recordings::Cut& cut) {
  if (largestForceOf(cut) <= kCodesLimit) return {};
  return QLatin1Char(' ') +
         CutPlot::tr("Protocols that render the published code limit its force to %1 N.")
             .arg(kCodesLimit);
}

/// A thin line across @p plot at the force to which the published code limits a cut.
void drawLimit(QCustomPlot& plot, const Theme& colours) {
  auto* line = new QCPItemStraightLine(&plot);
  line->setPen(QPen(colours.quiet, 1, Qt::DashLine));
  line->point1->setCoords(0.0, kCodesLimit);
  line->point2->setCoords(1.0, kCodesLimit);
  auto* label = new QCPItemText(&plot);
  label->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
  label->position->setCoords(0.0, kCodesLimit);
  label->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
  label->setPadding({6, 0, 0, 2});  // [px]
  label->setColor(colours.quiet);
  label->setText(CutPlot::tr("limit of the published code"));
}

}  // namespace

QString peakInWords(const haptics::recordings::ImportReport& report) {
  const double change = report.peakAfter - report.peakBefore;
  constexpr double kShown = 0.005;  // [N]: two decimals
  if (std::abs(change) < kShown) {
    return CutPlot::tr("its largest force is %1 N while closing, as recorded")
        .arg(report.peakAfter, 0, 'f', 2);
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
      summary_(new QWidget(this)),
      change_(bodyLabel({}, summary_)),
      noYield_(quietLabel(
          tr("A yield has a load of 3 N or more. In a recording a quarter of it is left while the "
             "tool closes further, otherwise the finger may have left the handle; without a yield "
             "the opening is the largest force. A trial marks a yield also where less is left."),
          summary_)),
      landmarks_(landmarkTable(summary_)) {
  change_->setObjectName(QStringLiteral("cut-change"));
  plot_->setMinimumHeight(heightOfPlotOn(*screen()));
  plot_->setAccessibleName(tr("Force over travel"));
  alignAxes(*plot_->axisRect(), 5);
  plot_->xAxis->setLabel(tr("travel (0 is open, about 10 is closed)"));
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
  add(tr("recorded"), QCPGraph::lsNone, QCPScatterStyle(QCPScatterStyle::ssCircle, 6));
  add(tr("the cut"), QCPGraph::lsLine, QCPScatterStyle::ssNone);
  add(tr("landmarks"), QCPGraph::lsNone, QCPScatterStyle(QCPScatterStyle::ssDiamond, 9));
  auto* layout = withoutMargins<QVBoxLayout>(this);
  layout->addWidget(sectionLabel(tr("The cut"), this));
  layout->addWidget(plot_, 1);
  auto* words = withoutMargins<QVBoxLayout>(summary_);
  words->addWidget(change_);
  words->addWidget(landmarks_);
  words->addWidget(noYield_);
  noYield_->setObjectName(QStringLiteral("no-yield"));
}

void CutPlot::setShown(bool isShown) {
  setVisible(isShown);
  summary_->setVisible(isShown);
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
  plot_->clearItems();
  for (const auto& [name, point] : namedLandmarks(found)) {
    if (!point) continue;
    plot_->graph(Landmarks)->addData(point->travel, point->force);
    auto* label = new QCPItemText(plot_);
    label->position->setCoords(point->travel, point->force);
    // Above and left of its diamond; the curve goes on to the left of the bottom-out.
    const bool isBelow = point->force == (found.bottomOut ? found.bottomOut->force : -1.0);
    label->setPositionAlignment(Qt::AlignRight | (isBelow ? Qt::AlignTop : Qt::AlignBottom));
    label->setPadding({0, 6, 8, 4});  // [px]
    label->setColor(themeOf(*this).field.text);
    label->setText(name);
  }
  plot_->rescaleAxes();
  constexpr double kNear = 0.75;  // of the limit
  if (largestForceOf(cut) >= kNear * kCodesLimit) {
    plot_->yAxis->setRangeUpper(std::max(plot_->yAxis->range().upper, kCodesLimit));
    drawLimit(*plot_, themeOf(*this));
  }
  constexpr double kMargin = 1.08;  // the marks at the ends are not cut off
  plot_->xAxis->scaleRange(kMargin);
  plot_->yAxis->scaleRange(kMargin);
  constexpr double kForNames = 0.12;  // of the height, above the highest mark
  plot_->yAxis->setRangeUpper(
      plot_->yAxis->range().upper + kForNames * plot_->yAxis->range().size());
  setRole(*change_, report.isAltered() ? "warn" : "quiet");
  change_->setText(
      (report.isAltered() ? QStringLiteral("!  ") : QString()) + describeChange(imported) +
      describeLimit(cut));
  fill(*landmarks_, cut.landmarks);
  noYield_->setVisible(!cut.landmarks.yield);
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
