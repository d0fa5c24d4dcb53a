#include "study/gui/authoring/checked_protocol.h"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include "protocols/load_protocol.h"
#include "questionnaires/json/document.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/results/protocol_versions.h"

namespace study::gui {
namespace {

using questionnaires::Severity;

int countOf(const std::vector<questionnaires::Problem>& problems, Severity severity) {
  return static_cast<int>(
      std::count_if(problems.begin(), problems.end(), [severity](const auto& problem) {
        return problem.severity == severity;
      }));
}

std::string textOf(const std::string& source) {
  if (const auto shipped = protocols::libraryProtocol(source)) return std::string(*shipped);
  return questionnaires::readTextFile(source);
}

/// "phase 7, Round 2": a part of a protocol, by its place from 0.
QString titleOfPart(const protocols::Protocol& protocol, const QString& kind, std::size_t place) {
  const auto number = QString::number(place + 1);
  if (kind == QStringLiteral("phases")) {
    return QObject::tr("phase %1, %2").arg(number, phaseTitle(protocol.phases.at(place).id));
  }
  if (kind == QStringLiteral("cohorts")) {
    return QObject::tr("cohort %1, %2")
        .arg(number, cohortTitle(protocol, protocol.cohorts.at(place).id));
  }
  if (kind == QStringLiteral("families")) {
    return QObject::tr("comparisons %1, %2")
        .arg(number, QString::fromStdString(protocol.analysis.families.at(place).title));
  }
  return QObject::tr("condition %1, %2")
      .arg(number, QString::fromStdString(protocol.conditions.at(place).title));
}

/// "1 warning", "3 warnings", in the language of the desk.
std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return translated(count == 1 ? one : many, count);
}

QString contentsOf(const protocols::Protocol& protocol) {
  return QString::fromStdString(translated(
      "\"{}\", {}, {}.",
      protocol.study.title,
      counted(protocol.conditions.size(), "{} condition", "{} conditions"),
      counted(protocol.cohorts.size(), "{} cohort", "{} cohorts")));
}

}  // namespace

report::ReportSection titlesOf(const protocols::LoadedProtocol& loaded) {
  report::ReportSection section;
  section.protocol = loaded.protocol;
  section.instruments = loaded.instruments;
  section.words = words::wordsIn(deskLanguage());
  return section;
}

QStringList changesInWords(Study& study, const protocols::LoadedProtocol& newest) {
  const auto titles = titlesOf(newest);
  QStringList changes;
  for (const auto& change : changesBy(study, newest)) {
    changes << capitalised(QString::fromStdString(titles.inWords(change)));
  }
  return changes;
}

std::size_t blanksLeft(const protocols::LoadedProtocol& loaded) {
  return static_cast<std::size_t>(std::ranges::count_if(
      protocols::blanksOf(loaded),
      [](const protocols::Blank& blank) { return blank.text.isEmpty(); }));
}

int CheckedProtocol::errors() const noexcept {
  return countOf(problems, Severity::Error);
}

int CheckedProtocol::warnings() const noexcept {
  return countOf(problems, Severity::Warning);
}

std::string CheckedProtocol::verdict() const {
  const auto countOf = [](int number) { return static_cast<std::size_t>(number); };
  if (!loaded) {
    return translated(
        "Not valid yet: {}.", counted(countOf(std::max(errors(), 1)), "{} error", "{} errors"));
  }
  if (warnings() == 0) return translated("Valid");
  return translated("Valid, {}", counted(countOf(warnings()), "{} warning", "{} warnings"));
}

Mark CheckedProtocol::mark() const noexcept {
  return !loaded ? Mark::Bad : warnings() > 0 ? Mark::Warning : Mark::Good;
}

QStringList CheckedProtocol::files() const {
  const QFileInfo file(QString::fromStdString(source));
  QStringList all{file.absoluteFilePath()};
  if (!loaded) return all;
  for (const auto& companion : loaded->files) {
    all << file.absoluteDir().filePath(QString::fromStdString(companion.name));
  }
  return all;
}

