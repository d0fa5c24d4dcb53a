#pragma once

#include <vector>

#include <QString>
#include <QWidget>

#include "study/gui/scene/shapes/bone_tints.h"

namespace study::gui::scene {

/// A legend for the colours of a bone: a colour scale with numbers and a unit, also as text for
/// screen readers.
class ColourLegend final : public QWidget {
  Q_OBJECT

 public:
  explicit ColourLegend(QWidget* parent = nullptr);

  /// Shows the scale of densities.
  void showDensity(const DensityRange& range);
  /// Shows the scale of removed material.
  void showRemoval();
  /// Shows no scale: the colours have no meaning.
  void showNothing();

  /// The labels of the scale, from its low end to its high end.
  const std::vector<QString>& marks() const noexcept { return marks_; }

  QSize sizeHint() const override { return {560, 74}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Sets the title, the texts along the bar of colours, and what a screen reader and a tooltip
  /// say.
  void setScale(const QString& title, std::vector<QString> marks, const QString& words);

  QString title_;
  std::vector<QString> marks_;
  Tint (*tint_)(float) = nullptr;  ///< colour of a value from low (0) to high (1)
  bool hasUntouched_ = false;
};

}  // namespace study::gui::scene
