#include "study/gui/desk/columns_form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "base/text_table.h"
#include "study/gui/widgets/field_form.h"
#include "study/gui/widgets/field_row.h"
#include "study/gui/widgets/labels.h"

namespace study::gui {
namespace {

constexpr double kLargestCell = 1e9;
constexpr double kLargestRate = 1e6;  // [Hz]

/// Milliseconds in a unit of time.
struct TimeUnit {
  const char* name;
  double milliseconds;
};
constexpr std::array kTimeUnits{TimeUnit{"s", 1000.0}, TimeUnit{"ms", 1.0}, TimeUnit{"us", 1e-3}};
constexpr std::array kForceUnits{"N", "mN", "kN", "g", "kg"};

QWidget* beside(std::initializer_list<QWidget*> parts, QWidget* parent) {
  auto* row = new QWidget(parent);
  row->setProperty("role", QStringLiteral("plain"));
  auto* line = withoutMargins<QHBoxLayout>(row);
  constexpr int kColumnStretch = 2;  // of three parts of the width
  for (auto* part : parts) line->addWidget(part, part == *parts.begin() ? kColumnStretch : 1);
  return row;
}

/// Adds a row whose label leads to the first of the fields.
void addRowOf(FieldForm& form, const QString& words, std::initializer_list<QWidget*> fields) {
  auto* row = beside(fields, (*fields.begin())->parentWidget());
  form.addRow(words, row);
  qobject_cast<QLabel*>(form.labelForField(row))->setBuddy(*fields.begin());
}

template <typename Units>
int unitIndexOf(const Units& units, const std::string& name) {
  const auto found = std::ranges::find_if(units, [&](const auto& unit) {
    if constexpr (requires { unit.name; }) {
      return name == unit.name;
    } else {
      return name == unit;
    }
  });
  return found == units.end() ? -1 : static_cast<int>(found - units.begin());
}

}  // namespace

ColumnsForm::ColumnsForm(QWidget* parent)
    : QWidget(parent),
      time_(new QComboBox(this)),
      timeUnit_(new QComboBox(this)),
      rate_(new QDoubleSpinBox(this)),
      unitOrRate_(new QStackedWidget(this)),
      travel_(new QComboBox(this)),
      openTravel_(new QDoubleSpinBox(this)),
      closedTravel_(new QDoubleSpinBox(this)),
      zeroForce_(new QDoubleSpinBox(this)),
      force_(new QComboBox(this)),
      forceUnit_(new QComboBox(this)) {
  time_->setObjectName(QStringLiteral("time"));
  travel_->setObjectName(QStringLiteral("travel"));
  force_->setObjectName(QStringLiteral("force"));
  time_->setAccessibleName(tr("Column of the time"));
  timeUnit_->setAccessibleName(tr("Unit of the time"));
  travel_->setAccessibleName(tr("Column of the travel"));
  openTravel_->setAccessibleName(tr("Travel where the tool is open"));
  closedTravel_->setAccessibleName(tr("Travel where the tool is closed"));
  zeroForce_->setAccessibleName(tr("Force without load"));
  rate_->setAccessibleName(tr("Rows per second"));
  force_->setAccessibleName(tr("Column of the force"));
  forceUnit_->setAccessibleName(tr("Unit of the force"));
  for (const auto& unit : kTimeUnits) timeUnit_->addItem(QString::fromUtf8(unit.name));
  for (const auto* unit : kForceUnits) forceUnit_->addItem(QString::fromUtf8(unit));
  constexpr int kLeastWidth = 110;  // [px]; the largest number is far wider
  constexpr int kLeastTextWidth = 150;
  auto* cells = new FieldRow(this);
  for (auto* cell : {openTravel_, closedTravel_, zeroForce_}) {
    cell->setRange(-kLargestCell, kLargestCell);
    cell->setDecimals(3);
    cell->setMinimumWidth(kLeastWidth);
    connect(cell, &QDoubleSpinBox::valueChanged, this, &ColumnsForm::changed);
  }
  cells->add(tr("Travel, open"), openTravel_);
  cells->add(tr("Travel, closed"), closedTravel_);
  cells->add(tr("Force, no load"), zeroForce_);
  rate_->setObjectName(QStringLiteral("rate"));
  rate_->setRange(0.0, kLargestRate);
  rate_->setSuffix(QStringLiteral(" Hz"));
  rate_->setMinimumWidth(kLeastTextWidth);
  rate_->setSpecialValueText(tr("rows per second?"));
  unitOrRate_->addWidget(timeUnit_);
  unitOrRate_->addWidget(rate_);
  unitOrRate_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* form = withoutMargins<FieldForm>();
  form->addRow(quietLabel(
      tr("The punch's recorder did not write this table. Say which of its columns are what."),
      this));
  addRowOf(*form, tr("Time column"), {time_, unitOrRate_});
  form->addRow(tr("Travel column"), travel_);
  addRowOf(*form, tr("Force column"), {force_, forceUnit_});
  form->addRow(QString(), cells);
  setLayout(form);
  connect(time_, &QComboBox::currentIndexChanged, this, &ColumnsForm::showUnitOrRate);
  connect(rate_, &QDoubleSpinBox::valueChanged, this, &ColumnsForm::changed);
  connect(travel_, &QComboBox::currentIndexChanged, this, &ColumnsForm::measureTravel);
  for (auto* box : {time_, timeUnit_, travel_, force_, forceUnit_}) {
    constexpr int kLettersOfAHeading = 12;
    box->setMinimumContentsLength(kLettersOfAHeading);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(box, &QComboBox::currentIndexChanged, this, &ColumnsForm::changed);
  }
}

bool ColumnsForm::offerColumnsOf(const std::string& file) {
  std::string text;
  try {
    text = haptics::recordings::contentOfRecording(file);
  } catch (const base::UserError&) {
    return false;  // reading the recording says why
  }
  const auto lines = base::linesOf(base::withoutByteOrderMark(text));
  if (lines.size() < 2) return false;
  separator_ = base::separatorOf(lines.front().text);
  const auto heads = base::cellsOf(lines.front().text, separator_);
  std::vector<std::vector<std::string>> rows;
  for (const auto& line : lines) rows.push_back(base::cellsOf(line.text, separator_));
  const auto isRow = [&](const std::vector<std::string>& cells) {
    return std::ranges::count_if(cells, [&](const auto& cell) {
             return base::numberIn(cell, separator_).has_value();
           }) >= 2;
  };
  if (heads.size() < 2 || std::ranges::none_of(rows, isRow)) return false;
  rows_ = std::move(rows);
  const bool hasHeadings = std::ranges::none_of(
      heads, [&](const auto& cell) { return base::numberIn(cell, separator_).has_value(); });
  headingLine_ = hasHeadings ? lines.front().number : 0;
  const QSignalBlocker quiet(this);
  for (auto* box : {time_, travel_, force_}) {
    box->clear();
    for (std::size_t i = 0; i < heads.size(); ++i) {
      box->addItem(hasHeadings ? QString::fromStdString(heads[i]) : tr("Column %1").arg(i + 1));
    }
  }
  time_->addItem(tr("none: evenly spaced rows"));
  std::size_t time = heads.size() == 2 ? heads.size() : 0;
  std::size_t force = heads.size() - 1;
  for (std::size_t i = 0; i < heads.size(); ++i) {
    const auto unit = base::columnHeadingOf(heads[i]).unit;
    if (const int place = unitIndexOf(kTimeUnits, unit); place >= 0 && heads.size() > 2) {
      time = i;
      timeUnit_->setCurrentIndex(place);
    }
    if (const int place = unitIndexOf(kForceUnits, unit); place >= 0) {
      force = i;
      forceUnit_->setCurrentIndex(place);
    }
  }
  std::size_t travel = 0;
  while (travel == time || travel == force) ++travel;
  time_->setCurrentIndex(static_cast<int>(time));
  travel_->setCurrentIndex(static_cast<int>(travel));
  force_->setCurrentIndex(static_cast<int>(force));
  measureTravel();
  showUnitOrRate();
  return true;
}

bool ColumnsForm::hasTime() const {
  return time_->currentIndex() < time_->count() - 1;
}

bool ColumnsForm::lacksRate() const {
  return !hasTime() && rate_->value() == rate_->minimum();
}

void ColumnsForm::showUnitOrRate() {
  unitOrRate_->setCurrentWidget(hasTime() ? static_cast<QWidget*>(timeUnit_) : rate_);
}

void ColumnsForm::measureTravel() {
  const int column = travel_->currentIndex();
  if (column < 0) return;
  std::optional<double> first;
  double farthest = 0.0;
  for (const auto& row : rows_) {
    if (row.size() <= static_cast<std::size_t>(column)) continue;
    const auto value = base::numberIn(row[static_cast<std::size_t>(column)], separator_);
    if (!value) continue;
    if (!first) farthest = *(first = value);
    if (std::abs(*value - *first) > std::abs(farthest - *first)) farthest = *value;
  }
  const QSignalBlocker open(openTravel_);
  const QSignalBlocker closed(closedTravel_);
  openTravel_->setValue(first.value_or(0.0));
  closedTravel_->setValue(farthest);
}

haptics::recordings::RecordingColumns ColumnsForm::columns() const {
  // By number: two columns may have the same heading.
  const auto chosen = [](const QComboBox& box) {
    return haptics::recordings::TableColumn{
        .number = static_cast<std::size_t>(box.currentIndex()) + 1};
  };
  const auto unit = forceUnit_->currentText().toStdString();
  return {
      .time = hasTime() ? std::optional(chosen(*time_)) : std::nullopt,
      .millisecondsPerTime =
          kTimeUnits[static_cast<std::size_t>(timeUnit_->currentIndex())].milliseconds,
      .rate = rate_->value(),
      .travel = chosen(*travel_),
      .open = openTravel_->value(),
      .closed = closedTravel_->value(),
      .force = chosen(*force_),
      .forceZero = zeroForce_->value(),
      .forceFactor = haptics::recordings::newtonsIn(unit),
      .skippedLines = headingLine_,
      .separator = separator_};
}

}  // namespace study::gui
