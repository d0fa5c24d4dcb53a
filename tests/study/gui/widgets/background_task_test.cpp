#include "study/gui/widgets/background_task.h"

#include <atomic>
#include <future>
#include <stdexcept>

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>

#include "study/gui/widgets/message_box.h"
#include "tests/study/gui/participant.h"

namespace study::gui {
namespace background_task_test {

using Cancelling = BackgroundTask::Cancelling;

TEST(BackgroundTask, RunsInItsOwnThreadWhileTheWindowResponds) {
  std::promise<void> go;
  std::thread::id worker;
  BackgroundTask task(QStringLiteral("Working"), [&](const Progress& progress) {
    worker = std::this_thread::get_id();
    progress(0.25, "a quarter");
    go.get_future().wait();
  });
  task.show();
  auto* bar = task.findChild<QProgressBar*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar->maximum() > 0; }));
  EXPECT_EQ(bar->value() * 4, bar->maximum());
  bool says = false;
  for (auto* label : task.findChildren<QLabel*>()) says |= label->text() == "A quarter";
  EXPECT_TRUE(says);
  tests::photograph(task, QStringLiteral("task"));
  go.set_value();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !task.isVisible(); }));
  EXPECT_EQ(task.failure(), nullptr);
  EXPECT_NE(worker, std::this_thread::get_id());
}

TEST(BackgroundTask, ShowsABusyBarWithoutAShare) {
  std::promise<void> go;
  std::atomic<bool> hasTold{false};
  BackgroundTask task(QStringLiteral("Working"), [&](const Progress& progress) {
    progress(kUnknownShare, "computing");
    hasTold = true;
    go.get_future().wait();
  });
  task.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return hasTold.load(); }));
  QTest::qWait(120);
  EXPECT_EQ(task.findChild<QProgressBar*>()->maximum(), 0);
  go.set_value();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !task.isVisible(); }));
}

TEST(BackgroundTask, IsCancelledAtTheNextProgressCall) {
  std::atomic<int> told{0};
  BackgroundTask task(QStringLiteral("Working"), [&](const Progress& progress) {
    while (true) {
      progress(0.5, "again");
      ++told;
      std::this_thread::yield();
    }
  });
  task.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return told > 0; }));
  QTest::mouseClick(tests::buttonSaying(&task, QStringLiteral("Cancel")), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !task.isVisible(); }));
  EXPECT_THROW(std::rethrow_exception(task.failure()), Cancelled);
}

TEST(BackgroundTask, HasNoCancelButtonIfItCannotBeCancelled) {
  std::promise<void> go;
  BackgroundTask task(
      QStringLiteral("Working"),
      [&](const Progress&) { go.get_future().wait(); },
      Cancelling::Impossible);
  task.show();
  EXPECT_EQ(tests::buttonSaying(&task, QStringLiteral("Cancel")), nullptr);
  QTest::keyClick(&task, Qt::Key_Escape);
  EXPECT_TRUE(task.isVisible());
  go.set_value();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !task.isVisible(); }));
}

TEST(BackgroundTask, ShowsTheMessageOfTheException) {
  QString told;
  QTimer look;
  QObject::connect(&look, &QTimer::timeout, &look, [&] {
    auto* box = qobject_cast<MessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr) return;
    told = box->words();
    box->accept();
  });
  look.start(20);
  const bool isDone = BackgroundTask::run(
      nullptr, QStringLiteral("Working"), MessageTopic::ReportNotWritten, [](const Progress&) {
        throw std::runtime_error("The disk is full. Free some space.");
      });
  EXPECT_FALSE(isDone);
  EXPECT_EQ(
      told,
      QStringLiteral("The report was not written.\n\nThe disk is full. Free some space.\n\n"
                     "Nothing in the study was changed."));
}

}  // namespace background_task_test
}  // namespace study::gui
