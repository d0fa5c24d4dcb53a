#include "study/gui/participant/option_buttons.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QSignalSpy>
#include <QTest>

#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace option_buttons_test {

class OptionButtonsTest : public testing::Test {
 protected:
  OptionButtonsTest() { buttons_.show(); }

  OptionButtons buttons_{
      {{"1", "one of five"}, {"2", "two of five"}, {"3", "three of five"}},
      3,
      QStringLiteral("point")};
};

TEST_F(OptionButtonsTest, HasNothingChosenAtFirst) {
  EXPECT_EQ(buttons_.chosen(), -1);
}

TEST_F(OptionButtonsTest, EmitsAMouseChoice) {
  QSignalSpy spy(&buttons_, &OptionButtons::chosenChanged);
  QTest::mouseClick(buttons_.button(1), Qt::LeftButton);
  EXPECT_EQ(buttons_.chosen(), 1);
  ASSERT_EQ(spy.count(), 1);
  EXPECT_EQ(spy.front().front().toInt(), 1);
}

TEST_F(OptionButtonsTest, ArrowKeysMoveTheFocusOnly) {
  buttons_.choose(0);
  buttons_.button(0)->setFocus();
  QTest::keyClick(buttons_.button(0), Qt::Key_Right);
  EXPECT_EQ(buttons_.chosen(), 0);
  QTest::keyClick(buttons_.button(1), Qt::Key_Right);
  EXPECT_EQ(buttons_.chosen(), 0);
}

TEST(OptionButtonsInRows, AreWalkedThroughByArrowKeysInBothDirections) {
  OptionButtons buttons(
      {{"a", "a"}, {"b", "b"}, {"c", "c"}, {"d", "d"}, {"e", "e"}}, 2, QStringLiteral("option"));
  buttons.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&buttons));
  const auto focusAfter = [&](int from, Qt::Key key) {
    buttons.button(from)->setFocus();
    QTest::keyClick(buttons.button(from), key);
    for (int i = 0; i < 5; ++i) {
      if (buttons.button(i)->hasFocus()) return i;
    }
    return -1;
  };
  EXPECT_EQ(focusAfter(0, Qt::Key_Right), 1);
  EXPECT_EQ(focusAfter(1, Qt::Key_Right), 2);
  EXPECT_EQ(focusAfter(1, Qt::Key_Down), 3);
  EXPECT_EQ(focusAfter(4, Qt::Key_Up), 2);
  EXPECT_EQ(focusAfter(4, Qt::Key_Down), 4) << "there is no row below";
  EXPECT_EQ(buttons.chosen(), -1);
}

TEST_F(OptionButtonsTest, SpaceEnterAndDigitsChoose) {
  QTest::keyClick(buttons_.button(2), Qt::Key_Space);
  EXPECT_EQ(buttons_.chosen(), 2);
  QTest::keyClick(buttons_.button(0), Qt::Key_Return);
  EXPECT_EQ(buttons_.chosen(), 0);
  QTest::keyClick(buttons_.button(0), Qt::Key_2);
  EXPECT_EQ(buttons_.chosen(), 1);
}

TEST(OptionButtonsWithText, AreChosenByTheDigitOfTheirPosition) {
  OptionButtons buttons(
      {{"Soft", "soft"}, {"Firm", "firm"}, {"Hard", "hard"}}, 1, QStringLiteral("option"));
  buttons.show();
  for (const int place : {1, 3, 2, 1}) {
    QTest::keyClick(buttons.button(1), static_cast<Qt::Key>(Qt::Key_0 + place));
    EXPECT_EQ(buttons.chosen(), place - 1);
  }
  for (const auto key : {Qt::Key_0, Qt::Key_4, Qt::Key_9}) {
    QTest::keyClick(buttons.button(1), key);
    EXPECT_EQ(buttons.chosen(), 0) << "there is no option at that place";
  }
}

TEST(OptionButtonsWithText, FillTheRingOfTheChosenOneOnly) {
  OptionButtons options(
      {{QStringLiteral("Often"), {}}, {QStringLiteral("Never"), {}}}, 1, QStringLiteral("option"));
  setWindowTheme(options, ThemeName::Light);
  options.show();
  options.choose(0);
  const auto ring = [&](int index) {
    const auto picture = options.button(index)->grab().toImage();
    constexpr int kEdgeToCentre = 22;
    return picture.pixelColor(kEdgeToCentre, picture.height() / 2);
  };
  EXPECT_EQ(ring(0), themeNamed(ThemeName::Light).accent.text);
  EXPECT_EQ(ring(1), themeNamed(ThemeName::Light).field.background);
}

TEST_F(OptionButtonsTest, AScreenReaderCanChoose) {
  QSignalSpy spy(&buttons_, &OptionButtons::chosenChanged);
  auto* accessible = QAccessible::queryAccessibleInterface(buttons_.button(2));
  ASSERT_NE(accessible, nullptr);
  accessible->actionInterface()->doAction(QAccessibleActionInterface::toggleAction());
  EXPECT_EQ(buttons_.chosen(), 2);
  EXPECT_EQ(spy.count(), 1);
  EXPECT_EQ(accessible->text(QAccessible::Name), QStringLiteral("three of five"));
}

}  // namespace option_buttons_test
}  // namespace study::gui
