#include "study/gui/widgets/mnemonics.h"

#include <map>
#include <vector>

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

namespace study::gui {
namespace mnemonics_test {

TEST(Mnemonics, AreLettersThatNothingElseInTheWindowHas) {
  QWidget window;
  auto* layout = new QFormLayout(&window);
  auto* report = new QPushButton(QStringLiteral("Report…"), &window);
  auto* repeat = new QPushButton(QStringLiteral("Repeat…"), &window);
  auto* given = new QPushButton(QStringLiteral("R&un"), &window);
  auto* box = new QCheckBox(QStringLiteral("Ruler"), &window);
  auto* field = new QLineEdit(&window);
  layout->addRow(QStringLiteral("Reason"), field);
  addMnemonics(window);
  EXPECT_EQ(report->text(), QStringLiteral("&Report…"));
  EXPECT_EQ(repeat->text(), QStringLiteral("R&epeat…"));
  EXPECT_EQ(given->text(), QStringLiteral("R&un"));
  EXPECT_EQ(mnemonicOf(box->text()), QLatin1Char('L'));
  const auto* label = qobject_cast<QLabel*>(layout->labelForField(field));
  EXPECT_EQ(mnemonicOf(label->text()), QLatin1Char('A'));
}

TEST(Mnemonics, AreSharedByAsFewAsPossibleWhereLettersRunOut) {
  QWidget window;
  std::map<QChar, int> sharers;
  std::vector<QPushButton*> buttons;
  for (const auto* words : {"AB", "BA", "AAB", "ABB", "ABA", "AABB"}) {
    buttons.push_back(new QPushButton(QString::fromUtf8(words), &window));
  }
  addMnemonics(window);
  for (const auto* button : buttons) ++sharers[mnemonicOf(button->text())];
  EXPECT_EQ(sharers[u'A'], 3);
  EXPECT_EQ(sharers[u'B'], 3);
}

TEST(Mnemonics, AreTheSameForTheSameWords) {
  QWidget window;
  auto* one = new QPushButton(QStringLiteral("Open"), &window);
  auto* other = new QPushButton(QStringLiteral("Open"), &window);
  addMnemonics(window);
  EXPECT_EQ(one->text(), QStringLiteral("&Open"));
  EXPECT_EQ(other->text(), one->text());
}

TEST(Mnemonics, LeavePagesOfParticipantsAlone) {
  QWidget window;
  auto* page = new QWidget(&window);
  disableMnemonics(*page);
  auto* next = new QPushButton(QStringLiteral("Next"), page);
  addMnemonics(window);
  EXPECT_EQ(next->text(), QStringLiteral("Next"));
}

TEST(Mnemonics, AreGivenToMenusButNotToTheNamesOfKeys) {
  QMenu menu;
  auto* help = menu.addAction(QStringLiteral("…\tF1"));
  auto* tour = menu.addAction(QStringLiteral("Tour"));
  addMnemonics(menu);
  EXPECT_TRUE(mnemonicOf(help->text()).isNull());
  EXPECT_EQ(tour->text(), QStringLiteral("&Tour"));
}

TEST(Mnemonics, ComeBackWhenATextChanges) {
  auto& application = *qobject_cast<QApplication*>(QApplication::instance());
  installMnemonics(application);
  auto* filter = application.children().last();
  QWidget window;
  auto* layout = new QVBoxLayout(&window);
  auto* button = new QPushButton(QStringLiteral("Fill in"), &window);
  layout->addWidget(button);
  window.show();
  EXPECT_EQ(button->text(), QStringLiteral("&Fill in"));
  button->setText(QStringLiteral("Fill in the texts (16)"));
  QApplication::sendPostedEvents();
  QApplication::processEvents();
  EXPECT_EQ(button->text(), QStringLiteral("&Fill in the texts (16)"));
  delete filter;
}

}  // namespace mnemonics_test
}  // namespace study::gui
