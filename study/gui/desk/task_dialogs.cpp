#include "study/gui/desk/task_dialogs.h"

#include <algorithm>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include "study/cohort/simulated_participant.h"
#include "study/gui/desk/study_dialogs.h"
#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/background_task.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/field_row.h"
#include "study/gui/widgets/studio_settings.h"
#include "study/gui/widgets/written_file.h"
#include "study/report/tables/plan_tables.h"
#include "study/report/tables/statistics_tables.h"
#include "study/results/study_plan.h"
#include "study/session/unblinding.h"

namespace study::gui {
namespace {

using Access = storage::Database::Access;

constexpr int kMostSimulated = 100'000;
constexpr int kMostPlanned = 1000;
constexpr int kPlanWidth = 900;  // [px]
constexpr int kStatisticsWidth = 1240;

/// "as planned: 6, 5", each number once.
QString asPlanned(const StudySummary& study) {
  QStringList numbers;
  for (const auto& cohort : study.cohorts) {
    if (cohort.planned > 0) numbers << QString::number(cohort.planned);
  }
  numbers.removeDuplicates();
  return numbers.isEmpty()
             ? PlanDialog::tr("as planned in the protocol")
             : PlanDialog::tr("as planned: %1").arg(numbers.join(QStringLiteral(", ")));
}

}  // namespace

AmendDialog::AmendDialog(const StudySummary& study, QWidget* parent)
    : WorkDialog(
          tr("Change the protocol"),
          tr("New sessions use the changed protocol; sessions that have begun keep theirs. All "
             "versions stay in the study."),
          tr("Change"),
          parent),
      folder_(study.folder),
      file_(new PathField(
          PathField::Kind::ExistingFile, tr("Changed protocol"), tr("Protocols (*.json)"), this)) {
  attempt(this, MessageTopic::ProtocolNotChanged, [this] {
    present_ = Study::open(folder_, Access::ReadOnly).protocol();
  });
  file_->startIn(protocolFolder());
  auto* save = new QPushButton(tr("Save the study’s protocol…"), this);
  save->setObjectName(QStringLiteral("save-protocol"));
  save->setAutoDefault(false);
  save->setEnabled(present_.has_value());
  form().addRow(tr("1. Save it as a file"), save);
  auto* how = quietLabel(tr("In a text editor; all its texts are in it."), this);
  how->setSizePolicy(QSizePolicy::Expanding, how->sizePolicy().verticalPolicy());
  form().addRow(tr("2. Change the file"), how);
  form().addRow(tr("3. Choose the changed file"), file_);
  connect(save, &QPushButton::clicked, this, &AmendDialog::savePresentProtocol);
  addReason(tr("4. Reason for the change"), [this] { updateButton(); });
  connect(file_, &PathField::pathChanged, this, &AmendDialog::check);
  connect(&watch_, &FileWatch::changed, this, &AmendDialog::check);
  check();
}

void AmendDialog::check() {
  checked_ = {};
  isDone_ = false;
  clear();
  const auto path = file_->path().toStdString();
  if (!path.empty()) {
    checked_ = checkProtocol(path, present_ ? &*present_ : nullptr);
    auto notes = checked_.notes();
    const auto changes = changesInMeaning();
    notes.insert(notes.begin(), changes.begin(), changes.end());
    showOutcome(checked_.mark(), QString::fromStdString(checked_.verdict()), notes);
  }
  watch_.watch(path.empty() ? QStringList() : checked_.files());
  updateButton();
}

std::vector<Note> AmendDialog::changesInMeaning() {
  std::vector<Note> notes;
  if (!checked_.loaded) return notes;
  attempt(this, MessageTopic::ProtocolNotChanged, [&] {
    auto study = Study::open(folder_, Access::ReadOnly);
    auto changes = changesInWords(study, *checked_.loaded);
    if (changes.isEmpty()) return;
    changes << tr(
        "Results will say so. To keep both apart, give what is changed an id of its own, or make a "
        "new study.");
    notes.push_back(
        {tr("What was answered or felt so far means something else in this version:"),
         Mark::Warning,
         changes});
  });
  return notes;
}

void AmendDialog::savePresentProtocol() {
  const auto id = QString::fromStdString(present_->protocol.study.id);
  auto file = QFileDialog::getSaveFileName(
      this,
      tr("Save the study’s protocol"),
      unusedPath(QDir(protocolFolder()).filePath(id), QStringLiteral(".json")),
      tr("Protocols (*.json)"),
      nullptr,
      QFileDialog::DontConfirmOverwrite);  // nothing is overwritten
  if (file.isEmpty()) return;
  if (QFileInfo(file).suffix().isEmpty()) file += QStringLiteral(".json");
  const bool isSaved = attempt(this, MessageTopic::OwnProtocolNotSaved, [&] {
    saveProtocol(*present_, file.toStdString());
  });
  if (!isSaved) return;
  rememberProtocolFolder(file);
  showWrittenFileMessage(this, file);
  file_->setPath(file);
}

void AmendDialog::updateButton() {
  if (isDone_) return runButton().setEnabled(false);
  setDisabledReason(
      file_->path().isEmpty() ? tr("Choose the changed protocol.")
      : !checked_.loaded      ? tr("The protocol has errors.")
      : reason().empty()      ? tr("Give a reason.")
                              : QString());
}

void AmendDialog::work() {
  bool isSame = false;
  const bool isDone = attempt(this, MessageTopic::ProtocolNotChanged, [&] {
    auto study = Study::open(folder_);
    const auto& protocol = *checked_.loaded;
    isSame = storage::isSame(study.protocols().current(), protocol);
    if (!isSame) study.amend(protocol, reason());
  });
  if (!isDone) return;
  isDone_ = true;
  updateButton();
  if (isSame) {
    return showOutcome(
        Outcome::Warning,
        tr("This is the protocol that the study uses already."),
        {{tr("When the file is changed, it is read again.")}});
  }
  showOutcome(
      Outcome::Good,
      tr("Protocol changed. New sessions use it from now on."),
      checked_.keptTexts.empty() ? std::vector<Note>()
                                 : std::vector<Note>{{checked_.keptTextsInWords()}});
}

SimulateDialog::SimulateDialog(const StudySummary& study, QWidget* parent)
    : WorkDialog(
          tr("Simulate participants"),
          tr("Simulated participants go through the same steps as people, so that reports and "
             "exports can be tried. Their answers follow the protocol’s assumptions on how real "
             "each "
             "condition feels, and chance. They are kept apart from those of people."),
          tr("Simulate"),
          parent),
      folder_(study.folder),
      participants_(new QSpinBox(this)) {
  participants_->setObjectName(QStringLiteral("participants"));
  participants_->setAccessibleName(tr("Simulated participants in all"));
  const int already = countIn(study.sessions, RunMode::Simulated);
  participants_->setRange(already + 1, kMostSimulated);
  int planned = 0;
  for (const auto& cohort : study.cohorts) planned += cohort.planned;
  participants_->setValue(std::max(planned, already + 1));
  form().addRow(
      already > 0 ? tr("Simulated participants in all (%1 so far)").arg(already)
                  : tr("Simulated participants"),
      participants_);
  QStringList cohorts;
  for (const auto& cohort : study.cohorts) {
    if (cohort.planned == 0) continue;
    cohorts << tr("%1: %2 planned").arg(QString::fromStdString(cohort.title)).arg(cohort.planned);
  }
  if (!cohorts.isEmpty()) addHint(cohorts.join(QStringLiteral("; ")));
}

void SimulateDialog::work() {
  std::vector<SimulatedSessionResult> endings;
  const int wanted = participants_->value();
  const int more = wanted - participants_->minimum() + 1;
  const QString words = tr("participant %1 of %2");
  const bool isDone = BackgroundTask::run(
      this, tr("Simulating"), MessageTopic::SimulationNotFinished, [&](const Progress& progress) {
        SimulatedClock clock;
        auto study = Study::open(folder_, clock);
        int begun = 0;
        const auto seed = simulationSeed(study);
        endings = simulateCohorts(study, clock, wanted, seed, [&](const SimulationEvent& done) {
          if (done.kind == SimulationEvent::Kind::Enrolment) ++begun;
          const int before = std::max(0, begun - 1);
          announceProgress(
              progress,
              static_cast<double>(before) / more,
              words.arg(before + 1).arg(more).toStdString());
        });
      });
  if (!isDone) return clear();
  const auto completed = std::ranges::count_if(endings, [](const SimulatedSessionResult& ending) {
    return ending.state == SessionState::Completed;
  });
  showOutcome(
      completed == static_cast<std::ptrdiff_t>(endings.size()) ? Outcome::Good : Outcome::Warning,
      tr("%1 of %2 simulated participants have finished.").arg(completed).arg(endings.size()));
}

PlanDialog::PlanDialog(const StudySummary& study, QWidget* parent)
    : WorkDialog(
          tr("Plan the study"),
          tr("How many participants balance the orders, how many an effect needs, how long a "
             "session takes. Computed from the protocol and simulated answers; no data are read."),
          tr("Compute"),
          parent),
      folder_(study.folder),
      participants_(new QSpinBox(this)),
      effect_(new QDoubleSpinBox(this)),
      power_(new QDoubleSpinBox(this)),
      result_(new ResultView(this)) {
  participants_->setObjectName(QStringLiteral("participants"));
  participants_->setRange(0, kMostPlanned);
  participants_->setSpecialValueText(asPlanned(study));
  effect_->setObjectName(QStringLiteral("effect"));
  effect_->setRange(0.05, 10.0);
  effect_->setSingleStep(0.1);
  effect_->setValue(StudyPlanOptions().dz);
  power_->setObjectName(QStringLiteral("power"));
  power_->setRange(0.5, 0.99);
  power_->setSingleStep(0.05);
  power_->setValue(StudyPlanOptions().power);
  auto* fields = new FieldRow(this);
  fields->add(tr("Participants of each cohort"), participants_);
  fields->add(tr("Effect to find, d_z"), effect_);
  fields->add(tr("Power to reach"), power_);
  connect(participants_, &QSpinBox::valueChanged, this, [this] { setMain(true); });
  for (auto* number : {effect_, power_}) {
    connect(number, &QDoubleSpinBox::valueChanged, this, [this] { setMain(true); });
  }
  form().addRow(fields);
  form().addRow(quietLabel(
      tr("d_z is the mean difference between two methods, divided by the standard deviation of the "
         "participants’ differences."),
      this));
  addResult(result_);
  result_->hide();
  widen(kPlanWidth);
  fit();
}

void PlanDialog::work() {
  StudyPlanOptions planOptions{.dz = effect_->value(), .power = power_->value()};
  if (participants_->value() > 0) {
    planOptions.participants = static_cast<std::uint64_t>(participants_->value());
  }
  StudyPlan plan;
  const bool isDone = BackgroundTask::run(
      this, tr("Computing"), MessageTopic::PlanNotComputed, [&](const Progress& progress) {
        announceProgress(progress, kUnknownShare, "simulating studies");
        auto study = Study::open(folder_, Access::ReadOnly);
        plan = planOf(study.protocol(), planOptions);
      });
  setMain(!isDone);
  result_->setVisible(isDone);
  if (isDone) {
    const auto words = words::wordsIn(deskLanguage());
    result_->show(report::planInWords(plan, words), report::planTables(plan, words));
  }
  fit();
}

StatisticsDialog::StatisticsDialog(const StudySummary& study, QWidget* parent)
    : WorkDialog(
          tr("Statistics"),
          tr("Means, the declared tests, preferences. The tables name every condition: do not open "
             "them if you must stay blinded."),
          tr("Show"),
          parent),
      folder_(study.folder),
      mode_(makeRunModeBox(study, this)),
      profile_(new QComboBox(this)),
      result_(new ResultView(this)) {
  profile_->setAccessibleName(tr("Which tests"));
  const auto add = [&](const QString& words, Profile profile) {
    profile_->addItem(words, static_cast<int>(profile));
  };
  add(tr("As the protocol declares"), Profile::Declared);
  add(tr("Within participants, with effect sizes"), Profile::Recommended);
  add(tr("As published: answers pooled"), Profile::AsPublished);
  auto* fields = new FieldRow(this);
  fields->add(tr("Sessions"), mode_);
  fields->add(tr("Tests"), profile_);
  form().addRow(fields);
  addReason(tr("Reason for unblinding"), [this] { updateChoices(); });
  addResult(result_);
  widen(kStatisticsWidth);
  const auto forget = [this] {
    section_.reset();
    updateChoices();
  };
  connect(mode_, &QComboBox::currentIndexChanged, this, forget);
  connect(profile_, &QComboBox::currentIndexChanged, this, &StatisticsDialog::showResults);
  updateChoices();
}

void StatisticsDialog::updateChoices() {
  const bool isOfPeople = chosenMode(*mode_) != RunMode::Simulated;
  showReason(isOfPeople);
  setDisabledReason(
      !hasSessions(*mode_)             ? noSessionsText()
      : isOfPeople && reason().empty() ? tr("Give a reason.")
                                       : QString());
  showResults();
}

void StatisticsDialog::showResults() {
  runButton().setVisible(!section_);  // all is shown
  result_->setVisible(section_.has_value());
  if (section_) {
    const auto profile = static_cast<Profile>(profile_->currentData().toInt());
    auto answer = report::answerInWords(*section_);
    const bool isCorrected =
        std::ranges::any_of(section_->results.families, [](const FamilyResult& family) {
          return family.family.correction != protocols::CorrectionType::None;
        });
    if (isCorrected) {
      answer.caveats.push_back(translated(
          "Intervals are those of one comparison, not adjusted for several: where they and "
          "the adjusted p differ, the words go by the adjusted p."));
    }
    result_->show(answer, report::statisticsTables(*section_, profile));
  }
  showNotice(Mark::Warning, section_ ? asText(report::originInWords(*section_)) : QString());
  fit();
}

void StatisticsDialog::work() {
  const auto mode = chosenMode(*mode_);
  const auto why = reason();
  section_.reset();
  const auto words = words::wordsIn(deskLanguage());
  BackgroundTask::run(
      this, tr("Computing"), MessageTopic::StatisticsNotComputed, [&](const Progress& progress) {
        announceProgress(progress, kUnknownShare, "computing the tables");
        auto study = Study::open(folder_, accessForUnblinding(why));
        recordUnblinding(study, mode, EventKind::UnblindedResults, why);
        section_ = report::gatherResults(study, mode, words);
      });
  showResults();
}

}  // namespace study::gui
