#include "study/gui/session/operator_pin.h"

#include <algorithm>

#include <QDialogButtonBox>
#include <QVBoxLayout>

#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/field_form.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/message_box.h"

namespace study::gui {

std::optional<QString> OperatorPin::pinProblem(const QString& digits) {
  const bool isNumber =
      std::all_of(digits.begin(), digits.end(), [](QChar c) { return c >= u'0' && c <= u'9'; });
  if (isNumber && digits.size() >= kFewestDigits && digits.size() <= kMostDigits) {
    return std::nullopt;
  }
  return deskText("A PIN has %1 to %2 digits, and nothing else.")
      .arg(kFewestDigits)
      .arg(kMostDigits);
}

bool OperatorPin::acceptsPin(const QString& digits) {
  if (secondsUntilNextTry() > 0) return false;
  if (isChosen() && digits == digits_) {
    wrongTries_ = 0;
    return true;
  }
  ++wrongTries_;
  constexpr int kMostDoublings = 6;
  if (wrongTries_ >= kFreeTries) {
    const int doublings = std::min(wrongTries_ - kFreeTries, kMostDoublings);
    wait_.setRemainingTime(qint64{1000} * kWait << doublings);
  }
  return false;
}

int OperatorPin::secondsUntilNextTry() const {
  return static_cast<int>((wait_.remainingTime() + 999) / 1000);
}

namespace {

QLineEdit* pinLine(QWidget* parent) {
  auto* line = new QLineEdit(parent);
  line->setEchoMode(QLineEdit::Password);
  line->setMaxLength(OperatorPin::kMostDigits);
  return line;
}

/// Why the two entries are not accepted as a PIN; empty if they are accepted.
QString whyNot(const QString& first, const QString& second) {
  if (const auto objection = OperatorPin::pinProblem(first)) return *objection;
  return first == second ? QString() : PinDialog::tr("The two PINs are not the same yet.");
}

}  // namespace

PinDialog::PinDialog(QWidget* parent)
    : QDialog(parent),
      first_(pinLine(this)),
      second_(pinLine(this)),
      problemLabel_(quietLabel({}, this)) {
  setWindowTitle(tr("A PIN for this screen"));
  auto* layout = new QVBoxLayout(this);
  layout->setSizeConstraint(QLayout::SetFixedSize);  // always as large as its words need
  auto* words = addBoxWords(
      *layout,
      MessageRow::Kind::Question,
      tr("Choose a PIN to get your window back"),
      {tr("The participant gets the whole screen until you press “Researcher” there and type the "
          "PIN. Esc, Pause, F12 or a foot switch stop the force meanwhile."),
       tr("It is valid until the program ends. Forgotten? Restart the computer and continue the "
          "session: every answer is kept.")},
      *this);
  auto* form = new FieldForm;
  form->addRow(
      tr("PIN (%1–%2 digits)").arg(OperatorPin::kFewestDigits).arg(OperatorPin::kMostDigits),
      first_);
  form->addRow(tr("Once more"), second_);
  words->addLayout(form);
  words->addWidget(problemLabel_);
  auto* buttons = new QDialogButtonBox(this);
  handOver_ = buttons->addButton(tr("Hand over"), QDialogButtonBox::AcceptRole);
  handOver_->setProperty("role", QStringLiteral("main"));
  buttons->addButton(tr("Do not hand over"), QDialogButtonBox::RejectRole);
  layout->addWidget(buttons);
  for (auto* line : {first_, second_}) {
    connect(line, &QLineEdit::textChanged, this, &PinDialog::checkEntries);
  }
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  checkEntries();
}

void PinDialog::checkEntries() {
  const QString why = whyNot(first_->text(), second_->text());
  problemLabel_->setText(why);
  handOver_->setEnabled(why.isEmpty());
}

std::optional<QString> askForNewPin(QWidget* parent) {
  PinDialog dialog(parent);
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  return dialog.pin();
}

}  // namespace study::gui
