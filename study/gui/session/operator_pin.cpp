#include "study/gui/session/operator_pin.h"

#include <algorithm>

#include <QCoreApplication>

namespace study::gui {

std::optional<QString> OperatorPin::objection(const QString& digits) {
  const bool isNumber =
      std::all_of(digits.begin(), digits.end(), [](QChar c) { return c >= u'0' && c <= u'9'; });
  if (isNumber && digits.size() >= kFewestDigits && digits.size() <= kMostDigits) {
    return std::nullopt;
  }
  return QCoreApplication::translate("OperatorPin", "A PIN has %1 to %2 digits, and nothing else.")
      .arg(kFewestDigits)
      .arg(kMostDigits);
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

}  // namespace study::gui
