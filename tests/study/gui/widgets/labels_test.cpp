#include "study/gui/widgets/labels.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QWidget>

namespace study::gui {
namespace labels_test {

/// A text of about 600 characters in two paragraphs.
QString longText() {
  const QString sentence = QStringLiteral("You will feel **three** renderings of a cut. ");
  return sentence.repeated(7) + QStringLiteral("\n\n") + sentence.repeated(7);
}

/// The height that QLabel itself computes, with nothing remembered.
int computedHeight(const QLabel& label, int width) {
  return label.QLabel::heightForWidth(width);
}

TEST(TextLabel, IsAsHighAsItsTextInEachWidthAndStyle) {
  constexpr int kNarrow = 240;  // [px]
  constexpr int kWide = 480;
  QWidget window;
  const auto* label = textLabel(longText(), &window);
  window.show();
  const int narrow = label->heightForWidth(kNarrow);
  EXPECT_GT(narrow, label->heightForWidth(kWide));
  EXPECT_EQ(label->heightForWidth(kNarrow), narrow);
  EXPECT_EQ(narrow, computedHeight(*label, kNarrow));
  for (const auto* style : {"font-size: 40px", "font-size: 9px; padding: 20px"}) {
    window.setStyleSheet(QStringLiteral("QLabel { %1 }").arg(QLatin1String(style)));
    EXPECT_NE(label->heightForWidth(kNarrow), narrow) << style;
    EXPECT_EQ(label->heightForWidth(kNarrow), computedHeight(*label, kNarrow)) << style;
  }
}

}  // namespace labels_test
}  // namespace study::gui
