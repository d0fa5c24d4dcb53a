// Every answered item is described, whether or not a family compares it.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/summary/within_analysis.h"
#include "study/report/study_parts.h"
#include "study/results/answer_tables.h"
#include "study/results/item_summaries.h"
#include "tests/study/made_study.h"
#include "tests/study/report/section.h"

namespace study {
namespace items_test {

using questionnaires::ItemType;
using questionnaires::LocalizedText;

LocalizedText inEnglish(const std::string& text) {
  return LocalizedText(std::map<std::string, std::string>{{"en", text}});
}

questionnaires::Item item(const std::string& id, ItemType type) {
  questionnaires::Item made;
  made.id = id;
  made.type = type;
  made.text = inEnglish("Question <" + id + ">");
  return made;
}

questionnaires::Instrument mine() {
  questionnaires::Instrument made;
  made.id = "mine";
  made.title = inEnglish("My form");
  made.items = {
      item("vas", ItemType::Slider),
      item("hand", ItemType::SingleChoice),
      item("why", ItemType::ShortText),
      item("name", ItemType::ShortText)};
  made.items[1].options = {{"left", inEnglish("The left")}, {"right", inEnglish("The right")}};
  made.items[3].isIdentifying = true;
  return made;
}

/// Answers of two surgeons and a student to a form after two conditions.
struct Answered {
  protocols::LoadedProtocol loaded = tests::protocolFrom(tests::shortProtocol());
  std::map<SessionId, storage::SessionRecord> sessions;
  std::vector<storage::AnswerRecord> answers;
  std::map<storage::Records::Alternative, std::string> allocation;
  std::string block;

  Answered() {
    loaded.instruments.push_back(mine());
    for (const auto& phase : loaded.protocol.phases) {
      if (phase.type == protocols::PhaseType::Block) block = phase.id;
    }
    int number = 0;
    for (const auto* cohort : {"surgeons", "surgeons", "surgeons", "students"}) {
      const SessionId id{++number};
      auto& session = sessions[id];
      session.id = id;
      session.participant = "P" + std::to_string(number);
      session.cohort = cohort;
    }
  }

  void add(
      int session,
      const std::string& condition,
      const std::string& id,
      questionnaires::Response response,
      const std::string& phase = {}) {
    storage::AnswerRecord record;
    record.step.visit = {.session = SessionId{session}, .step = static_cast<int>(answers.size())};
    record.step.phase = phase.empty() ? block : phase;
    record.step.instrument = "mine";
    record.step.condition = condition;
    record.answer.item = id;
    record.answer.response = std::move(response);
    answers.push_back(record);
  }

  ItemResults described() const { return summariseItems(loaded, sessions, answers, allocation); }
};

TEST(ItemSummaries, TakeTheMeanOfEachParticipant) {
  Answered study;
  study.add(1, "kalman", "vas", 50.0);
  study.add(1, "kalman", "vas", 70.0);
  study.add(2, "kalman", "vas", 70.0);
  study.add(3, "kalman", "vas", 83.0);
  study.add(4, "kalman", "vas", 5.0);
  const auto items = study.described().items;
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].cohort, "surgeons");
  EXPECT_EQ(items[0].answers, 4U);
  // R: x <- c(60, 70, 83); mean(x); sd(x); median(x)
  EXPECT_DOUBLE_EQ(*items[0].mean, 71.0);
  EXPECT_NEAR(*items[0].standardDeviation, 11.53256259467079, 1e-12);
  EXPECT_EQ(items[0].median, 70.0);
  EXPECT_EQ(items[0].least, 60.0);
  EXPECT_EQ(items[0].most, 83.0);
  EXPECT_EQ(items[1].cohort, "students");
  EXPECT_FALSE(items[1].standardDeviation);
}

TEST(ItemSummaries, CountOptionsAndKeepTheOrderOfConditions) {
  Answered study;
  study.add(1, "kalman", "hand", std::string("right"));
  study.add(2, "kalman", "hand", std::string("right"));
  study.add(1, "interpolation", "hand", std::string("left"));
  const auto items = study.described().items;
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].condition, "interpolation");
  using Counts = std::vector<std::pair<std::string, std::uint64_t>>;
  EXPECT_EQ(items[0].options, (Counts{{"left", 1}, {"right", 0}}));
  EXPECT_EQ(items[1].options, (Counts{{"left", 0}, {"right", 2}}));
}

