#pragma once

#include <cstdint>
#include <optional>

#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTableWidget>
#include <QWidget>

#include "protocols/model/protocol.h"
#include "study/gui/widgets/result_table.h"

namespace study::gui {

/// The planned condition order of each participant and how balanced the orders are, as in `palpate
/// protocol orders`.
class OrdersPage final : public QWidget {
  Q_OBJECT

 public:
  explicit OrdersPage(QWidget* parent = nullptr);

  void show(const protocols::Protocol& protocol);
  using QWidget::show;
  void clear();

 private:
  void fill();
  std::uint64_t seed() const;

  std::optional<protocols::Protocol> protocol_;
  QSpinBox* participants_;
  QLineEdit* seed_;
  QTableWidget* table_;
  ResultTable* balance_;
};

}  // namespace study::gui
