// A study keeps the defaults of the release under which its protocol was added: an update of the
// program does not change the rendering of a running study.
#include <gtest/gtest.h>

#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"

namespace study {
namespace kept_defaults_test {

using haptics::engine::TissueDrawing;

/// How the visible tissue follows in a condition whose protocol does not say so.
TissueDrawing seenIn(const protocols::LoadedProtocol& loaded) {
  return loaded.protocol.conditions.front().tissueDrawing;
}

TEST(KeptDefaults, AreThoseOfThisReleaseInANewStudy) {
  tests::MadeStudy study;
  EXPECT_EQ(seenIn(study->protocol()), TissueDrawing::Penetration);
}

TEST(KeptDefaults, AreThoseOfRelease01InItsStudiesUntilTheProtocolIsAmended) {
  const auto protocol = tests::protocolFrom(tests::shortProtocol());
  tests::MadeStudy study(protocol);
  study.close();
  tests::Sql(study.file("study.db")).run("UPDATE study SET app_version = '0.1.0'");
  study.reopen();
  EXPECT_EQ(seenIn(study->protocol()), TissueDrawing::Force);

  study->amend(protocol, "to see what the paper describes");
  EXPECT_EQ(seenIn(study->protocol()), TissueDrawing::Penetration);
  EXPECT_EQ(seenIn(study->protocol(ProtocolId{1})), TissueDrawing::Force);
}

TEST(KeptDefaults, AreThoseOfRelease01IfThatReleaseAmendedTheProtocol) {
  const auto protocol = tests::protocolFrom(tests::shortProtocol());
  tests::MadeStudy study(protocol);
  study->amend(protocol, "a change");
  study.close();
  tests::Sql(study.file("study.db"))
      .run(
          "DROP TRIGGER an_event_is_never_changed;"
          "UPDATE study SET app_version = '0.1.0';"
          "UPDATE event SET detail = 'version 2: a change' WHERE kind = 'amended_protocol'");
  study.reopen();
  EXPECT_EQ(seenIn(study->protocol(ProtocolId{2})), TissueDrawing::Force);
}

}  // namespace kept_defaults_test
}  // namespace study
