#include "study/gui/desk/recording_picture.h"

#include <algorithm>
#include <utility>

#include <QEvent>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"
#include "study/session/import_recording.h"

namespace study::gui {
namespace {

constexpr double kMilli = 1e-3;

QString describe(const RecordingLook& look) {
  const auto& [recording, trace, survey] = look;
  QString words = RecordingPicture::tr("%1 rows at %2 Hz; force from %3 by calibration %4; %5 cuts")
                      .arg(survey.rows)
                      .arg(survey.sampling.rate, 0, 'f', 0)
                      .arg(
                          QString::fromStdString(recording.readingUnit),
                          QString::fromStdString(trace.calibration.name))
                      .arg(survey.closures.size());
  words += RecordingPicture::tr("; largest force %1 N").arg(survey.maxForce, 0, 'f', 2);
  if (survey.saturatedRows > 0) {
    words +=
        RecordingPicture::tr("; in %1 rows the sensor was at its end, and the force was larger")
            .arg(survey.saturatedRows);
  }
  if (survey.uncalibratedRows > survey.saturatedRows) {
    words += RecordingPicture::tr("; %1 rows are outside of the calibration")
                 .arg(survey.uncalibratedRows);
  }
  if (survey.refusedLines > 0) {
    words += RecordingPicture::tr("; %1 lines could not be read").arg(survey.refusedLines);
  }
  return words + QLatin1Char('.');
}

}  // namespace

RecordingLook lookAt(const std::string& recording, const std::string& columns) {
  RecordingLook look{.recording = recordingIn(recording, columns), .trace = {}, .survey = {}};
  look.trace = haptics::recordings::traceOf(
      look.recording, haptics::recordings::calibrationFor(look.recording), {});
  look.survey = haptics::recordings::summariseCuts(look.recording, look.trace);
  return look;
}

RecordingPicture::RecordingPicture(QWidget* parent)
    : QWidget(parent), plot_(new QCustomPlot(this)), words_(quietLabel({}, this)) {
  words_->setObjectName(QStringLiteral("recording-words"));
  plot_->setMinimumHeight(220);
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->xAxis->setLabel(tr("time [s]"));
  plot_->yAxis->setLabel(tr("force [N]"));
  plot_->yAxis2->setLabel(tr("travel [units]"));
  plot_->yAxis2->setVisible(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_, 1);
  layout->addWidget(words_);
  show(std::nullopt);
}

void RecordingPicture::show(std::optional<RecordingLook> look) {
  look_ = std::move(look);
  words_->setText(look_ ? describe(*look_) : QString());
  setVisible(look_.has_value());
  draw();
}

void RecordingPicture::choose(int cut) {
  chosen_ = cut;
  draw();
}

int RecordingPicture::cuts() const {
  return look_ ? static_cast<int>(look_->survey.closures.size()) : 0;
}

void RecordingPicture::draw() {
  plot_->clearPlottables();
  plot_->clearItems();
  const auto& colours = themeOf(*this);
  plot_->setBackground(colours.field.background);
  for (auto* axis : {plot_->xAxis, plot_->yAxis, plot_->yAxis2}) {
    axis->setBasePen(QPen(colours.quiet));
    axis->setTickPen(QPen(colours.quiet));
    axis->setSubTickPen(QPen(colours.quiet));
    axis->setTickLabelColor(colours.field.text);
    axis->setLabelColor(colours.field.text);
    axis->grid()->setPen(QPen(colours.line, 0, Qt::DotLine));
  }
  if (!look_) return plot_->replot();
  const auto& rows = look_->recording.rows;
  const auto timeOf = [&](std::size_t row) {  // from 1
    return kMilli * (rows[row - 1].time - rows.front().time);
  };
  auto* force = plot_->addGraph(plot_->xAxis, plot_->yAxis);
  auto* travel = plot_->addGraph(plot_->xAxis, plot_->yAxis2);
  force->setPen(QPen(colours.force, 1));
  travel->setPen(QPen(colours.travel, 1));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    force->addData(timeOf(i + 1), look_->trace.force[i]);
    travel->addData(timeOf(i + 1), look_->trace.travel[i]);
  }
  int number = 0;
  for (const auto& closure : look_->survey.closures) {
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
  plot_->replot();
}

void RecordingPicture::changeEvent(QEvent* event) {
  if (event->type() == QEvent::StyleChange) draw();
  QWidget::changeEvent(event);
}

}  // namespace study::gui
