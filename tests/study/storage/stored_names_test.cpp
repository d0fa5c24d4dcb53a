// Statuses and kinds that a study stores by their names.
#include <optional>
#include <string_view>

#include <gtest/gtest.h>

#include "study/storage/records.h"

namespace study {
namespace stored_names_test {

/// Whether the names of the first @p count values are read back as those values.
template <typename Value>
void expectNamesToBeReadBack(
    int count, std::optional<Value> (*valueNamed)(std::string_view) noexcept) {
  for (int i = 0; i < count; ++i) {
    const auto value = static_cast<Value>(i);
    EXPECT_FALSE(nameOf(value).empty()) << i;
    EXPECT_EQ(valueNamed(nameOf(value)), value) << nameOf(value);
  }
  EXPECT_FALSE(valueNamed("lost"));
}

TEST(StoredNames, AreReadBackAsTheirValues) {
  expectNamesToBeReadBack<RunMode>(3, runModeNamed);
  expectNamesToBeReadBack<StepKind>(9, stepKindNamed);
  expectNamesToBeReadBack<storage::VisitStatus>(5, storage::visitStatusNamed);
  expectNamesToBeReadBack<TrialEnding>(6, trialEndingNamed);
  expectNamesToBeReadBack<Verdict>(3, verdictNamed);
}

TEST(StoredNames, ThatAreUnknownCountAsDamage) {
  EXPECT_EQ(storage::requireKnown(verdictNamed("WARN"), "WARN"), Verdict::Warn);
  try {
    storage::requireKnown(verdictNamed("GOOD"), "GOOD");
    FAIL() << "an unknown name was accepted";
  } catch (const storage::StorageError& error) {
    EXPECT_EQ(error.kind(), storage::StorageError::Kind::Damaged);
  }
}

}  // namespace stored_names_test
}  // namespace study