std::vector<Note> CheckedProtocol::notes() const {
  std::vector<Note> all;
  if (loaded) all.push_back({contentsOf(loaded->protocol)});
  if (!keptTexts.empty()) all.push_back({keptTextsInWords()});
  for (const auto& problem : problems) {
    const auto place = placeInWords(problem.path);
    const auto what = inWords(problem.what);
    const auto fix = inWords(problem.fix);
    all.push_back(
        {.text = capitalised(place.isEmpty() ? what : place + QStringLiteral(": ") + what),
         .mark = problem.severity == Severity::Error ? Mark::Bad : Mark::Warning,
         .details = fix.isEmpty() ? QStringList() : QStringList{capitalised(fix)}});
  }
  return all;
}

QString CheckedProtocol::keptTextsInWords() const {
  QStringList titles;
  for (const auto& blank : protocols::blanksOf(*loaded)) {
    if (keptTexts.contains(blank.key)) titles << deskText(blank.title);
  }
  return QObject::tr("Texts kept from the study, because the file leaves them empty: %1")
      .arg(titles.join(QStringLiteral("; ")));
}

QString CheckedProtocol::inWords(const base::Message& message) const {
  return loaded ? QString::fromStdString(titlesOf(*loaded).inWords(message)) : deskText(message);
}

QString CheckedProtocol::placeInWords(const std::string& path) const {
  static const QRegularExpression kIndex(QStringLiteral("\\[(\\d+)\\]"));
  static const QRegularExpression kPart(
      QStringLiteral("^[.](?:analysis[.])?(phases|conditions|cohorts|families)\\[(\\d+)\\]"));
  const QString all = QString::fromStdString(path);
  const auto root = all.indexOf(u'$');
  QString inside = root < 0 ? QString() : all.mid(root + 1);
  QString part;
  if (const auto found = kPart.match(inside); root == 0 && loaded && found.hasMatch()) {
    part = titleOfPart(loaded->protocol, found.captured(1), found.captured(2).toULongLong());
    inside.remove(0, found.capturedLength());
  }
  for (auto index = kIndex.match(inside); index.hasMatch(); index = kIndex.match(inside)) {
    const auto number = QString::number(index.captured(1).toInt() + 1);
    inside.replace(index.capturedStart(), index.capturedLength(), QLatin1Char(' ') + number);
  }
  const auto file = (root < 0 ? all : all.left(root).trimmed()).toStdString();
  const auto* instrument = loaded ? loaded->instrument(file) : nullptr;
  QStringList parts{
      QString::fromStdString(instrument == nullptr ? file : instrument->title.in(deskLanguage())),
      part};
  parts << inside.split(u'.');
  parts.removeAll(QString());
  return parts.join(QStringLiteral(" › ")).replace(u'_', u' ');
}

CheckedProtocol checkProtocol(const std::string& source, const protocols::LoadedProtocol* before) {
  std::string text;
  std::optional<protocols::LoadedProtocol> loaded;
  questionnaires::Problems problems;
  try {
    text = textOf(source);
    loaded = protocols::loadProtocolFile(source, problems);
  } catch (const base::UserError& error) {
    problems.add("$", error.what());
  }
  questionnaires::BlankTexts kept;
  if (loaded && before != nullptr) {
    kept = protocols::keptTexts(*before, *loaded);
    loaded = protocols::withKeptTexts(*before, *loaded);
  }
  auto checked = checkedProtocol(source, std::move(text), std::move(loaded), problems.all());
  checked.keptTexts = std::move(kept);
  return checked;
}

CheckedProtocol checkedProtocol(
    std::string source,
    std::string text,
    std::optional<protocols::LoadedProtocol> loaded,
    std::vector<questionnaires::Problem> problems) {
  std::ranges::stable_sort(problems, {}, [](const auto& problem) {
    return problem.severity != Severity::Error;  // errors first
  });
  const auto isBlank = [](const auto& problem) { return problem.what.key() == "blank_left"; };
  if (loaded && std::erase_if(problems, isBlank) > 0 && blanksLeft(*loaded) > 0) {
    problems.insert(
        problems.begin(),
        {.severity = Severity::Warning,
         .path = "$",
         .what = base::Message::verbatim(
             translated("{} blanks in texts for participants", blanksLeft(*loaded))),
         .fix = base::Message::verbatim(
             translated("Fill in the texts before the first live session."))});
  }
  return {std::move(source), std::move(text), std::move(loaded), std::move(problems)};
}

}  // namespace study::gui