TEST(ItemSummaries, QuoteByConditionAndNeverWhoSomebodyIs) {
  Answered study;
  study.add(1, "kalman", "why", std::string("too soft"));
  study.add(2, "kalman", "why", std::string("just right"));
  study.add(2, "interpolation", "why", std::string("real"));
  study.add(2, "kalman", "name", std::string("Jane Doe"));
  study.add(3, "kalman", "why", std::string(""));
  const auto first = study.loaded.protocol.phases.front().id;
  ASSERT_NE(first, study.block);
  study.add(3, "", "why", std::string("about myself"), first);
  const auto quotes = study.described().quotes;
  ASSERT_EQ(quotes.size(), 3U);
  EXPECT_EQ(quotes[0].text, "real");
  EXPECT_EQ(quotes[1].text, "just right");
  EXPECT_EQ(quotes[2].text, "too soft");
  EXPECT_EQ(quotes[2].condition, "kalman");
}

/// A family that compares the slider between two conditions.
protocols::Family familyOfSlider() {
  protocols::Family family{.id = "vas", .title = "VAS", .instrument = "mine", .items = {"vas"}};
  family.comparisons = {{"interpolation", "kalman"}};
  family.test = protocols::TestType::PairedT;
  return family;
}

TEST(FamilyOfASlider, ComparesItsAnswersAsPointsOfAScale) {
  Answered study;
  for (auto& phase : study.loaded.protocol.phases) {
    if (phase.id == study.block) phase.trials.questionnaires = {{.instrument = "mine"}};
  }
  const std::vector<std::pair<double, double>> given{{60, 40}, {70, 65}, {83, 60}};
  std::vector<std::string> people;
  for (std::size_t i = 0; i < given.size(); ++i) {
    people.push_back("P" + std::to_string(i + 1));
    study.add(static_cast<int>(i) + 1, "interpolation", "vas", given[i].first);
    study.add(static_cast<int>(i) + 1, "kalman", "vas", given[i].second);
    study.add(static_cast<int>(i) + 1, "kalman", "why", std::string("no number"));
  }
  study.add(1, "kalman", "vas", 40.5);  // between the points: of another version's slider
  std::vector<ParticipantAnswer> owned;
  for (auto& answer : study.answers) {
    answer.step.kind = StepKind::Questionnaire;
    owned.push_back({&study.sessions.at(answer.step.visit.session).participant, &answer});
  }
  const auto family = familyOfSlider();
  const auto table = answerTable(study.loaded, family, people, owned);
  EXPECT_EQ(table.lowest, 0);
  EXPECT_EQ(table.highest, 100);
  EXPECT_EQ(table.answers.size(), 6U);
  EXPECT_EQ(completeAnswerCounts(study.loaded, family, table), (std::vector<std::size_t>{1, 1}));
  const std::vector<analysis::DeclaredPair> pairs{{"interpolation", "kalman"}};
  const auto within = analysis::compareWithin(table, pairs, {});
  // R: t.test(c(60, 70, 83), c(40, 65, 60), paired = TRUE)
  const auto& test = within.rows.at(0).test("paired_t");
  EXPECT_DOUBLE_EQ(*test.estimate.value, 16.0);
  EXPECT_NEAR(*test.statistic.value, 2.8736848, 1e-7);
  EXPECT_EQ(within.ordinal.reason.key(), "too_many_points_for_order");
  EXPECT_TRUE(within.probabilities.empty());
}

/// Makes the block ask the instrument, and compares what was answered within people.
struct Compared {
  analysis::AnswerTable table;
  analysis::WithinAnalysis within;

  Compared(Answered& study, const protocols::Family& family) {
    std::vector<std::string> people;
    for (const auto& [id, session] : study.sessions) people.push_back(session.participant);
    std::vector<ParticipantAnswer> owned;
    for (auto& answer : study.answers) {
      answer.step.kind = StepKind::Questionnaire;
      owned.push_back({&study.sessions.at(answer.step.visit.session).participant, &answer});
    }
    for (auto& phase : study.loaded.protocol.phases) {
      if (phase.id == study.block) phase.trials.questionnaires = {{.instrument = "mine"}};
    }
    table = answerTable(study.loaded, family, people, owned);
    const std::vector<analysis::DeclaredPair> pairs{{"interpolation", "kalman"}};
    within = analysis::compareWithin(table, pairs, {});
  }
};

