#include "study/report/erasure_certificate.h"

#include <gtest/gtest.h>

namespace study::report {
namespace erasure_certificate_test {

ErasureCertificate certificate() {
  ErasureCertificate certificate{.title = "A <short> study"};
  auto& report = certificate.report;
  report.erasure = {
      .participant = "P001", .reason = "asked for it", .utc = "2026-11-23T10:00:00.000Z"};
  report.answers = 34;
  report.names = 1;
  report.sessions = 1;
  report.texts.add("a story of many words", 8);
  report.listed = {
      .study = "1a2b",
      .participant = "P001",
      .enrolledUtc = "2026-11-20T10:00:00.000Z",
      .utc = report.erasure.utc};
  certificate.copies = {
      {.folder = "/disk/monday"},
      {.folder = "/disk/table", .outcome = ErasedCopy::Outcome::Removed},
      {.folder = "/disk/other",
       .outcome = ErasedCopy::Outcome::Failed,
       .whyNot = "It is another."}};
  certificate.notErasedFrom = {
      {.folder = "/gone", .what = "made_backup", .madeUtc = "2026-11-21"},
      {.folder = {}, .what = "copied_consent", .madeUtc = "2026-11-22", .isPresent = true}};
  return certificate;
}

TEST(ErasureCertificate, TellsWhatWasErasedAndWhatIsLeft) {
  const auto text = asText(certificate());
  for (const std::string said :
       {"P001",
        "1 name, 34 answers, of 1 session",
        "asked for it",
        "1 text was searched for in every byte: not found",
        "/disk/monday: erased",
        "/disk/table: removed",
        "/disk/other: NOT ERASED. It is another.",
        "/gone, of 2026-11-21 (not on this computer now)",
        "the consent form, of 2026-11-22; where it was saved is not noted"}) {
    EXPECT_NE(text.find(said), std::string::npos) << said << "\n" << text;
  }
}

TEST(ErasureCertificate, TellsAnotherComputerWhatToErase) {
  const auto made = certificate();
  EXPECT_EQ(erasuresIn(asText(made)), std::vector<storage::ListedErasure>{made.report.listed});
  EXPECT_EQ(erasuresIn(asHtml(made)), std::vector<storage::ListedErasure>{made.report.listed});
  EXPECT_TRUE(erasuresIn("erasure: nothing\n").empty());
}

TEST(ErasureCertificate, IsTranslatedWithoutARest) {
  for (const auto& language : words::languages()) {
    if (language == "en") continue;
    const auto words = words::wordsIn(language);
    for (const auto level :
         {storage::ErasureLevel::Identity,
          storage::ErasureLevel::Answers,
          storage::ErasureLevel::All}) {
      for (const auto number : {0, 1, 2}) {
        auto made = certificate();
        made.report.erasure.level = level;
        made.report.names = made.report.sessions = static_cast<std::size_t>(number);
        made.report.answers = number;
        if (number == 0) made.report.texts = {};
        if (number == 2) {
          made.report.filesWithTexts = {"study.db"};
          made.copies.push_back({.folder = "/disk/no", .outcome = ErasedCopy::Outcome::NotInCopy});
          made.report.whyNotListed = "why";
        }
        const auto text = asText(made, words);
        EXPECT_EQ(erasuresIn(text).size(), 1U) << "for another computer it says the same";
        EXPECT_NE(text.find(words("Certificate of erasure")), std::string::npos);
      }
    }
    std::string missing;
    for (const auto& sentence : words.missing()) missing += sentence + "\n";
    EXPECT_EQ(missing, "");
    EXPECT_NE(asHtml(certificate(), words).find("lang=\"" + language), std::string::npos);
  }
}

TEST(ErasureCertificate, IsAPageWithEscapedText) {
  const auto html = asHtml(certificate());
  EXPECT_NE(html.find("A &lt;short&gt; study"), std::string::npos);
  EXPECT_EQ(html.find("A <short> study"), std::string::npos);
}

}  // namespace erasure_certificate_test
}  // namespace study::report
