// Columns of exported files: which declarations compile, which readers get them, and the types of
// their cells.
#include "study/export/column.h"

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

namespace study {
namespace column_test {

using namespace holds;

struct Row {
  std::string code;
  int count = 0;
  std::optional<double> seconds;
  bool isCounted = false;
};

/// Whether a column of these compiles.
template <typename... Arguments>
constexpr bool compiles() {
  return std::is_constructible_v<Column<Row>, const char*, Arguments...>;
}

TEST(Column, CompilesWithTypeDescriptionAndGetter) {
  EXPECT_TRUE((compiles<Text, const char*, decltype(&Row::code)>()));
  EXPECT_TRUE((compiles<Integer, const char*, decltype(&Row::count)>()));
  EXPECT_TRUE((compiles<Number, const char*, decltype(&Row::seconds)>()));
  EXPECT_TRUE((compiles<Boolean, const char*, decltype(&Row::isCounted)>()));
}

TEST(Column, DoesNotCompileWithoutATypeADescriptionOrAGetter) {
  EXPECT_FALSE((compiles<const char*, decltype(&Row::count)>()));
  EXPECT_FALSE((compiles<Integer, decltype(&Row::count)>()));
  EXPECT_FALSE((compiles<Integer, const char*>()));
  EXPECT_FALSE((std::is_default_constructible_v<Column<Row>>));
  EXPECT_FALSE((std::is_constructible_v<ExportedColumn, const char*, const char*>));
}

TEST(Column, DoesNotCompileIfItsGetterReturnsAnotherType) {
  EXPECT_FALSE((compiles<Text, const char*, decltype(&Row::count)>()));
  EXPECT_FALSE((compiles<Integer, const char*, decltype(&Row::seconds)>()));
  EXPECT_FALSE((compiles<Integer, const char*, decltype(&Row::isCounted)>()));
  EXPECT_FALSE((compiles<Number, const char*, decltype(&Row::count)>()));
  EXPECT_FALSE((compiles<Boolean, const char*, decltype(&Row::count)>()));
  EXPECT_FALSE((compiles<Utc, const char*, decltype(&Row::count)>()));
}

Table<Row> table() {
  return {
      .name = "rows",
      .description = "One row per row.",
      .columns = {
          Column<Row>("code", OneOf{ValueList::Cohorts}, "A code", &Row::code)
              .identifiesParticipant(),
          {"count", Integer{}, "How many", &Row::count},
          Column<Row>("secret", FreeText{}, "Which rendering it was", &Row::code)
              .revealsCondition()
              .inPublic("Which rendering, coded"),
          Column<Row>("seconds_s", Number{"s"}, "How long", &Row::seconds)
              .inPublicIfReleased("haste")}};
}

std::vector<std::string> namesFor(const Readers& readers) {
  std::vector<std::string> names;
  for (const auto& column : table().columns) {
    if (column.isFor(readers)) names.push_back(column.name());
  }
  return names;
}

using Names = std::vector<std::string>;

TEST(Column, DeclaresItsReaders) {
  EXPECT_EQ(namesFor({.isBlinded = false}), (Names{"code", "count", "secret", "seconds_s"}));
  EXPECT_EQ(namesFor({.isBlinded = true}), (Names{"code", "count", "seconds_s"}));
  EXPECT_EQ(
      namesFor({.isBlinded = true, .needParticipantColumn = false}), (Names{"count", "seconds_s"}));
  EXPECT_EQ(namesFor({.isBlinded = false, .isPublic = true}), (Names{"secret"}));
  EXPECT_EQ(
      namesFor({.isBlinded = true, .isPublic = true, .releasedIdentifiers = {"haste"}}),
      (Names{"seconds_s"}));
}

TEST(Column, IsDescribedForItsReaders) {
  const auto secret = table().columns[2];
  EXPECT_EQ(secret.exportedColumnFor({}).description, "Which rendering it was");
  EXPECT_TRUE(secret.exportedColumnFor({}).isFreeText);
  EXPECT_EQ(secret.exportedColumnFor({.isPublic = true}).description, "Which rendering, coded");
  EXPECT_FALSE(secret.exportedColumnFor({.isPublic = true}).isFreeText);

  const Readers readers{.lists = {{ValueList::Cohorts, {{"novices", "Novices"}}}}};
  ASSERT_EQ(table().columns[0].exportedColumnFor(readers).levels.size(), 1U);
  EXPECT_EQ(table().columns[0].exportedColumnFor(readers).levels[0].label, "Novices");
  EXPECT_EQ(table().columns[3].exportedColumnFor(readers).unit, "s");
}

TEST(ExportedTable, HasACellForEachColumnAndAnEmptyOneForAMissingValue) {
  const std::vector<Row> rows{{"a,b", 3, 0.25, true}, {"", -1, std::nullopt, false}};
  const auto exported = exportedTable(table(), rows, {.isBlinded = false});
  EXPECT_EQ(asCsv(exported), "code,count,secret,seconds_s\n\"a,b\",3,\"a,b\",0.25\n,-1,,\n");
}

TEST(ExportedTable, PutsAnApostropheOnlyBeforeFreeText) {
  const std::vector<Row> rows{{"=1+1", 0, std::nullopt, false}};
  const auto exported = exportedTable(table(), rows, {.isBlinded = false});
  EXPECT_EQ(asCsv(exported), "code,count,secret,seconds_s\n=1+1,0,'=1+1,\n");
}

}  // namespace column_test
}  // namespace study