TEST(FamilyOfASlider, ComparesNumbersBetweenPoints) {
  Answered study;
  for (auto& item : study.loaded.instruments.back().items) item.step = 0.1;
  const std::vector<std::pair<double, double>> given{{0.3, 0.1}, {0.4, 0.2}, {0.8, 0.5}};
  for (std::size_t i = 0; i < given.size(); ++i) {
    study.add(static_cast<int>(i) + 1, "interpolation", "vas", given[i].first);
    study.add(static_cast<int>(i) + 1, "kalman", "vas", given[i].second);
  }
  const Compared compared(study, familyOfSlider());
  EXPECT_FALSE(compared.table.isPointScale);
  EXPECT_EQ(compared.table.answers.size(), 6U);
  EXPECT_FALSE(compared.table.sampleOf(0).points());
  EXPECT_DOUBLE_EQ(*compared.table.sampleOf(0).mean(), 0.5);
  // R: t.test(c(.3, .4, .8), c(.1, .2, .5), paired = TRUE)
  const auto& tests = compared.within.rows.at(0);
  EXPECT_NEAR(*tests.test("paired_t").statistic.value, 7.0, 1e-12);
  EXPECT_EQ(tests.test("sign_flip").p, 0.25);
  EXPECT_EQ(compared.within.ordinal.reason.key(), "no_points_to_order");
}

TEST(FamilyOfAScore, ComparesWhatEachFormComesTo) {
  Answered study;
  auto& mine = study.loaded.instruments.back();
  mine.items.push_back(item("effort", ItemType::Slider));
  mine.items.back().key = -1;
  mine.scores.push_back({.id = "total", .items = {"vas", "effort"}});
  const auto form = [&](int person, const std::string& condition, double vas, double effort) {
    study.add(person, condition, "vas", vas);
    study.answers.push_back(study.answers.back());  // of the same visit
    study.answers.back().answer = {.item = "effort", .response = effort};
  };
  form(1, "interpolation", 80, 35);  // (80 + (100 - 35)) / 2
  form(1, "kalman", 50, 50);
  form(2, "interpolation", 61, 40);
  form(2, "kalman", 41, 60);
  study.add(3, "kalman", "vas", 90.0);  // no effort: no score
  auto family = familyOfSlider();
  family.items.clear();
  family.score = "total";
  const Compared compared(study, family);
  ASSERT_EQ(compared.table.answers.size(), 4U);
  EXPECT_EQ(compared.table.statements, std::vector<std::string>{"total"});
  EXPECT_EQ(compared.table.answers[0].score, 72.5);
  EXPECT_EQ(compared.table.lowest, 0.0);
  EXPECT_EQ(compared.table.highest, 100.0);
  EXPECT_EQ(
      completeAnswerCounts(study.loaded, family, compared.table), (std::vector<std::size_t>{1, 1}));
  const auto& test = compared.within.rows.at(0).test("paired_t");
  EXPECT_EQ(test.n1, 2U);
  EXPECT_DOUBLE_EQ(*test.estimate.value, 21.25);
  EXPECT_TRUE(comparativeStatements(study.loaded, family, compared.table).empty());
}

TEST(ComparedScale, IsOfPointsForSlidersAndNumbersInWholeSteps) {
  auto slider = item("vas", ItemType::Slider);
  EXPECT_EQ(protocols::scaleOf(slider), (protocols::ComparedScale{0, 100, true}));
  slider.step = 0.5;
  EXPECT_EQ(protocols::scaleOf(slider), (protocols::ComparedScale{0, 100, false}));
  slider.step = 5.0;
  slider.most = 1023.0;
  EXPECT_EQ(protocols::scaleOf(slider), (protocols::ComparedScale{0, 1023, true}));
  slider.most = 1024.0;
  EXPECT_EQ(protocols::scaleOf(slider), (protocols::ComparedScale{0, 1024, false}));
  EXPECT_FALSE(protocols::scaleOf(item("why", ItemType::ShortText)));
}

TEST(ItemSummaries, LeaveOutCohortsAndConditionsThatALaterVersionDropped) {
  Answered study;
  study.add(1, "kalman", "vas", 50.0);
  study.add(1, "interpolation", "vas", 60.0);
  study.add(1, "interpolation", "why", std::string("dropped"));
  study.add(4, "kalman", "vas", 70.0);
  study.add(4, "", "hand", std::string("left"));
  auto& protocol = study.loaded.protocol;
  std::erase_if(protocol.conditions, [](const auto& one) { return one.id == "interpolation"; });
  std::erase_if(protocol.cohorts, [](const auto& one) { return one.id == "students"; });
  const auto described = study.described();
  ASSERT_EQ(described.items.size(), 1U);
  EXPECT_EQ(described.items[0].condition, "kalman");
  EXPECT_EQ(described.items[0].cohort, "surgeons");
  EXPECT_TRUE(described.quotes.empty());
}

