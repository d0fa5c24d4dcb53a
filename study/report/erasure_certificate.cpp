#include "study/report/erasure_certificate.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/joined.h"
#include "base/text_table.h"
#include "study/report/html_text.h"

namespace study::report {
namespace {

constexpr std::string_view kTitle = "Certificate of erasure";
constexpr std::string_view kMark = "erasure: ";
constexpr std::size_t kLeastWidth = 18;  // of the first column of a text
constexpr std::string_view kUseInOtherCopies =
    "For other copies of the study, on any computer: palpate study erase COPY --by THIS-FILE, with "
    "the text of this certificate.";

std::string_view inWords(storage::ErasureLevel level) {
  switch (level) {
    case storage::ErasureLevel::Identity:
      return "identity: names and signatures";
    case storage::ErasureLevel::Answers:
      return "answers: answers, votes, texts, traces, and what the audit trail said of them";
    case storage::ErasureLevel::All:
      break;
  }
  return "all: names, signatures, answers, votes, texts, traces, and what the audit trail said of "
         "them";
}

using Rows = std::vector<std::pair<std::string, std::string>>;

/// The rows of a certificate in one language.
class CertificateRows {
 public:
  CertificateRows(const ErasureCertificate& certificate, const words::Words& words)
      : certificate_(certificate), words_(words) {}

  Rows rows() const {
    const auto& report = certificate_.report;
    Rows rows{
        {words_("Study"), certificate_.title},
        {words_("Study id"), report.listed.study},
        {words_("Participant"), report.erasure.participant},
        {words_("Erased"), words_(inWords(report.erasure.level))},
        {words_("On"), report.erasure.utc},
        {words_("Reason"), report.erasure.reason},
        {words_("Deleted"),
         words_.count(report.names, "{} name", "{} names") + ", " +
             words_.count(report.answers, "{} answer", "{} answers") + ", " +
             words_.count(report.sessions, "of {} session", "of {} sessions")},
        {words_("Left"), words_("code, cohort, order, times of events, and that it was erased")},
        {words_("Study's folder"), searchResultIn(report.filesWithTexts)}};
    if (report.areNamesLocked) {
      rows.emplace_back(words_("Names"), words_("were behind a passphrase, and not searched for"));
    }
    for (const auto& copy : certificate_.copies) {
      rows.emplace_back(words_("Copy"), copy.folder + ": " + outcomeOf(copy));
    }
    for (const auto& copy : certificate_.notErasedFrom) {
      rows.emplace_back(words_("Copy that is left"), report::inWords(copy, words_));
    }
    if (!report.stationToPush.empty()) {
      rows.emplace_back(words_("The study's server"), leftOnServer());
    }
    if (!report.whyNotListed.empty()) {
      rows.emplace_back(words_("Not listed here"), report.whyNotListed);
    }
    rows.emplace_back(words_("Program"), "palpate " + std::string(appVersion()));
    return rows;
  }

 private:
  std::string searchResultIn(const std::vector<std::string>& files) const {
    const auto texts = certificate_.report.texts.size();
    const auto ignored = certificate_.report.texts.ignored();
    const auto ofShort =
        ignored == 0
            ? std::string()
            : "; " + words_.count(
                         ignored,
                         "{} text is too short to be searched for, or is in the protocol",
                         "{} texts are too short to be searched for, or are in the protocol");
    if (texts == 0) return words_("nothing was written that could be searched for") + ofShort;
    const auto found =
        files.empty() ? words_("not found") : words_.say("FOUND in {}", base::joined(files, ", "));
    return words_.count(
               texts,
               "{} text was searched for in every byte",
               "{} texts were searched for in every byte") +
           ": " + found + ofShort;
  }

  std::string outcomeOf(const ErasedCopy& copy) const {
    switch (copy.outcome) {
      case ErasedCopy::Outcome::Removed:
        return words_("removed");
      case ErasedCopy::Outcome::NotInCopy:
        return words_("was not in it") + "; " + searchResultIn(copy.filesWithTexts);
      case ErasedCopy::Outcome::Failed:
        return words_("NOT ERASED.") + " " + copy.whyNot;
      case ErasedCopy::Outcome::Erased:
        break;
    }
    return words_("erased") + "; " + searchResultIn(copy.filesWithTexts);
  }

  std::string leftOnServer() const {
    const auto& report = certificate_.report;
    return report.isInPulledFolder
               ? words_.say(
                     "NOT ERASED there, nor at the station {}. Erase there, and push: what is "
                     "pulled afterwards is without it",
                     report.stationToPush)
               : words_.say(
                     "not yet: it is erased there when this station ({}) pushes next",
                     report.stationToPush);
  }

  const ErasureCertificate& certificate_;
  const words::Words& words_;
};

}  // namespace

std::string inWords(const KnownCopy& copy, const words::Words& words) {
  if (copy.folder.empty()) {
    return words.say(
        "the consent form, of {}; where it was saved is not noted, because files may be named "
        "after people",
        copy.madeUtc);
  }
  return copy.folder + (copy.madeUtc.empty() ? "" : words.say(", of {}", copy.madeUtc)) +
         (copy.isPresent ? "" : " " + words("(not on this computer now)"));
}

bool ErasureCertificate::isClean() const {
  return report.filesWithTexts.empty() &&
         std::all_of(copies.begin(), copies.end(), [](const ErasedCopy& copy) {
           return copy.outcome != ErasedCopy::Outcome::Failed && copy.filesWithTexts.empty();
         });
}

std::string asText(const ErasureCertificate& certificate, const words::Words& words) {
  std::string text = words(kTitle) + "\n\n";
  const auto rows = CertificateRows(certificate, words).rows();
  std::size_t width = kLeastWidth;
  for (const auto& [what, value] : rows) width = std::max(width, base::characterCount(what));
  for (const auto& [what, value] : rows) {
    text += what + std::string(width + 1 - base::characterCount(what), ' ') + value + "\n";
  }
  // The program reads this line, so it is not translated.
  return text +
         fmt::format(
             "\n{}\n{}{}\n", words(kUseInOtherCopies), kMark, asLine(certificate.report.listed));
}

std::string asHtml(const ErasureCertificate& certificate, const words::Words& words) {
  std::string html = fmt::format("<h1>{}</h1>\n<table><tbody>\n", words(kTitle));
  for (const auto& [what, value] : CertificateRows(certificate, words).rows()) {
    html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escaped(what), escaped(value));
  }
  // As in the text, on a line of its own: the program reads it in this file as well.
  html += fmt::format(
      "</tbody></table>\n<p class=\"note\">{}</p>\n<p class=\"note\">\n{}{}\n</p>\n",
      words(kUseInOtherCopies),
      kMark,
      escaped(asLine(certificate.report.listed)));
  return htmlPage(words(kTitle), html, words.language());
}

std::vector<storage::ListedErasure> erasuresIn(const std::string& text) {
  std::vector<storage::ListedErasure> erasures;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(kMark)) continue;
    if (auto erasure = storage::listedErasureIn(line.substr(kMark.size()))) {
      erasures.push_back(std::move(*erasure));
    }
  }
  return erasures;
}

}  // namespace study::report
