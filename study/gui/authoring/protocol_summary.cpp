#include "study/gui/authoring/protocol_summary.h"

#include <cmath>
#include <set>

#include <QCoreApplication>
#include <QStringList>

#include "study/gui/authoring/checked_protocol.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
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

QStringList questionnairesOf(const protocols::LoadedProtocol& loaded) {
  QStringList lines;
  std::set<std::string> seen;
  for (const auto& use : instrumentUses(loaded.protocol)) {
    const auto* instrument = loaded.instrument(use.instrument);
    if (instrument->items.empty() || !seen.insert(use.instrument).second) continue;
    lines << tr("%1: %2 questions")
                 .arg(QString::fromStdString(instrument->title.in(deskLanguage())))
                 .arg(instrument->items.size());
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
  return QString::fromStdString(protocol.study.description) + QLatin1Char('\n') +
         section(tr("Participants"), cohortsOf(protocol)) + section(tr("A session"), session) +
         section(tr("What is compared"), conditionsOf(loaded)) +
         section(tr("In which order"), partsOf(protocol)) +
         section(tr("Questions"), questionnairesOf(loaded));
}

}  // namespace study::gui