TEST(ItemSummaries, ShowNotesOfTheOperatorApartFromWhatParticipantsWrote) {
  auto section = tests::madeUpSection();
  section.instruments.push_back(mine());
  section.results.answers.quotes = {
      {.instrument = "mine", .item = "why", .condition = "kalman", .text = "soft"},
      {.instrument = "mine", .item = "why", .condition = "", .text = "hesitated", .isNote = true}};
  const auto quotes = report::quotesAsHtml(section);
  const auto notes = quotes.find("<h4>What the operator wrote down</h4>");
  ASSERT_NE(notes, std::string::npos) << quotes;
  EXPECT_LT(quotes.find("soft"), notes);
  EXPECT_GT(quotes.find("hesitated"), notes);
  section.results.answers.quotes.pop_back();
  EXPECT_EQ(report::quotesAsHtml(section).find("<h4>"), std::string::npos);
}

TEST(ItemSummaries, AreShownInTheReport) {
  Answered study;
  study.add(1, "kalman", "vas", 50.0);
  study.add(2, "kalman", "vas", 62.5);
  study.add(2, "kalman", "hand", std::string("right"));
  study.add(2, "kalman", "why", std::string("a <bit> soft"));
  auto section = tests::madeUpSection();
  section.instruments.push_back(mine());
  section.results.answers = study.described();
  for (auto& summary : section.results.answers.items) summary.cohort = "professional";
  const auto items = report::itemsAsHtml(section);
  EXPECT_NE(
      items.find("<em>Question &lt;vas&gt;</em></td></tr>\n"
                 "<tr><td>Orthopaedic surgeons</td><td>2</td><td>56.25 (8.84)</td></tr>"),
      std::string::npos)
      << items;
  EXPECT_NE(items.find("<td class=\"words\">The right (1)</td>"), std::string::npos) << items;
  EXPECT_EQ(items.find("<figure>"), std::string::npos);
  section.figures.items = {{"mine", "vas", "<svg>1</svg>"}, {"mine", "hand", "<svg>2</svg>"}};
  const auto illustrated = report::itemsAsHtml(section);
  EXPECT_NE(
      illustrated.find("by alternative: <a href=\"#item-mine-vas\"></a>, "
                       "<a href=\"#item-mine-hand\"></a>.</p>"),
      std::string::npos)
      << illustrated;
  EXPECT_NE(
      illustrated.find(
          "<svg>2</svg><figcaption id=\"item-mine-hand\">“Question &lt;hand&gt;”: how"),
      std::string::npos)
      << illustrated;
  const auto quotes = report::quotesAsHtml(section);
  EXPECT_NE(
      quotes.find("<p><b>Question &lt;why&gt;</b> <em>KF</em>: “a &lt;bit&gt; soft”</p>"),
      std::string::npos)
      << quotes;
  section.hasQuotes = false;
  EXPECT_EQ(report::quotesAsHtml(section), "");
}

TEST(ItemSummaries, MarkReversedQuestionsAndSayTextsThatAreAlikeOnce) {
  auto section = tests::madeUpSection();
  section.instruments.push_back(mine());
  auto& reversed = section.instruments.back().items;
  std::ranges::find(reversed, "vas", &questionnaires::Item::id)->key = -1;
  section.results.answers.items = {
      {.instrument = "mine",
       .item = "vas",
       .cohort = "professional",
       .values = {3.0, 4.0},
       .mean = 3.5}};
  const auto page = report::itemsAsHtml(section);
  EXPECT_NE(page.find("Question &lt;vas&gt; (R)</td>"), std::string::npos) << page;
  EXPECT_NE(page.find("(R): a high answer is bad"), std::string::npos) << page;
  section.results.answers.quotes = {
      {"mine", "why", "kalman", "simulated"}, {"mine", "why", "kalman", "simulated"}};
  EXPECT_EQ(report::quotesAsHtml(section), "<p>Simulated participants write nothing.</p>\n");
  section.results.runMode = RunMode::Live;
  EXPECT_EQ(report::quotesAsHtml(section), "<p>Each of the 2 texts is only “simulated”.</p>\n");
}

