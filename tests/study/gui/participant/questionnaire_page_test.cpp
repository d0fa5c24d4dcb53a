#include "study/gui/participant/questionnaire_page.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include <gtest/gtest.h>

#include <QDate>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QTest>
#include <QTimer>
#include <QWindow>

#include "questionnaires/reading/instrument_file.h"
#include "study/gui/participant/answer_slider.h"
#include "study/gui/participant/option_buttons.h"

namespace study::gui {
namespace questionnaire_page_test {

/// The items of a shipped questionnaire, all on one sheet.
std::vector<questionnaires::Item> itemsOf(const std::string& name) {
  for (const auto& file : questionnaires::libraryFiles()) {
    if (file.name != name + ".json") continue;
    auto items = questionnaires::readValidInstrument(file.content, name).items;
    for (auto& item : items) item.startsPage = false;
    return items;
  }
  ADD_FAILURE() << name;
  return {};
}

/// A page and the answers that it has emitted.
struct Shown {
  explicit Shown(
      std::vector<questionnaires::Item> items, const std::vector<GivenAnswer>& before = {})
      : page({.title = "T", .items = std::move(items), .language = "en", .before = before}) {
    QObject::connect(&page, &QuestionnairePage::answered, [this](const GivenAnswer& answer) {
      answers.push_back(answer);
    });
    QObject::connect(&page, &QuestionnairePage::retracted, [this](const QString& item) {
      retracted.push_back(item.toStdString());
    });
    page.resize(1000, 760);
    page.show();
  }

  QuestionnairePage page;
  std::vector<GivenAnswer> answers;
  std::vector<std::string> retracted;
};

TEST(QuestionnairePage, IsCompleteOnlyWhenEveryRequiredItemIsAnswered) {
  Shown shown(itemsOf("realism-common"));
  EXPECT_FALSE(shown.page.isComplete());
  const auto rows = shown.page.findChildren<OptionButtons*>();
  for (auto* row : rows) {
    EXPECT_FALSE(shown.page.isComplete());
    QTest::mouseClick(row->button(2), Qt::LeftButton);
  }
  EXPECT_TRUE(shown.page.isComplete());
  EXPECT_EQ(shown.answers.size(), static_cast<std::size_t>(rows.size()));
}

TEST(QuestionnairePage, EmitsNoAnswerForUntouchedItems) {
  Shown shown(itemsOf("nasa-tlx-raw"));
  shown.page.flush();
  EXPECT_TRUE(shown.answers.empty());
  EXPECT_FALSE(shown.page.isComplete());
}

TEST(QuestionnairePage, RecordsFirstTouchAndNumberOfChanges) {
  Shown shown(itemsOf("realism-common"));
  auto* row = shown.page.findChildren<OptionButtons*>().front();
  QTest::mouseClick(row->button(0), Qt::LeftButton);
  QTest::qWait(20);
  QTest::mouseClick(row->button(4), Qt::LeftButton);
  ASSERT_EQ(shown.answers.size(), 2U);
  EXPECT_EQ(shown.answers[0].changes, 0);
  EXPECT_EQ(shown.answers[1].changes, 1);
  EXPECT_EQ(shown.answers[1].firstTouch, shown.answers[0].firstTouch);
  EXPECT_GT(shown.answers[1].responseTime, shown.answers[1].firstTouch);
  EXPECT_EQ(shown.answers[1].response, questionnaires::Response(std::int64_t{5}));
}

TEST(QuestionnairePage, GoesOnCountingChangesOfAnEarlierAnswer) {
  const auto items = itemsOf("realism-common");
  Shown shown(
      items,
      {{.item = items[1].id,
        .response = std::int64_t{4},
        .itemOrder = 2,
        .firstTouch = 1.5,
        .responseTime = 2.5,
        .changes = 3,
        .language = "en"}});
  QTest::mouseClick(shown.page.findChildren<OptionButtons*>()[1]->button(0), Qt::LeftButton);
  ASSERT_EQ(shown.answers.size(), 1U);
  EXPECT_EQ(shown.answers[0].changes, 4);
  EXPECT_EQ(shown.answers[0].firstTouch, 1.5);
}

TEST(QuestionnairePage, ShowsEarlierAnswersWithoutEmittingThem) {
  const auto items = itemsOf("realism-common");
  Shown shown(
      items,
      {{.item = items[1].id, .response = std::int64_t{4}, .itemOrder = 2, .language = "en"}});
  EXPECT_EQ(shown.page.findChildren<OptionButtons*>()[1]->chosen(), 3);
  shown.page.flush();
  EXPECT_TRUE(shown.answers.empty());
}

TEST(QuestionnairePage, SetsASliderByMouseAndKeys) {
  Shown shown(itemsOf("nasa-tlx-raw"));
  auto* slider = shown.page.findChildren<AnswerSlider*>().front();
  EXPECT_FALSE(slider->isTouched());
  QTest::keyClick(slider, Qt::Key_Right);  // the first key puts the handle in the middle
  ASSERT_EQ(shown.answers.size(), 1U);
  EXPECT_EQ(shown.answers[0].response, questionnaires::Response(50.0));
  QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_EQ(shown.answers.back().response, questionnaires::Response(55.0));
  QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() - 2, 20));
  EXPECT_EQ(shown.answers.back().response, questionnaires::Response(100.0));
}

