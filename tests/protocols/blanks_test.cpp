// What a laboratory has still to fill in before somebody takes part.
#include "protocols/blanks.h"

#include <gtest/gtest.h>

#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace {

TEST(Blanks, AreFoundInTheInstrumentsThatAreUsed) {
  const auto loading = tests::load(tests::usualProtocol());
  ASSERT_TRUE(loading.loaded) << loading.inWords();
  const auto blanks = blanksOf(*loading.loaded, "en");
  ASSERT_EQ(blanks.size(), 1U);
  EXPECT_EQ(blanks[0].where, "consent-punch");
  EXPECT_EQ(
      blanks[0].words,
      "[[number]], [[date or event]], [[institution]], [[name, e-mail and telephone of the "
      "responsible researcher]]");
}

TEST(Blanks, AreThoseOfTheLanguageThatIsRead) {
  const auto loading =
      tests::load(tests::withPhases({R"({"type": "break", "id": "rest", "seconds": 60,
           "text": {"en": "Rest in room 4.", "de": "Ruhen Sie in [[Raum]] aus."}})"}));
  ASSERT_TRUE(loading.loaded) << loading.inWords();
  EXPECT_EQ(blanksOf(*loading.loaded, "en").size(), 1U) << "the consent's only";
  const auto blanks = blanksOf(*loading.loaded, "de");
  ASSERT_EQ(blanks.size(), 2U);
  EXPECT_EQ(blanks[0].words, "[[Raum]]");
  EXPECT_EQ(blanks[0].where.substr(0, 9), "$.phases[") << blanks[0].where;
}

}  // namespace
}  // namespace protocols