/// The published study asks two of its statements about two methods each, as items of their own.
TEST(ItemSummaries, PutTheSameStatementAboutSeveralAlternativesInOneRow) {
  auto section = tests::madeUpSection();
  auto other = mine();
  other.items.push_back(other.items.front());
  other.items.back().id = "vas-2";
  section.instruments.push_back(other);
  const auto answers = [](const char* item, const char* condition, double mean) {
    return ItemSummary{
        .instrument = "mine",
        .item = item,
        .cohort = "professional",
        .condition = condition,
        .values = {mean, mean},
        .mean = mean,
        .standardDeviation = 0.0};
  };
  section.results.answers.items = {
      answers("vas", "interpolation", 3.5), answers("vas-2", "kalman", 4.5)};
  EXPECT_NE(
      report::itemsAsHtml(section).find("<td>2</td><td>3.50 (0.00)</td><td>4.50 (0.00)</td></tr>"),
      std::string::npos)
      << report::itemsAsHtml(section);
  section.results.answers.items.back().values.push_back(4.5);
  EXPECT_NE(report::itemsAsHtml(section).find("<td>3</td>"), std::string::npos)
      << "of other people, in a row of its own";
}

TEST(ScaleInWords, HasTheWordsAtTheEndsOfASlider) {
  auto demand = item("mental", ItemType::Slider);
  demand.scale.lowLabel = demand.scale.highLabel = inEnglish("-");
  demand.leftText = inEnglish("Very low");
  demand.rightText = inEnglish("Very high");
  using Items = std::vector<const questionnaires::Item*>;
  const words::Words english;
  EXPECT_EQ(
      report::scaleInWords(Items{&demand}, english), "scale from 0 (Very low) to 100 (Very high)");
  auto performance = demand;
  performance.rightText = inEnglish("Failure");
  EXPECT_EQ(report::scaleInWords(Items{&demand, &performance}, english), "scale from 0 to 100");
}

TEST(ScaleInWords, HasNoWordsOfTheFormsPointsAtTheEndsOfANumber) {
  auto knees = item("knees", ItemType::Number);
  knees.most = 20000.0;
  knees.scale.lowLabel = knees.scale.highLabel = inEnglish("-");
  EXPECT_EQ(report::scaleInWords({&knees}, words::Words()), "scale from 0 to 20000");
}

TEST(ItemSummaries, OfOnePersonAreNotShownInTheReport) {
  auto section = tests::madeUpSection();
  section.instruments.push_back(mine());
  auto& items = section.results.answers.items;
  items = {
      {.instrument = "mine",
       .item = "vas",
       .cohort = "professional",
       .condition = "kalman",
       .values = {61.0},
       .mean = 61.0},
      {.instrument = "mine",
       .item = "vas",
       .cohort = "professional",
       .values = {62.0},
       .mean = 62.0},
      {.instrument = "mine",
       .item = "hand",
       .cohort = "professional",
       .answers = 6,
       .options = {{"left", 1}, {"right", 4}, {"other", 1}}},
      {.instrument = "mine",
       .item = "hand",
       .cohort = "non-professional",
       .answers = 1,
       .options = {{"left", 1}, {"right", 0}}}};
  const auto page = report::itemsAsHtml(section);
  EXPECT_EQ(page.find("61"), std::string::npos) << page;
  EXPECT_EQ(page.find("62"), std::string::npos) << page;
  EXPECT_EQ(page.find("The left"), std::string::npos) << page;
  EXPECT_EQ(page.find("Non-professionals"), std::string::npos) << "all that it had is hidden";
  EXPECT_NE(page.find("To protect anonymity"), std::string::npos) << page;
  EXPECT_NE(page.find("3 rows are left out, because"), std::string::npos) << page;
  EXPECT_NE(page.find("The right (4), other answers (2)"), std::string::npos) << page;
  EXPECT_EQ(page.find("left the question open"), std::string::npos) << "all of them answered";
  items[2].answers = 5;
  EXPECT_NE(
      report::itemsAsHtml(section).find("without a row has no answers that can be shown"),
      std::string::npos);
  items[2].options = {{"left", 1}, {"right", 1}, {"other", 1}};
  EXPECT_EQ(report::itemsAsHtml(section).find("other answers (3)"), std::string::npos)
      << "a row of hidden options alone";
  items[2].options = {{"left", 2}, {"right", 3}};
  const auto shown = report::itemsAsHtml(section);
  EXPECT_NE(shown.find("The left (2), The right (3)"), std::string::npos) << shown;
}

}  // namespace items_test
}  // namespace study
