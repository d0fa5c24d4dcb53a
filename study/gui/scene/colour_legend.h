#pragma once

#include <vector>

#include <QString>
#include <QWidget>

#include "study/gui/scene/shapes/bone_tints.h"

namespace study::gui::scene {

/// What the colours of a bone mean: a scale with its numbers and their unit, in words as well for
/// those who do not see it.
class ColourLegend final : public QWidget {
  Q_OBJECT

 public:
  explicit ColourLegend(QWidget* parent = nullptr);

  /// Colours of densities.
  void showDensity(const DensityRange& range);
  /// Colours of what has been removed.
  void showRemoval();
  /// Colours that mean nothing.
  void showNothing();

  /// What stands at the scale, from its low end to its high one.
  const std::vector<QString>& marks() const noexcept { return marks_; }

  QSize sizeHint() const override { return {560, 74}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void tell(const QString& title, std::vector<QString> marks, const QString& words);

  QString title_;
  std::vector<QString> marks_;
  Tint (*tint_)(float) = nullptr;  ///< from low (0) to high (1)
  bool hasUntouched_ = false;
};

}  // namespace study::gui::scene
