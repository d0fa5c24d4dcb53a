// Files that nobody meant to write.
#include <string>

#include <gtest/gtest.h>

#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_file.h"
#include "tests/support/test_data.h"

namespace questionnaires {
namespace instrument_damage_test {

const std::string kWhole =
    readTextFile((tests::repository() / "tests/questionnaires/data/good/scores.json").string());

TEST(InstrumentFile, SurvivesEveryFileThatBreaksOff) {
  const std::size_t lastBracket = kWhole.rfind('}');
  for (std::size_t length = 0; length < lastBracket; ++length) {
    Problems problems;
    EXPECT_FALSE(readInstrument(kWhole.substr(0, length), problems).has_value()) << length;
    EXPECT_EQ(problems.all().size(), 1U) << length;
  }
}

TEST(InstrumentFile, SurvivesEveryByteThatIsDamaged) {
  for (std::size_t i = 0; i < kWhole.size(); ++i) {
    for (const char byte : {'\0', '"', '{', ']', '9', '-', 'x', '\x80', '\xff'}) {
      std::string damaged = kWhole;
      damaged[i] = byte;
      Problems problems;
      const bool isRead = readInstrument(damaged, problems).has_value();
      EXPECT_NE(isRead, problems.hasErrors()) << i;
    }
  }
}

TEST(InstrumentFile, AsksNoMoreThanAThousandItems) {
  std::string items;
  for (int i = 0; i < 1001; ++i) {
    items += (i > 0 ? "," : "") + std::string(R"({"id": "i)") + std::to_string(i) +
             R"(", "type": "long_text", "text": "?"})";
  }
  Problems problems;
  const auto instrument = readInstrument(
      R"({"$schema": "instrument-1.schema.json", "id": "a", "version": "1", "title": "T",
          "languages": ["en"], "source": {"citation": "c", "licence": "l"}, "items": [)" +
          items + "]}",
      problems);
  EXPECT_FALSE(instrument.has_value());
  EXPECT_EQ(
      describe(problems.all()),
      "error   $.items: this list has more than 1000 entries; shorten it\n");
}

}  // namespace instrument_damage_test
}  // namespace questionnaires
