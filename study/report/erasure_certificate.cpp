#include "study/report/erasure_certificate.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "study/report/html_text.h"
#include "study/words/counted.h"

namespace study::report {
namespace {

constexpr std::string_view kTitle = "Certificate of erasure";
constexpr std::string_view kMark = "erasure: ";
constexpr std::string_view kForOthers =
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

std::string listed(const std::vector<std::string>& files) {
  std::string all;
  for (const auto& file : files) all += (all.empty() ? "" : ", ") + file;
  return all;
}

std::string searched(std::size_t texts, const std::vector<std::string>& files) {
  if (texts == 0) return "nothing was written that could be searched for";
  return words::counted(texts, "text was", "texts were") + " searched for in every byte: " +
         (files.empty() ? "not found" : "FOUND in " + listed(files));
}

std::string inWords(const ErasedCopy& copy, std::size_t texts) {
  switch (copy.outcome) {
    case ErasedCopy::Outcome::Removed:
      return copy.folder + ": an export, removed";
    case ErasedCopy::Outcome::NotInIt:
      return copy.folder + ": was not in it; " + searched(texts, copy.filesWithTexts);
    case ErasedCopy::Outcome::Failed:
      return copy.folder + ": NOT ERASED. " + copy.whyNot;
    case ErasedCopy::Outcome::Erased:
      break;
  }
  return copy.folder + ": erased; " + searched(texts, copy.filesWithTexts);
}

using Rows = std::vector<std::pair<std::string, std::string>>;

Rows rowsOf(const ErasureCertificate& certificate) {
  const auto& report = certificate.report;
  const auto texts = report.texts.size();
  Rows rows{
      {"Study", certificate.title},
      {"Study id", report.listed.study},
      {"Participant", report.erasure.participant},
      {"Erased", std::string(inWords(report.erasure.level))},
      {"On", report.erasure.utc},
      {"Reason", report.erasure.reason},
      {"Deleted",
       words::counted(report.names, "name", "names") + ", " +
           words::counted(static_cast<std::uint64_t>(report.answers), "answer", "answers") +
           ", of " + words::counted(report.sessions, "session", "sessions")},
      {"Left", "code, cohort, order, times of events, and that it was erased"},
      {"Study's folder", searched(texts, report.filesWithTexts)}};
  for (const auto& copy : certificate.copies) rows.emplace_back("Copy", inWords(copy, texts));
  for (const auto& copy : certificate.left) {
    rows.emplace_back(
        "Copy that is left",
        fmt::format(
            "{}{}{}",
            copy.folder,
            copy.madeUtc.empty() ? "" : ", of " + copy.madeUtc,
            copy.isThere ? "" : " (not there any more)"));
  }
  if (!report.whyNotListed.empty()) rows.emplace_back("Not listed here", report.whyNotListed);
  rows.emplace_back("Program", "palpate " + std::string(appVersion()));
  return rows;
}

}  // namespace

bool ErasureCertificate::isClean() const {
  return report.filesWithTexts.empty() &&
         std::all_of(copies.begin(), copies.end(), [](const ErasedCopy& copy) {
           return copy.outcome != ErasedCopy::Outcome::Failed && copy.filesWithTexts.empty();
         });
}

std::string asText(const ErasureCertificate& certificate) {
  std::string text = fmt::format("{}\n\n", kTitle);
  for (const auto& [what, value] : rowsOf(certificate)) {
    text += fmt::format("{:<18} {}\n", what, value);
  }
  return text + fmt::format("\n{}\n{}{}\n", kForOthers, kMark, asLine(certificate.report.listed));
}

std::string asHtml(const ErasureCertificate& certificate) {
  std::string html = fmt::format("<h1>{}</h1>\n<table><tbody>\n", kTitle);
  for (const auto& [what, value] : rowsOf(certificate)) {
    html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escaped(what), escaped(value));
  }
  html += fmt::format("</tbody></table>\n<p class=\"note\">{}</p>\n", kForOthers);
  return htmlPage(kTitle, html);
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
