#include "study/gui/session/station_push.h"

#include <utility>

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <QProcess>

#include "study/gui/widgets/desk_language.h"

namespace study::gui {
namespace {

constexpr int kPollInterval = 1000;  // [ms]
constexpr int kMostPolls = 120;      // then a push without a note counts as ended

QString program() {
  return QCoreApplication::applicationDirPath() + QStringLiteral("/palpate-collect");
}

QDateTime timeOf(const std::string& utc) {
  return QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate).toLocalTime();
}

/// "Tuesday" within a week, else "2026-11-17".
std::string dayInWords(const std::string& utc) {
  constexpr int kWeek = 7;
  const auto day = timeOf(utc).date();
  if (day.daysTo(QDate::currentDate()) >= kWeek) return day.toString(Qt::ISODate).toStdString();
  return QLocale(QString::fromStdString(deskLanguage())).dayName(day.dayOfWeek()).toStdString();
}

/// Why the last push did not succeed.
std::string problemInWords(const std::string& problem) {
  if (problem == "unreachable") return translated("no network, or no server");
  if (problem == "not_let_in") return translated("the server does not let this computer in");
  if (problem == "full") return translated("the server’s disk is full");
  if (problem == "release" || problem == "newer") {
    return translated("the server has another release of this program");
  }
  if (problem == "revoked") return translated("this station was revoked");
  if (problem == "fork" || problem == "older_copy") {
    return translated("another copy of this folder has sent something");
  }
  return translated("the server refused it; sending it from the command line says why");
}

bool isSame(const PushRecord& one, const PushRecord& other) {
  return one.utc == other.utc && one.lastEvent == other.lastEvent && one.problem == other.problem;
}

}  // namespace

std::string arrivalsInWords(const Arrivals& arrivals, const std::string& problem) {
  const auto& [all, arrived, since] = arrivals;
  if (all == 0) return {};
  const auto waiting = all - arrived;
  std::string words =
      waiting == 0 ? translated("Sessions here: {}. All have arrived", all)
      : since.empty()
          ? translated("Sessions here: {}. Arrived: {}. Waiting: {}", all, arrived, waiting)
          : translated(
                "Sessions here: {}. Arrived: {}. Waiting since {}: {}",
                all,
                arrived,
                dayInWords(since),
                waiting);
  if (waiting > 0 && !problem.empty()) words += " (" + problemInWords(problem) + ")";
  return words;
}

bool isOverdue(const Arrivals& arrivals) {
  constexpr qint64 kDay = 24 * 60 * 60;
  return !arrivals.waitingSince.empty() &&
         timeOf(arrivals.waitingSince).secsTo(QDateTime::currentDateTime()) > kDay;
}

StationPush::StationPush(
    Study& study, std::function<bool()> isBusy, int retryInterval, QObject* parent)
    : QObject(parent), study_(study), isBusy_(std::move(isBusy)) {
  connect(&watching_, &QTimer::timeout, this, &StationPush::poll);
  connect(&retry_, &QTimer::timeout, this, [this] {
    if (!isBusy_() && isWaiting()) send();
  });
  if (isPossible()) retry_.start(retryInterval);
}

bool StationPush::isPossible() const {
  return !study_.station().isNone() && QFileInfo::exists(program());
}

bool StationPush::isWaiting() const {
  const auto last = lastPush(study_.uuid(), study_.station().uuid);
  const auto arrivals = arrivalsBy(study_, last.lastEvent);
  return arrivals.arrived < arrivals.all;
}

void StationPush::send() {
  if (!isPossible() || isSending()) return;
  before_ = lastPush(study_.uuid(), study_.station().uuid);
  QProcess push;
  push.setProgram(QStringLiteral("nice"));
  push.setArguments(
      {QStringLiteral("-n"),
       QStringLiteral("19"),
       program(),
       QStringLiteral("push"),
       QString::fromStdString(study_.folder().string())});
  push.setStandardInputFile(QProcess::nullDevice());
  push.setStandardOutputFile(QProcess::nullDevice());
  push.setStandardErrorFile(QProcess::nullDevice());
  push.startDetached();  // the push goes on if the window is closed
  pollsLeft_ = kMostPolls;
  watching_.start(kPollInterval);
  emit changed();
}

/// Stops watching once the push has stored its note, or after kMostPolls polls.
void StationPush::poll() {
  const bool isNoted = !isSame(before_, lastPush(study_.uuid(), study_.station().uuid));
  if (!isNoted && --pollsLeft_ > 0) return;
  watching_.stop();
  emit changed();
}

std::string StationPush::inWords() const {
  if (study_.station().isNone()) return {};
  const auto last = lastPush(study_.uuid(), study_.station().uuid);
  return arrivalsInWords(arrivalsBy(study_, last.lastEvent), last.problem);
}

bool StationPush::isOverdue() const {
  if (study_.station().isNone()) return false;
  return gui::isOverdue(
      arrivalsBy(study_, lastPush(study_.uuid(), study_.station().uuid).lastEvent));
}

}  // namespace study::gui
