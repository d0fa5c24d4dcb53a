#pragma once

#include <optional>

#include <QDeadlineTimer>
#include <QString>
#include <QWidget>

namespace study::gui {

/// Four to twelve digits that the operator knows and the participant does not. Kept in memory only,
/// as long as the program runs; it guards a screen, not data.
class OperatorPin {
 public:
  static constexpr int kFewestDigits = 4;
  static constexpr int kMostDigits = 12;
  static constexpr int kFreeTries = 3;  ///< before each further one has to wait
  static constexpr int kWait = 10;      ///< [s], doubled with every wrong try after that

  /// Why @p digits cannot be a PIN, in words; nothing where they can.
  static std::optional<QString> objection(const QString& digits);

  bool isChosen() const noexcept { return !digits_.isEmpty(); }
  /// @pre objection(digits) is nothing
  void choose(const QString& digits) { digits_ = digits; }

  /// Whether it is the PIN; never while waitLeft() is not 0.
  bool opensWith(const QString& digits);

  /// How long nobody may try now [s]; 0: they may.
  int waitLeft() const;

 private:
  QString digits_;
  int wrong_ = 0;
  QDeadlineTimer wait_{0};
};

/// Asks the operator for a new PIN, twice; nothing where they think better of it.
std::optional<QString> askForNewPin(QWidget* parent);

}  // namespace study::gui
