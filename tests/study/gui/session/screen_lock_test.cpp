// One screen shared by operator and participant: the lock of the participant's window, and the stop
// keys that work in every window.
#include "study/gui/session/screen_lock.h"

#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QKeyEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include "study/gui/session/stop_key.h"
#include "tests/study/gui/participant.h"

namespace study::gui {
namespace screen_lock_test {

TEST(OperatorPin, IsFourToTwelveDigits) {
  for (const auto* words : {"1234", "000000000000"}) {
    EXPECT_FALSE(OperatorPin::pinProblem(QString::fromUtf8(words))) << words;
  }
  for (const auto* words : {"", "123", "1234567890123", "12a4", "１２３４", " 1234"}) {
    EXPECT_TRUE(OperatorPin::pinProblem(QString::fromUtf8(words))) << words;
  }
}

TEST(OperatorPin, OpensOnlyWithTheChosenDigits) {
  OperatorPin pin;
  EXPECT_FALSE(pin.acceptsPin({}));
  pin.choose(QStringLiteral("2468"));
  EXPECT_FALSE(pin.acceptsPin(QStringLiteral("24680")));
  EXPECT_TRUE(pin.acceptsPin(QStringLiteral("2468")));
}

TEST(OperatorPin, DelaysTriesAfterWrongOnes) {
  OperatorPin pin;
  pin.choose(QStringLiteral("2468"));
  for (int i = 0; i < OperatorPin::kFreeTries; ++i) {
    EXPECT_EQ(pin.secondsUntilNextTry(), 0);
    EXPECT_FALSE(pin.acceptsPin(QStringLiteral("1111")));
  }
  EXPECT_GT(pin.secondsUntilNextTry(), 0);
  EXPECT_LE(pin.secondsUntilNextTry(), OperatorPin::kWait);
  EXPECT_FALSE(pin.acceptsPin(QStringLiteral("2468"))) << "no try is allowed during the wait";
}

class LockedWindow : public testing::Test {
 protected:
  LockedWindow() {
    (new QVBoxLayout(&window_))->addWidget(button_);
    button_->setText(QStringLiteral("Researcher"));
    pin_.choose(QStringLiteral("2468"));
    window_.resize(900, 600);
    window_.show();
    lock_.lock();
  }

  void enter(const char* digits) {
    QTest::mouseClick(button_, Qt::LeftButton);
    auto* line = window_.findChild<QLineEdit*>();
    ASSERT_NE(line, nullptr);
    QTest::keyClicks(line, QString::fromUtf8(digits));
    tests::photograph(window_, QStringLiteral("locked"));
    QTest::keyClick(line, Qt::Key_Return);
  }

  OperatorPin pin_;
  QWidget window_;
  QPushButton* button_ = new QPushButton(&window_);
  ScreenLock lock_{window_, *button_, pin_};
};

TEST_F(LockedWindow, CoversTheScreenAndStaysInFront) {
  EXPECT_TRUE(lock_.isLocked());
  EXPECT_TRUE(window_.isFullScreen());
  EXPECT_TRUE(window_.windowFlags().testFlag(Qt::WindowStaysOnTopHint));
  EXPECT_TRUE(button_->isVisible());
}

TEST_F(LockedWindow, StaysLockedForAWrongPin) {
  enter("1357");
  EXPECT_TRUE(lock_.isLocked());
  EXPECT_TRUE(window_.isFullScreen());
  EXPECT_TRUE(window_.findChild<QLineEdit*>()->text().isEmpty()) << "the wrong PIN is cleared";
}

TEST_F(LockedWindow, UnlocksWithThePin) {
  QSignalSpy opened(&lock_, &ScreenLock::opened);
  enter("2468");
  EXPECT_EQ(opened.count(), 1);
  EXPECT_FALSE(lock_.isLocked());
  EXPECT_FALSE(window_.isFullScreen());
  EXPECT_FALSE(window_.windowFlags().testFlag(Qt::WindowStaysOnTopHint));
  EXPECT_FALSE(button_->isVisible());
}

TEST_F(LockedWindow, LetsTheStopKeyStopAlsoWhileThePinIsTyped) {
  StopKey stop;
  QSignalSpy pressed(&stop, &StopKey::pressed);
  stop.setArmed(true);
  QTest::keyClick(&window_, Qt::Key_Escape);
  EXPECT_EQ(pressed.count(), 1);
  QTest::mouseClick(button_, Qt::LeftButton);
  QTest::keyClick(window_.findChild<QLineEdit*>(), Qt::Key_F12);
  EXPECT_EQ(pressed.count(), 2);
  EXPECT_TRUE(lock_.isLocked());
}

TEST(StopKey, WorksInDialogsWhileArmed) {
  StopKey stop;
  QSignalSpy pressed(&stop, &StopKey::pressed);
  QDialog dialog;
  dialog.show();
  stop.setArmed(true);
  for (const auto key : {Qt::Key_Escape, Qt::Key_Pause, Qt::Key_F12}) QTest::keyClick(&dialog, key);
  EXPECT_EQ(pressed.count(), 3);
  EXPECT_TRUE(dialog.isVisible()) << "an armed key does not close the dialog";
  QTest::keyClick(&dialog, Qt::Key_A);
  EXPECT_EQ(pressed.count(), 3);

  stop.setArmed(false);
  QTest::keyClick(&dialog, Qt::Key_Escape);
  EXPECT_EQ(pressed.count(), 3);
  EXPECT_FALSE(dialog.isVisible());
}

TEST(StopKey, LetsEscapeCloseAListInATrial) {
  StopKey stop;
  QSignalSpy pressed(&stop, &StopKey::pressed);
  QComboBox box;
  box.addItems({QStringLiteral("one"), QStringLiteral("two")});
  box.show();
  stop.setArmed(true);
  box.showPopup();
  auto* list = QApplication::activePopupWidget();
  ASSERT_NE(list, nullptr);
  QTest::keyClick(box.view(), Qt::Key_Escape);
  EXPECT_EQ(pressed.count(), 0);
  EXPECT_FALSE(list->isVisible());
  QTest::keyClick(&box, Qt::Key_Escape);
  EXPECT_EQ(pressed.count(), 1);
}

TEST(StopKey, StopsByTheNextEscapeAfterOneThatAShortcutTook) {
  StopKey stop;
  QSignalSpy pressed(&stop, &StopKey::pressed);
  QComboBox box;
  box.addItem(QStringLiteral("one"));
  box.show();
  stop.setArmed(true);
  box.showPopup();
  QKeyEvent before(QEvent::ShortcutOverride, Qt::Key_Escape, Qt::NoModifier);
  QApplication::sendEvent(box.view(), &before);  // and no key press after it
  box.hidePopup();
  QApplication::processEvents();
  QTest::keyClick(&box, Qt::Key_Escape);
  EXPECT_EQ(pressed.count(), 1);
}

}  // namespace screen_lock_test
}  // namespace study::gui