/// Three questions; the one in the middle is asked if the first is answered "yes".
std::vector<questionnaires::Item> itemsAroundAConditionalOne() {
  const auto text = [](const char* english) {
    return questionnaires::LocalizedText({{"en", english}});
  };
  std::vector<questionnaires::Item> items;
  for (const char* id : {"first", "conditional", "last"}) {
    items.push_back(
        {.id = id,
         .type = questionnaires::ItemType::SingleChoice,
         .text = text(id),
         .options = {{"yes", text("Yes")}, {"no", text("No")}}});
  }
  items[1].showIf = {.item = "first", .wantedOptions = {"yes"}};
  return items;
}

TEST(QuestionnairePage, IgnoresClicksRightAfterAnItemAppearedUnderThePointer) {
  Shown shown(itemsAroundAConditionalOne());
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&shown.page));
  auto* settling = shown.page.findChild<QTimer*>(QStringLiteral("settling"));
  ASSERT_NE(settling, nullptr);
  settling->setInterval(std::chrono::hours(1));  // this test knows no other end of it than its own
  const auto rows = shown.page.findChildren<OptionButtons*>();
  ASSERT_EQ(rows.size(), 3);
  const auto clickAt = [&](QPoint place) {  // as a mouse does: what lies there gets it
    QTest::mouseClick(shown.page.windowHandle(), Qt::LeftButton, {}, place);
    QCoreApplication::processEvents();
  };
  const auto placeOf = [&](QWidget* button) {
    return button->mapTo(&shown.page, button->rect().center());
  };
  const auto aimedAt = placeOf(rows[2]->button(0));
  clickAt(placeOf(rows[0]->button(0)));
  ASSERT_EQ(shown.answers.size(), 1U);
  ASSERT_TRUE(rows[1]->isVisible());
  ASSERT_NE(placeOf(rows[2]->button(0)), aimedAt);
  clickAt(aimedAt);
  clickAt(placeOf(rows[2]->button(0)));
  EXPECT_EQ(shown.answers.size(), 1U) << "what was aimed at has moved away";

  settling->start(0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !settling->isActive(); }));
  clickAt(placeOf(rows[2]->button(0)));
  ASSERT_EQ(shown.answers.size(), 2U);
  EXPECT_EQ(shown.answers.back().item, "last");
}

TEST(QuestionnairePage, RetractsADeletedAnswer) {
  Shown shown(itemsOf("preference"));
  auto* why = shown.page.findChild<QPlainTextEdit*>();
  QTest::keyClicks(why, QStringLiteral("because"));
  shown.page.flush();
  ASSERT_EQ(shown.answers.size(), 1U);
  EXPECT_EQ(shown.answers[0].response, questionnaires::Response(std::string("because")));
  why->clear();
  shown.page.flush();
  EXPECT_EQ(shown.retracted, std::vector<std::string>{"why"});
}

TEST(QuestionnairePage, KeepsUnicodeTextUnchanged) {
  Shown shown(itemsOf("preference"));
  const QString words =
      QString::fromUtf8("Fühlt sich echt an 👍🏽 — كأنه حقيقي\n„Knacks“");
  shown.page.findChild<QPlainTextEdit*>()->setPlainText(words);
  shown.page.flush();
  ASSERT_EQ(shown.answers.size(), 1U);
  EXPECT_EQ(shown.answers[0].response, questionnaires::Response(words.toStdString()));
}

