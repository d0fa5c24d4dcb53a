#pragma once

#include <optional>

#include <QDeadlineTimer>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QString>

namespace study::gui {

/// A PIN of four to twelve digits that only the operator knows. It is kept in memory while the
/// program runs. It protects a screen, not data.
class OperatorPin {
 public:
  static constexpr int kFewestDigits = 4;
  static constexpr int kMostDigits = 12;
  static constexpr int kFreeTries = 3;  ///< wrong tries before a wait
  static constexpr int kWait = 10;      ///< first wait [s]; each further wrong try doubles it

  /// Why @p digits cannot be a PIN; std::nullopt if they can.
  static std::optional<QString> pinProblem(const QString& digits);

  bool isChosen() const noexcept { return !digits_.isEmpty(); }
  /// Sets the PIN.
  /// @pre pinProblem(digits) is std::nullopt
  void choose(const QString& digits) { digits_ = digits; }

  /// Whether @p digits are the PIN. Always false while secondsUntilNextTry() is not 0.
  bool acceptsPin(const QString& digits);

  /// The time until the next try is allowed [s].
  int secondsUntilNextTry() const;

 private:
  QString digits_;
  int wrongTries_ = 0;
  QDeadlineTimer wait_{0};
};

/// Asks the operator twice for a new PIN. The dialog can be accepted only with a valid PIN.
class PinDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit PinDialog(QWidget* parent = nullptr);

  QString pin() const { return first_->text(); }

 private:
  void checkEntries();

  QLineEdit* first_;
  QLineEdit* second_;
  QLabel* problemLabel_;
  QPushButton* handOver_;
};

/// Asks for a new PIN with PinDialog; std::nullopt if the operator cancels.
std::optional<QString> askForNewPin(QWidget* parent);

}  // namespace study::gui
