#include "study/gui/session/operator_pin.h"

#include <algorithm>

#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"

namespace study::gui {

std::optional<QString> OperatorPin::objection(const QString& digits) {
  const bool isNumber =
      std::all_of(digits.begin(), digits.end(), [](QChar c) { return c >= u'0' && c <= u'9'; });
  if (isNumber && digits.size() >= kFewestDigits && digits.size() <= kMostDigits) {
    return std::nullopt;
  }
  return spoken("A PIN has %1 to %2 digits, and nothing else.").arg(kFewestDigits).arg(kMostDigits);
}

bool OperatorPin::opensWith(const QString& digits) {
  if (waitLeft() > 0) return false;
  if (isChosen() && digits == digits_) {
    wrong_ = 0;
    return true;
  }
  ++wrong_;
  constexpr int kMostDoublings = 6;
  if (wrong_ >= kFreeTries) {
    const int doublings = std::min(wrong_ - kFreeTries, kMostDoublings);
    wait_.setRemainingTime(qint64{1000} * kWait << doublings);
  }
  return false;
}

int OperatorPin::waitLeft() const {
  return static_cast<int>((wait_.remainingTime() + 999) / 1000);
}

namespace {

QLineEdit* pinLine(QWidget* parent) {
  auto* line = new QLineEdit(parent);
  line->setEchoMode(QLineEdit::Password);
  line->setMaxLength(OperatorPin::kMostDigits);
  return line;
}

/// Why two entries are not accepted as a PIN; empty if they are.
QString whyNot(const QString& first, const QString& second) {
  if (const auto objection = OperatorPin::objection(first)) return *objection;
  return first == second ? QString() : QDialog::tr("The two PINs are not the same yet.");
}

}  // namespace

std::optional<QString> askForNewPin(QWidget* parent) {
  QDialog dialog(parent);
  dialog.setWindowTitle(QDialog::tr("A PIN for this screen"));
  auto* layout = new QVBoxLayout(&dialog);
  layout->addWidget(bodyLabel(
      QDialog::tr("The participant gets the whole screen. This PIN brings you back. It is valid "
                  "until the program ends, and is not saved anywhere."),
      &dialog));
  auto* form = new QFormLayout;
  auto* first = pinLine(&dialog);
  auto* second = pinLine(&dialog);
  form->addRow(QDialog::tr("PIN"), first);
  form->addRow(QDialog::tr("Once more"), second);
  layout->addLayout(form);
  auto* objection = quietLabel({}, &dialog);
  layout->addWidget(objection);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
  buttons->button(QDialogButtonBox::Ok)->setText(QDialog::tr("Hand over"));
  layout->addWidget(buttons);
  const auto judge = [&] {
    const QString why = whyNot(first->text(), second->text());
    objection->setText(why);
    buttons->button(QDialogButtonBox::Ok)->setEnabled(why.isEmpty());
  };
  for (auto* line : {first, second}) {
    QObject::connect(line, &QLineEdit::textChanged, &dialog, judge);
  }
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  judge();
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  return first->text();
}

}  // namespace study::gui