TEST(QuestionnairePage, EmitsNumbersInRangeOnly) {
  questionnaires::Item item{
      .id = "years", .type = questionnaires::ItemType::Number, .least = 0, .most = 60};
  Shown shown({item});
  auto* line = shown.page.findChild<QLineEdit*>();
  for (const auto* words : {"", "abc", "-1", "61", "1e999", "nan"}) {
    line->setText(QString::fromUtf8(words));
    EXPECT_FALSE(shown.page.isComplete()) << words;
  }
  EXPECT_TRUE(shown.answers.empty());
  line->setText(QStringLiteral("12"));
  ASSERT_EQ(shown.answers.size(), 1U);
  EXPECT_EQ(shown.answers[0].response, questionnaires::Response(12.0));
}

TEST(QuestionnairePage, TakesADecimalCommaForADecimalPoint) {
  questionnaires::Item item{
      .id = "years", .type = questionnaires::ItemType::Number, .least = 0, .most = 60, .step = 0.5};
  Shown shown({item});
  for (const auto* words : {"2.5", "2,5", " 2,5 "}) {
    shown.page.findChild<QLineEdit*>()->setText(QString::fromUtf8(words));
    ASSERT_TRUE(shown.page.isComplete()) << words;
    EXPECT_EQ(shown.answers.back().response, questionnaires::Response(2.5)) << words;
  }
}

TEST(QuestionnairePage, CountsMarksAndFocusesWhatIsOpen) {
  Shown shown(itemsOf("realism-common"));
  ASSERT_TRUE(QTest::qWaitForWindowActive(&shown.page));
  const auto rows = shown.page.findChildren<OptionButtons*>();
  const auto required = static_cast<int>(rows.size());
  QTest::mouseClick(rows[0]->button(2), Qt::LeftButton);
  QTest::mouseClick(rows[1]->button(2), Qt::LeftButton);
  EXPECT_EQ(shown.page.progress().open, required - 2);
  EXPECT_EQ(shown.page.progress().required, required);
  const auto marks = [&] {
    std::vector<QLabel*> found;
    for (auto* label : shown.page.findChildren<QLabel*>()) {
      if (label->isVisible() && label->text() == QStringLiteral("Please answer this one")) {
        found.push_back(label);
      }
    }
    return found;
  };
  EXPECT_TRUE(marks().empty()) << "nobody has asked to go on";
  shown.page.scrollToFirstUnanswered();
  ASSERT_EQ(marks().size(), static_cast<std::size_t>(required) - 2) << "each that is open";
  EXPECT_TRUE(marks().front()->parentWidget()->isAncestorOf(rows[2]));
  EXPECT_TRUE(rows[2]->button(0)->hasFocus());
  QCoreApplication::processEvents();
  const auto place = rows[3]->mapTo(&shown.page, QPoint());
  QTest::mouseClick(rows[2]->button(0), Qt::LeftButton);
  QCoreApplication::processEvents();
  EXPECT_EQ(marks().size(), static_cast<std::size_t>(required) - 3);
  EXPECT_EQ(rows[3]->mapTo(&shown.page, QPoint()), place) << "it moved under the pointer";
}

TEST(QuestionnairePage, SaysInTheHeadingWhichQuestionsAreOptional) {
  Shown shown(itemsOf("preference"));
  QStringList optional;
  for (const auto* label : shown.page.findChildren<QLabel*>()) {
    if (label->text().contains(QStringLiteral("(optional)"))) optional << label->text();
  }
  ASSERT_EQ(optional.size(), 1);
  EXPECT_TRUE(optional.front().contains(QStringLiteral("Why? (optional)")))
      << optional.front().toStdString();
}

