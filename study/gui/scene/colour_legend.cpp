#include "study/gui/scene/colour_legend.h"

#include <cmath>
#include <utility>

#include <QLocale>
#include <QPainter>

namespace study::gui::scene {
namespace {

constexpr int kBarHeight = 16;

QColor legendColour(Tint tint) {
  return {tint.red, tint.green, tint.blue};
}

}  // namespace

ColourLegend::ColourLegend(QWidget* parent) : QWidget(parent) {
  setMinimumSize(420, 74);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  showNothing();
}

void ColourLegend::setScale(
    const QString& title, std::vector<QString> marks, const QString& words) {
  title_ = title;
  marks_ = std::move(marks);
  setAccessibleName(words);
  setToolTip(words);
  update();
}

void ColourLegend::showDensity(const DensityRange& range) {
  constexpr double kMega = 1e6;
  constexpr double kKilo = 1e3;
  const bool isLarge = range.hardest >= kMega;
  const double unit = isLarge ? kMega : kKilo;
  const auto last = std::lround((range.hardest - range.softest) / range.step);
  std::vector<QString> marks;
  for (long i = 0; i <= last; ++i) {
    const double at = range.softest + range.step * static_cast<double>(i);
    const QString number = QLocale::c().toString(at / unit, 'g', 4);
    const bool isLowEnd = i == 0 && at > 0.0;  // nothing is softer than 0
    marks.push_back(
        isLowEnd    ? QStringLiteral("≤ ") + number
        : i == last ? QStringLiteral("≥ ") + number
                    : number);
  }
  tint_ = scaleTint;
  hasUntouched_ = false;
  const QString name = isLarge ? tr("MPa") : tr("kPa");
  setScale(
      tr("Pressure at which the bone gives way, as felt [%1]").arg(name),
      marks,
      tr("From %1 %3 (violet) to %2 %3 (yellow). At most one sphere in fifty lies beyond each "
         "end.")
          .arg(marks.front(), marks.back(), name));
}

void ColourLegend::showRemoval() {
  tint_ = removalTint;
  hasUntouched_ = true;
  setScale(
      tr("Share of each sphere's radius removed [%]"),
      {QStringLiteral("0"),
       QStringLiteral("25"),
       QStringLiteral("50"),
       QStringLiteral("75"),
       QStringLiteral("100")},
      tr("Ivory: untouched. From pale yellow (just touched) to dark red (nearly gone). What is "
         "gone "
         "is not drawn."));
}

void ColourLegend::showNothing() {
  tint_ = nullptr;
  hasUntouched_ = false;
  setScale(
      tr("As participants see it: the colours mean nothing"),
      {},
      tr("As participants see it: the colours mean nothing."));
}

void ColourLegend::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::WindowText));
  const int line = fontMetrics().height();
  painter.drawText(QRect(0, 0, width(), line), Qt::AlignLeft | Qt::AlignVCenter, title_);
  if (tint_ == nullptr) return;
  QRect bar(0, line + 4, width(), kBarHeight);
  if (hasUntouched_) {
    const QString word = tr("untouched");
    const int space = fontMetrics().horizontalAdvance(word) + 24;
    const QRect box(0, bar.top(), space - 16, kBarHeight);
    painter.fillRect(box, legendColour(untouchedTint()));
    painter.drawText(
        box.translated(0, kBarHeight + 2).adjusted(0, 0, 16, line), Qt::AlignLeft, word);
    bar.setLeft(space);
  }
  for (int x = bar.left(); x <= bar.right(); ++x) {
    const float share = static_cast<float>(x - bar.left()) / static_cast<float>(bar.width() - 1);
    painter.fillRect(QRect(x, bar.top(), 1, kBarHeight), legendColour(tint_(share)));
  }
  const int last = static_cast<int>(marks_.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    const int x = bar.left() + (bar.width() - 1) * i / last;
    painter.drawLine(x, bar.bottom() + 1, x, bar.bottom() + 4);
    constexpr int kWide = 120;
    const auto side = i == 0 ? Qt::AlignLeft : i == last ? Qt::AlignRight : Qt::AlignHCenter;
    const int left = i == 0 ? x : i == last ? x - kWide : x - kWide / 2;
    painter.drawText(
        QRect(left, bar.bottom() + 5, kWide, line), side, marks_[static_cast<std::size_t>(i)]);
  }
}

}  // namespace study::gui::scene
