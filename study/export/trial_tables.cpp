// The columns of trials.csv, cuts.csv and of traces.
#include "study/export/study_columns.h"

namespace study {
namespace {

/// A getter for a member of the row's record.
template <typename Row, typename Member>
auto recordMember(Member member) {
  return [member](const Row& row) { return std::invoke(member, *row.record); };
}

template <typename Member>
auto sampleMember(Member member) {
  return [member](const ExportedTick& tick) { return std::invoke(member, tick.sample); };
}

}  // namespace

Table<ExportedTrial> trialTable() {
  using namespace holds;
  using Row = ExportedTrial;
  using Trial = storage::StoredTrial;
  const auto fromRecord = [](auto member) { return recordMember<Row>(member); };
  return {
      .name = "trials",
      .description = "One row per trial: how well what was felt was rendered.",
      .columns =
          {participantColumn<Row>(),
           sessionNumberColumn<Row>(),
           cohortColumn<Row>(),
           siteColumn<Row>(),
           runModeColumn<Row>(),
           stepNumberColumn<Row>(),
           attemptColumn<Row>(),
           blockColumn<Row>(),
           positionColumn<Row>(),
           alternativeColumn<Row>(),
           conditionCodeColumn<Row>(),
           conditionColumn<Row>(),
           {"device", Text{}, "Which device", fromRecord(&Trial::device)},
           {"travel_unit",
            Text{},
            "Unit of the tool's travel, in cuts and traces",
            fromRecord(&Trial::travelUnit)},
           {"ending",
            Text{},
            "How it ended: finished, stopped, aborted_hardware, trace_lost, timed_out, "
            "program_ended",
            fromRecord(&Trial::ending)},
           {"qc_status",
            OneOf{ValueList::Verdicts},
            "PASS, WARN or FAIL",
            fromRecord(&Trial::verdict)},
           {"qc_reason",
            Text{},
            "Why",
            [](const Row& row) { return base::describe(row.record->reasons); }},
           {"duration_s", Number{"s"}, "Of the engine's own time", fromRecord(&Trial::duration)},
           {"cuts", Integer{}, "Cuts (strokes) that were made", fromRecord(&Trial::cuts)},
           {"contact_s", Number{"s"}, "How long something was felt", fromRecord(&Trial::contact)},
           {"saturation_s",
            Number{"s"},
            "How long the scene asked for more than the limit",
            fromRecord(&Trial::saturated)},
           {"slewed_s",
            Number{"s"},
            "How long it asked for a faster change than the limit",
            fromRecord(&Trial::slewed)},
           {"undefined_s", Number{"s"}, "How long it had no answer", fromRecord(&Trial::undefined)},
           {"ticks", Integer{}, "Steps of the force loop", fromRecord(&Trial::ticks)},
           {"nominal_rate_hz",
            Number{"Hz"},
            "Rate of the force loop as asked for",
            fromRecord(&Trial::nominalRate)},
           {"loop_rate_hz",
            Number{"Hz"},
            "… as reached; empty where no clock was running",
            fromRecord(&Trial::achievedRate)},
           {"lateness_p50_us",
            Number{"µs"},
            "Median lateness of a tick",
            fromRecord(&Trial::latenessMedian)},
           {"lateness_p99_us",
            Number{"µs"},
            "99 % of ticks were not later",
            fromRecord(&Trial::latenessP99)},
           {"lateness_max_us", Number{"µs"}, "The latest", fromRecord(&Trial::latenessLargest)},
           {"deadline_misses",
            Integer{},
            "Ticks later than a whole period",
            fromRecord(&Trial::lateTicks)},
           {"lost_samples",
            Integer{},
            "Samples that the recorder could not take",
            fromRecord(&Trial::lostSamples)},
           {"invalid_ticks",
            Integer{},
            "Ticks without a measurement",
            fromRecord(&Trial::invalidTicks)},
           {"trace_samples",
            Integer{},
            "Samples kept in traces.db",
            fromRecord(&Trial::traceSamples)}},
      // The duration of contact, limited forces, failed checks, and even the lateness of the loop
      // depend on the rendering.
      .revealsCondition = true};
}

Table<ExportedCut> cutTable() {
  using namespace holds;
  using Row = ExportedCut;
  using Cut = storage::CutRecord;
  const auto fromRecord = [](auto member) { return recordMember<Row>(member); };
  return {
      .name = "cuts",
      .description = "One row per cut (stroke), with its landmarks; what was not found is missing.",
      .columns =
          {participantColumn<Row>(),
           sessionNumberColumn<Row>(),
           siteColumn<Row>(),
           stepNumberColumn<Row>(),
           attemptColumn<Row>(),
           {"cut_num", Integer{}, "From 1", fromRecord(&Cut::number)},
           {"interception_travel",
            Number{},
            "Where the load began to rise [travel unit of the device]",
            fromRecord(&Cut::interceptionTravel)},
           {"interception_n",
            Number{"N"},
            "… and the force there",
            fromRecord(&Cut::interceptionForce)},
           {"yield_travel",
            Number{},
            "Where the surface was cut through",
            fromRecord(&Cut::yieldTravel)},
           {"yield_n", Number{"N"}, "… and the force there", fromRecord(&Cut::yieldForce)},
           {"bottom_out_travel",
            Number{},
            "Where the end of travel was reached",
            fromRecord(&Cut::bottomOutTravel)},
           {"bottom_out_n", Number{"N"}, "… and the force there", fromRecord(&Cut::bottomOutForce)},
           {"opening_travel",
            Number{},
            "Where the force was largest before contact was lost",
            fromRecord(&Cut::openingTravel)},
           {"opening_n", Number{"N"}, "… and the force there", fromRecord(&Cut::openingForce)},
           {"peak_n", Number{"N"}, "Largest force of the cut", fromRecord(&Cut::peakForce)}},
      // the force at yield identifies the condition
      .revealsCondition = true};
}

Table<ExportedTick> traceTable() {
  using namespace holds;
  using Sample = storage::TraceSample;
  return {
      .name = "force",
      .description = "One gzip-compressed CSV per trial, one row per tick of the force loop.",
      .columns =
          {{"tick", Integer{}, "Which tick of the trial", sampleMember(&Sample::tick)},
           {"time_s", Number{"s"}, "… and when, by the rate asked for", &ExportedTick::time},
           {"travel",
            Number{},
            "Of the tool, in the device's travel unit",
            sampleMember(&Sample::travel)},
           {"velocity_per_s", Number{}, "… and that per second", sampleMember(&Sample::velocity)},
           {"desired_n", Number{"N"}, "What the scene asked for", sampleMember(&Sample::desired)},
           {"force_n", Number{"N"}, "What the device was told", sampleMember(&Sample::force)},
           {"lateness_us",
            Number{"µs"},
            "Of the tick against its due time",
            sampleMember(&Sample::lateness)},
           {"status",
            Integer{},
            "0 measured, 1 not new, 2 the device says that it is faulty, 3 it does not answer",
            sampleMember(&Sample::status)},
           {"interventions",
            Integer{},
            "A sum: 1 limited to the largest force, 2 to the fastest change, 4 no number, 8 "
            "damped, 16 the scene gave more energy than it took; of the torque: 32 limited to the "
            "largest, 64 to the fastest change, 128 more energy given than taken",
            sampleMember(&Sample::interventions)},
           {"marks",
            Integer{},
            "A sum: 1 no measurement, 2 no force is defined here, 4 stopped, 8 no scene, 16 the "
            "tool is too fast, 32 nobody holds the dead-man switch, 64 the force comes on softly, "
            "128 the clock lost beats",
            sampleMember(&Sample::marks)},
           {"landmark",
            Integer{},
            "0 nothing, 1 interception, 2 yield, 3 end of travel, 4 opening, 5 a cut is complete",
            sampleMember(&Sample::landmark)},
           {"desired_nm",
            Number{"N·m"},
            "Torque about the tool's axis that the scene asked for, right-handed about the way of "
            "advancing; in traces with a torque only",
            sampleMember(&Sample::desiredTorque)},
           {"torque_nm",
            Number{"N·m"},
            "… and that the device was told; 0 where it renders none",
            sampleMember(&Sample::torque)}},
      .revealsCondition = true};
}

Table<ExportedTick> traceTableWithoutTorque() {
  auto table = traceTable();
  std::erase_if(table.columns, [](const auto& column) {
    return column.name() == "desired_nm" || column.name() == "torque_nm";
  });
  return table;
}

}  // namespace study
