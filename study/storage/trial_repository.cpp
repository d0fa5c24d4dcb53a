#include "study/storage/trial_repository.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "study/storage/required_key.h"
#include "study/storage/statement.h"
#include "study/storage/stored_values.h"

namespace study::storage {

namespace {

template <typename Value>
NamedRowValue valueOf(const std::optional<Value>& value) {
  return value ? NamedRowValue(*value) : NamedRowValue();
}

NamedRow rowOf(const VisitKey& visit, const TrialRecord& record) {
  const auto judgement = record.judgement();
  return {
      {"step", std::int64_t{visit.step}},
      {"attempt", std::int64_t{visit.attempt}},
      {"device", record.device},
      {"ending", std::string(nameOf(record.ending))},
      {"verdict", std::string(nameOf(judgement.verdict))},
      {"verdict_reason", asJson(judgement.reasons)},
      {"force_unit", std::string("N")},
      {"travel_unit", record.travelUnit},
      {"duration_s", record.duration},
      {"ticks", record.ticks},
      {"nominal_rate_hz", record.nominalRate},
      {"achieved_rate_hz", valueOf(record.achievedRate)},
      {"lateness_p50_us", valueOf(record.latenessMedian)},
      {"lateness_p99_us", valueOf(record.latenessP99)},
      {"lateness_max_us", valueOf(record.latenessLargest)},
      {"late_ticks", valueOf(record.lateTicks)},
      {"lost_samples", record.lostSamples},
      {"invalid_ticks", record.invalidTicks},
      {"saturated_s", record.saturated},
      {"slewed_s", record.slewed},
      {"undefined_s", record.undefined},
      {"contact_s", record.contact},
      {"largest_force_n", record.largestForce},
      {"cuts", static_cast<std::int64_t>(record.cuts.size())},
      {"trace_samples", record.traceSamples}};
}

NamedRow rowOf(const VisitKey& visit, std::int64_t number, const TrialRecord::Cut& cut) {
  NamedRow row{
      {"step", std::int64_t{visit.step}},
      {"attempt", std::int64_t{visit.attempt}},
      {"number", number},
      {"peak_n", static_cast<double>(cut.peakForce)}};
  const auto add = [&](const std::string& name, const auto& point) {
    row[name + "_travel"] =
        point.found ? NamedRowValue(static_cast<double>(point.travel)) : NamedRowValue();
    row[name + "_n"] =
        point.found ? NamedRowValue(static_cast<double>(point.force)) : NamedRowValue();
  };
  add("interception", cut.interception);
  add("yield", cut.yield);
  add("bottom_out", cut.bottomOut);
  add("opening", cut.opening);
  return row;
}

std::int64_t numberIn(const NamedRow& row, const std::string& column) {
  const auto* number = std::get_if<std::int64_t>(&row.at(column));
  if (number == nullptr) refuseRows("a row of a trial has no " + column);
  return *number;
}

VisitKey visitOf(SessionId session, const NamedRow& row) {
  return {
      session, static_cast<int>(numberIn(row, "step")), static_cast<int>(numberIn(row, "attempt"))};
}

/// The measured values in JSON, by columns of trial and of cut; missing values are left out.
std::string measurementsAsJson(const NamedRow& trial, const std::vector<NamedRow>& cuts) {
  auto values = presentValues(trial, namesIn(kMeasuredColumns));
  for (const auto& cut : cuts) {
    const auto prefix = prefixOfCut(numberIn(cut, "number"));
    for (auto& [name, value] : presentValues(cut, namesIn(kMeasuredColumnsOfCut))) {
      values.emplace_back(prefix + name, std::move(value));
    }
  }
  return asJson(values);
}

/// The inverse of measurementsAsJson().
void fillIn(NamedRow& trial, std::vector<NamedRow>& cuts, const base::NamedArguments& values) {
  const auto fill = [&](NamedRow& row, std::string_view columns, const std::string& prefix) {
    for (const auto& column : namesIn(columns)) {
      auto& cell = row[column] = std::monostate();
      for (const auto& [name, value] : values) {
        if (name == prefix + column) std::visit([&](const auto& held) { cell = held; }, value);
      }
    }
  };
  fill(trial, kMeasuredColumns, "");
  for (std::int64_t number = 1; number <= numberIn(trial, "cuts"); ++number) {
    NamedRow cut{{"step", trial.at("step")}, {"attempt", trial.at("attempt")}, {"number", number}};
    fill(cut, kMeasuredColumnsOfCut, prefixOfCut(number));
    cuts.push_back(std::move(cut));
  }
}

/// The cuts of one trial.
std::vector<NamedRow> cutsIn(const std::vector<NamedRow>& cuts, const VisitKey& visit) {
  std::vector<NamedRow> found;
  std::ranges::copy_if(cuts, std::back_inserter(found), [&](const NamedRow& cut) {
    return visitOf(visit.session, cut) == visit;
  });
  return found;
}

}  // namespace

void TrialRepository::add(const VisitKey& visit, const TrialRecord& record) {
  UnsealedTrialRows rows{.trials = {rowOf(visit, record)}, .cuts = {}};
  std::int64_t number = 0;
  for (const auto& cut : record.cuts) rows.cuts.push_back(rowOf(visit, ++number, cut));
  add(visit.session, rows, isSimulated(visit.session) ? nullptr : database_.key());
}

void TrialRepository::add(
    SessionId session,
    const UnsealedTrialRows& rows,
    const SealingKey* key,
    const std::set<VisitKey>& open) {
  for (const auto& trial : rows.trials) requireColumns("trial", kTrialColumns, trial);
  for (const auto& cut : rows.cuts) requireColumns("cut", kCutColumns, cut);
  const std::vector<std::pair<std::string, std::int64_t>> keys{
      {"session_id", static_cast<std::int64_t>(session)}};
  std::size_t cuts = 0;
  for (const auto& trial : rows.trials) {
    const auto visit = visitOf(session, trial);
    const auto own = cutsIn(rows.cuts, visit);
    cuts += own.size();
    if (key != nullptr && !open.contains(visit)) {
      addSealed(visit, trial, own, *key);
    } else {
      insertRows(database_, "trial", kTrialColumns, {trial}, keys);
      insertRows(database_, "cut", kCutColumns, own, keys);
    }
  }
  if (cuts != rows.cuts.size()) refuseRows("a cut has no trial");
}

void TrialRepository::addSealed(
    const VisitKey& visit,
    const NamedRow& trial,
    const std::vector<NamedRow>& cuts,
    const SealingKey& key) {
  const auto sealed = sealMeasurements(key, visit, measurementsAsJson(trial, cuts));
  Statement insert(
      database_,
      "INSERT INTO trial (session_id, step, attempt, device, ending, verdict, verdict_reason, "
      "force_unit, travel_unit, duration_s, ticks, nominal_rate_hz, lost_samples, invalid_ticks, "
      "saturated_s, slewed_s, undefined_s, contact_s, largest_force_n, cuts, trace_samples, "
      "sealed) "
      "VALUES (?,?,?,?,?,'PASS','',?,?,0,0,0,0,0,0,0,0,0,0,0,?,?)");
  insert.bindAll(visit);
  int index = 4;
  for (const auto* column : {"device", "ending", "force_unit", "travel_unit", "trace_samples"}) {
    bind(insert, index++, trial.at(column));
  }
  insert.bind(index, std::span<const std::byte>(sealed));
  insert.run();
}

std::vector<std::string> TrialRepository::devices(SessionId session) const {
  Statement select(
      database_, "SELECT DISTINCT device FROM trial WHERE session_id = ? ORDER BY device");
  select.bindAll(session);
  std::vector<std::string> devices;
  while (select.step()) devices.push_back(select.text(0));
  return devices;
}

bool TrialRepository::isSimulated(SessionId session) const {
  Statement select(database_, "SELECT 1 FROM session WHERE id = ? AND run_mode = 'simulated'");
  return select.bindAll(session).step();
}

UnsealedTrialRows trialsOf(const Database& study, SessionId session) {
  const auto select = [&](std::string_view columns, const std::string& table, const char* order) {
    return rowsOf(
        study,
        "SELECT " + std::string(columns) + " FROM " + table + " WHERE session_id = ? ORDER BY " +
            order,
        columns,
        session);
  };
  UnsealedTrialRows rows{.trials = select(kTrialColumns, "trial", "step, attempt"), .cuts = {}};
  const auto open = select(kCutColumns, "cut", "step, attempt, number");
  Statement blob(
      study, "SELECT sealed FROM trial WHERE session_id = ? AND step = ? AND attempt = ?");
  for (auto& trial : rows.trials) {
    const auto visit = visitOf(session, trial);
    blob.bindAll(visit);
    const auto sealed = blob.step() ? blob.blob(0) : std::vector<std::byte>();
    blob.reset();
    if (sealed.empty()) {
      std::ranges::copy(cutsIn(open, visit), std::back_inserter(rows.cuts));
      continue;
    }
    const auto values = valuesIn(openMeasurements(requireKey(study), visit, sealed));
    if (!values) refuseRows("a trial of it cannot be read");
    fillIn(trial, rows.cuts, *values);
  }
  return rows;
}

}  // namespace study::storage
