#include <fmt/format.h>

#include "base/joined.h"
#include "study/export/export_parts.h"
#include "study/export/public_people.h"
#include "study/export/public_tables.h"
#include "study/words/counted.h"

namespace study {
namespace {

std::string peopleInWords(std::size_t count) {
  return words::counted(count, "person", "people");
}

/// The first member of each pair, joined by commas: "cohort, background_role".
template <typename Pairs>
std::string namesOf(const Pairs& pairs) {
  return base::joined(pairs, ", ", [](const auto& pair) { return pair.first; });
}

/// A sentence on the classes before generalisation and suppression.
std::string beforeInWords(const Release& release) {
  const auto& before = release.before;
  auto text = fmt::format(
      "As answered: {} of {} in classes of fewer than {}, the smallest of {}.\n",
      before.peopleInSmallClasses,
      peopleInWords(before.people),
      release.k,
      peopleInWords(before.smallest));
  for (const auto& [name, count] : before.causes) {
    text += fmt::format(
        "  {}: by it alone {} in classes of fewer than {}\n",
        name,
        peopleInWords(count),
        release.k);
  }
  if (before.causes.empty() && before.peopleInSmallClasses > 0) {
    text += "  nothing alone, but together: " + namesOf(before.smallestClass) + "\n";
  }
  return text;
}

std::string afterInWords(const Release& release) {
  const auto& after = release.after;
  const auto said = base::joined(
      after.smallestClass, ", ", [](const auto& pair) { return pair.first + " = " + pair.second; });
  return fmt::format(
      "As told: {}, the smallest of {}: {}.\n",
      words::counted(after.classes, "class", "classes"),
      peopleInWords(after.smallest),
      said.empty() ? "of them nothing is told" : said);
}

/// Sentences on which columns about people are released, and which are not.
std::string columnsInWords(const Release& release) {
  std::string told;
  std::string untold;
  for (const auto& column : release.columns) {
    auto& names = column.level ? told : untold;
    names += (names.empty() ? "" : ", ") + column.name;
    std::size_t empty = 0;
    for (const auto& value : column.values) empty += value.empty() ? 1 : 0;
    if (column.level && empty > 0) names += fmt::format(" (not of {})", peopleInWords(empty));
  }
  return "Told: " + (told.empty() ? "nothing" : told) + ".\n" +
         (untold.empty() ? "" : "Not told: " + untold + ".\n");
}

}  // namespace

std::string describe(const Release& release) {
  return beforeInWords(release) + afterInWords(release) + columnsInWords(release);
}

std::string publicReadme(Study& study, const ExportOptions& options, const Release& release) {
  const bool isOrderTold = release.column(kOrderColumn)->level.has_value();
  std::string text = fmt::format(
      "# {}\n\nFor the public, by palpate {}.\n\n"
      "- {} {} sessions that were completed, one of each person. Nothing of anybody else.\n"
      "- Of each person at least {} people the same is told (k-anonymity with k = {}), as to "
      "cohort, "
      "what they said about themselves and the order in which they felt the conditions.\n",
      study.protocol().protocol.study.title,
      appVersion(),
      release.after.people,
      nameOf(options.runMode.value_or(RunMode::Live)),
      release.k,
      release.k);
  text +=
      "- Numbers about people are told as bands. What too few share is missing, or its column is "
      "not "
      "there.\n"
      "- Not in this folder: words that somebody wrote, dates and times, how long answers took, "
      "languages, what was measured in trials, events, who did not finish.\n"
      "- Ids were drawn for this folder, and rows stand in an order drawn for it: neither leads "
      "back "
      "to the study.\n" +
      formatInWords(options) +
      "- Opinions are told as they were given. Who has the study's own data can find its people "
      "here "
      "by them; nobody else should be able to.\n";
  if (!isOrderTold) text += "- The order of conditions is not told, and no position in it.\n";
  text += readmeLineOnBlinding(study, options);
  return text + "\n" + afterInWords(release) + "\n" + columnsInWords(release);
}

}  // namespace study