TEST(QuestionnairePage, ShowsOneSheetAfterTheOther) {
  auto items = itemsOf("realism-common");
  items[2].startsPage = true;
  Shown shown(items);
  EXPECT_EQ(shown.page.sheets(), 2);
  EXPECT_EQ(shown.page.progress().required, 2);
  EXPECT_FALSE(shown.page.turnSheet(false)) << "there is none before the first";
  EXPECT_TRUE(shown.page.turnSheet(true));
  const auto rows = shown.page.findChildren<OptionButtons*>();
  EXPECT_FALSE(rows[1]->isVisible());
  EXPECT_TRUE(rows[2]->isVisible());
  EXPECT_FALSE(shown.page.turnSheet(true));
  EXPECT_FALSE(shown.page.isComplete()) << "also the sheet that is not shown counts";
  EXPECT_TRUE(shown.page.turnSheet(false));
  EXPECT_TRUE(rows[1]->isVisible());
}

TEST(QuestionnairePage, AsksAndRetractsWhatDependsOnAnAnswer) {
  using questionnaires::ItemType;
  const auto yesAndNo = [] {
    questionnaires::Option yes{.id = "yes"};
    questionnaires::Option no{.id = "no"};
    return std::vector{yes, no};
  };
  Shown shown({
      {.id = "sure", .type = ItemType::SingleChoice, .options = yesAndNo()},
      {.id = "why",
       .type = ItemType::Number,
       .startsPage = true,
       .showIf = {.item = "sure", .wantedOptions = {"yes"}}},
  });
  auto* sure = shown.page.findChild<OptionButtons*>();
  auto* why = shown.page.findChild<QLineEdit*>();
  sure->choose(1);
  EXPECT_TRUE(shown.page.isComplete());
  EXPECT_FALSE(shown.page.turnSheet(true)) << "nothing is asked on the second sheet";
  sure->choose(0);
  EXPECT_FALSE(shown.page.isComplete());
  ASSERT_TRUE(shown.page.turnSheet(true));
  EXPECT_TRUE(why->isVisible());
  why->setText(QStringLiteral("7"));
  EXPECT_TRUE(shown.page.isComplete());
  sure->choose(1);
  EXPECT_EQ(shown.retracted, std::vector<std::string>{"why"});
  sure->choose(0);
  EXPECT_EQ(shown.answers.back().item, "why") << "what was written is still there";
}

TEST(QuestionnairePage, HasTheSignatureAndTheDateBelowTheConsent) {
  Shown shown(itemsOf("consent-punch"));
  QCoreApplication::processEvents();
  auto* consent = shown.page.findChildren<OptionButtons*>().front();
  auto* signature = shown.page.findChild<QLineEdit*>();
  const auto cardOf = [](const QWidget* widget) {
    while (widget->property("role") != QStringLiteral("card")) widget = widget->parentWidget();
    return widget;
  };
  const auto* card = cardOf(consent);
  ASSERT_EQ(cardOf(signature), card) << "the video is another question";
  const auto placeOf = [&](const QWidget& widget) {
    return QRect(widget.mapTo(card, QPoint(0, 0)), widget.size());
  };
  EXPECT_EQ(placeOf(*consent->button(0)).top(), placeOf(*consent->button(1)).top());
  EXPECT_GT(placeOf(*signature).top(), placeOf(*consent).bottom());
  const auto labels = card->findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->text() == QStringLiteral("Date: ") +
                                QLocale(QStringLiteral("en"))
                                    .toString(QDate::currentDate(), QStringLiteral("d MMMM yyyy"));
  }));
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->text().contains(QStringLiteral("counts without it. (optional)"));
  })) << "a name need not be given";
}

TEST(QuestionnairePage, ShowsWhatIsAgreedToInPartsOfItsOwn) {
  const auto clauses = [](const QuestionnairePage& page) {
    int count = 0;
    for (const auto* frame : page.findChildren<QFrame*>()) {
      if (frame->property("role") == QStringLiteral("clause")) ++count;
    }
    return count;
  };
  const QString text = QStringLiteral("One.\n\n# Heading\n\nTwo,\nstill two.");
  QuestionnairePage consent(
      {.title = {},
       .introduction = text,
       .items = itemsOf("consent-punch"),
       .choices = {},
       .language = QStringLiteral("en"),
       .before = {}});
  EXPECT_EQ(clauses(consent), 2) << "a heading belongs to what is below it";
  QuestionnairePage other(
      {.title = {},
       .introduction = text,
       .items = {},
       .choices = {},
       .language = QStringLiteral("en"),
       .before = {}});
  EXPECT_EQ(clauses(other), 0);
}

}  // namespace questionnaire_page_test
}  // namespace study::gui
