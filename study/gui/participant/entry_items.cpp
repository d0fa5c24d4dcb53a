#include "study/gui/participant/entry_items.h"

#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>

#include "study/gui/widgets/labels.h"

namespace study::gui {
namespace {

using questionnaires::Item;
using questionnaires::ItemType;
using questionnaires::Response;

constexpr int kTypingPause = 600;  // [ms]

QString number(double value) {
  return QLocale::c().toString(value, 'g', 10);
}

}  // namespace

SliderItem::SliderItem(const Item& item, const QString& language, QWidget* parent)
    : ItemWidget(item, language, parent, StatementPlace::Beside), slider_(new AnswerSlider(this)) {
  slider_->setRange(0, static_cast<int>(std::lround((item.most - item.least) / step())));
  slider_->setAccessibleName(
      tr("%1: from %2 to %3").arg(text(item.text), text(item.leftText), text(item.rightText)));
  auto* ends = new QHBoxLayout;
  ends->addWidget(quietLabel(text(item.leftText), this), 1);
  auto* right = quietLabel(text(item.rightText), this);
  right->setAlignment(Qt::AlignRight);
  ends->addWidget(right, 1);
  rows().addWidget(slider_);
  rows().addLayout(ends);
  setFocusProxy(slider_);
  connect(slider_, &AnswerSlider::answered, this, &ItemWidget::changed);
}

double SliderItem::step() const noexcept {
  return item().step > 0.0 ? item().step : (item().most - item().least) / 1000.0;
}

std::optional<Response> SliderItem::response() const {
  if (!slider_->isTouched()) return std::nullopt;
  return item().least + step() * slider_->value();
}

void SliderItem::show(const Response& response) {
  const auto* value = std::get_if<double>(&response);
  const QSignalBlocker quiet(this);
  if (value != nullptr) {
    slider_->setAnswer(static_cast<int>(std::lround((*value - item().least) / step())));
  }
}

NumberItem::NumberItem(const Item& item, const QString& language, QWidget* parent)
    : ItemWidget(item, language, parent), line_(new QLineEdit(this)) {
  line_->setProperty("role", QStringLiteral("number"));
  line_->setAccessibleName(text(item.text));
  auto* row = new QHBoxLayout;
  row->addWidget(line_);
  row->addWidget(new QLabel(QString::fromStdString(item.unit), this));
  auto* range = new QLabel(tr("%1 to %2").arg(number(item.least), number(item.most)), this);
  range->setProperty("role", "quiet");
  row->addWidget(range);
  row->addStretch(1);
  rows().addLayout(row);
  setFocusProxy(line_);
  connect(line_, &QLineEdit::textChanged, this, &ItemWidget::changed);
}

std::optional<Response> NumberItem::response() const {
  bool isNumber = false;
  const double value = QLocale::c().toDouble(
      line_->text().trimmed().replace(QLatin1Char(','), QLatin1Char('.')), &isNumber);
  if (!isNumber || questionnaires::validationError(item(), value)) return std::nullopt;
  return value;
}

void NumberItem::show(const Response& response) {
  const auto* value = std::get_if<double>(&response);
  const QSignalBlocker quiet(this);
  if (value != nullptr) line_->setText(number(*value));
}

TextItem::TextItem(const Item& item, const QString& language, QWidget* parent)
    : ItemWidget(item, language, parent), pauseTimer_(new QTimer(this)) {
  pauseTimer_->setSingleShot(true);
  pauseTimer_->setInterval(kTypingPause);
  const auto restartPauseTimer = [this] { pauseTimer_->start(); };
  if (item.type == ItemType::ShortText) {
    line_ = new QLineEdit(this);
    line_->setProperty("role", QStringLiteral("answer"));
    line_->setAccessibleName(text(item.text));
    rows().addWidget(line_);
    setFocusProxy(line_);
    connect(line_, &QLineEdit::textChanged, pauseTimer_, restartPauseTimer);
  } else {
    lines_ = new QPlainTextEdit(this);
    lines_->setTabChangesFocus(true);
    lines_->setProperty("role", QStringLiteral("answer"));
    lines_->setAccessibleName(text(item.text));
    rows().addWidget(lines_);
    setFocusProxy(lines_);
    connect(lines_, &QPlainTextEdit::textChanged, pauseTimer_, restartPauseTimer);
  }
  connect(pauseTimer_, &QTimer::timeout, this, &ItemWidget::changed);
}

QString TextItem::typedText() const {
  return line_ != nullptr ? line_->text() : lines_->toPlainText();
}

std::optional<Response> TextItem::response() const {
  if (typedText().isEmpty()) return std::nullopt;
  return typedText().toStdString();
}

void TextItem::show(const Response& response) {
  const auto* words = std::get_if<std::string>(&response);
  if (words == nullptr) return;
  const QSignalBlocker quiet(this);
  if (line_ != nullptr) line_->setText(QString::fromStdString(*words));
  if (lines_ != nullptr) lines_->setPlainText(QString::fromStdString(*words));
  pauseTimer_->stop();
}

}  // namespace study::gui
