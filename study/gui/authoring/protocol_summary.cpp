#include "study/gui/authoring/protocol_summary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <QCoreApplication>
#include <QStringList>

#include "study/gui/authoring/checked_protocol.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/results/apa_text.h"
#include "study/session/session_length.h"

namespace study::gui {
namespace {

QString tr(const char* words) {
  return QCoreApplication::translate("ProtocolSummary", words);
}

QString section(const QString& heading, const QStringList& lines) {
  if (lines.isEmpty()) return {};
  return QStringLiteral("\n## %1\n\n- %2\n").arg(heading, lines.join(QStringLiteral("\n- ")));
}

QString inWords(const protocols::Order& order) {
  switch (order.type) {
    case protocols::OrderType::Fixed:
      return tr("the same order for everyone");
    case protocols::OrderType::Reversed:
      return tr("the order of %1, reversed").arg(phaseTitle(order.of));
    case protocols::OrderType::Random:
      return tr("a random order for each participant");
    case protocols::OrderType::LatinSquare:
      return tr("balanced orders: each condition equally often in each position");
    case protocols::OrderType::BalancedLatinSquare:
      return tr(
          "balanced orders: each condition equally often in each position and after each other");
    case protocols::OrderType::Complete:
      return tr("all possible orders equally often");
  }
  return {};
}

QStringList cohortsOf(const protocols::Protocol& protocol) {
  QStringList lines;
  for (const auto& cohort : protocol.cohorts) {
    const auto title = cohortTitle(protocol, cohort.id);
    lines << (cohort.planned > 0 ? tr("%1: %2 planned").arg(title).arg(cohort.planned) : title);
  }
  return lines;
}

QStringList conditionsOf(const protocols::LoadedProtocol& loaded) {
  QStringList lines;
  const auto titles = titlesOf(loaded);
  for (const auto& condition : loaded.protocol.conditions) {
    lines << QString::fromStdString(titles.introducedTitle(condition.id));
  }
  return lines;
}

QStringList partsOf(const protocols::Protocol& protocol) {
  QStringList lines;
  for (const auto& phase : protocol.phases) {
    if (phase.type != protocols::PhaseType::Block) continue;
    lines << tr("%1: %2 conditions, %3")
                 .arg(phaseTitle(phase.id))
                 .arg(phase.trials.conditions.size())
                 .arg(inWords(phase.trials.order));
  }
  return lines;
}

/// How many items of @p use each condition gets, where conditions get different ones; empty where
/// all get the same.
QString itemsByCondition(const protocols::LoadedProtocol& loaded, const std::string& instrument) {
  std::map<std::string, std::set<std::string>> asked;
  for (const auto& phase : loaded.protocol.phases) {
    for (const auto& use : phase.trials.questionnaires) {
      if (use.instrument != instrument) continue;
      for (const auto& condition : phase.trials.conditions) {
        for (const auto& item : loaded.instrument(instrument)->itemsOf(use.itemSetFor(condition))) {
          asked[condition].insert(item.id);
        }
      }
    }
  }
  const bool areSame = std::ranges::all_of(
      asked, [&](const auto& each) { return each.second == asked.begin()->second; });
  if (areSame) return {};
  const auto count = asked.begin()->second.size();
  const bool areAsMany =
      std::ranges::all_of(asked, [&](const auto& each) { return each.second.size() == count; });
  return areAsMany ? tr("; %1 about each condition, not all the same").arg(count)
                   : tr("; conditions get different ones");
}

QStringList analysesOf(const protocols::LoadedProtocol& loaded) {
  QStringList lines;
  const auto words = words::wordsIn(deskLanguage());
  for (const auto& family : loaded.protocol.analysis.families) {
    if (family.comparisons.empty()) continue;
    lines << tr("%1: %2 comparisons by %3, α = %4")
                 .arg(QString::fromStdString(family.title))
                 .arg(family.comparisons.size())
                 .arg(QString::fromStdString(declaredInWords(family, words)))
                 .arg(family.alpha);
  }
  return lines;
}

QStringList questionnairesOf(const protocols::LoadedProtocol& loaded) {
  QStringList lines;
  std::set<std::string> seen;
  for (const auto& use : instrumentUses(loaded.protocol)) {
    const auto* instrument = loaded.instrument(use.instrument);
    if (instrument->items.empty() || !seen.insert(use.instrument).second) continue;
    lines << tr("%1: %2 questions")
                     .arg(QString::fromStdString(instrument->title.in(deskLanguage())))
                     .arg(instrument->items.size()) +
                 itemsByCondition(loaded, use.instrument);
  }
  return lines;
}

}  // namespace

QString protocolSummary(const protocols::LoadedProtocol& loaded) {
  const auto& protocol = loaded.protocol;
  const auto length = lengthOf(loaded, {});
  QStringList languages;
  for (const auto& language : protocol.languages) {
    languages << nativeName(QString::fromStdString(language));
  }
  const QStringList session{
      tr("About %1 minutes, of which about %2 are spent touching the device")
          .arg(std::ceil(length.seconds / 60.0))
          .arg(std::ceil(length.secondsOnDevice / 60.0)),
      tr("Languages: %1").arg(languages.join(QStringLiteral(", ")))};
  return section(tr("Participants"), cohortsOf(protocol)) + section(tr("A session"), session) +
         section(tr("What is compared"), conditionsOf(loaded)) +
         section(tr("Declared analysis"), analysesOf(loaded)) +
         section(tr("In which order"), partsOf(protocol)) +
         section(tr("Questions"), questionnairesOf(loaded)) +
         QStringLiteral("\n## %1\n\n%2\n")
             .arg(tr("Description"), QString::fromStdString(protocol.study.description));
}

}  // namespace study::gui
