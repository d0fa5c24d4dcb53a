#include "study/gui/participant/participant_window.h"

#include <utility>

#include <QCloseEvent>
#include <QEvent>
#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QTimer>

#include "study/gui/participant/benchmark_page.h"
#include "study/gui/participant/questionnaire_page.h"
#include "study/gui/participant/trial_page.h"
#include "study/gui/session/trial_view.h"
#include "study/gui/widgets/labels.h"

namespace study::gui {

QString nativeName(const QString& language) {
  // Qt names the default regional variant ("American English").
  if (language == QStringLiteral("en")) return QStringLiteral("English");
  const QString name = QLocale(language).nativeLanguageName();
  return name.isEmpty() ? language : name.left(1).toUpper() + name.mid(1);
}

ParticipantWindow::ParticipantWindow(
    SessionController& controller,
    OperatorPin& pin,
    std::function<void(double)> moveHand,
    QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      moveHand_(std::move(moveHand)),
      progress_(new QProgressBar(this)),
      languages_(new QComboBox(this)),
      place_(new QVBoxLayout),
      next_(new QPushButton(this)),
      operator_(new QPushButton(this)),
      lock_(new ScreenLock(*this, *operator_, pin)) {
  setWindowTitle(QStringLiteral("Palpate"));
  progress_->setTextVisible(false);
  progress_->setFocusPolicy(Qt::NoFocus);
  for (const auto& language : controller.session().protocol().protocol.languages) {
    const QString tag = QString::fromStdString(language);
    languages_->addItem(nativeName(tag), tag);
  }
  const QString present = QString::fromStdString(controller.session().language());
  languages_->setCurrentIndex(languages_->findData(present));
  next_->setProperty("role", QStringLiteral("next"));

  auto* top = new QHBoxLayout;
  top->addWidget(progress_, 1);
  top->addSpacing(24);
  top->addWidget(languages_);
  top->addWidget(operator_);
  auto* bottom = new QHBoxLayout;
  bottom->addStretch(1);
  bottom->addWidget(next_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(48, 24, 48, 32);
  layout->setSpacing(18);
  layout->addLayout(top);
  layout->addLayout(place_, 1);
  layout->addLayout(bottom);

  connect(next_, &QPushButton::clicked, &controller_, &SessionController::finishStep);
  connect(&controller_, &SessionController::aboutToLeave, this, [this] {
    if (questions_ != nullptr) questions_->flush();
  });
  connect(languages_, &QComboBox::currentIndexChanged, this, [this] {
    controller_.chooseLanguage(languages_->currentData().toString());
  });
  connect(&controller_, &SessionController::stepChanged, this, &ParticipantWindow::showStep);
  connect(&controller_, &SessionController::languageChanged, this, &ParticipantWindow::showStep);
  connect(&controller_, &SessionController::trialChanged, this, &ParticipantWindow::updateTrial);
  showStep();
}

QString ParticipantWindow::localized(const questionnaires::LocalizedText& text) const {
  return QString::fromStdString(text.in(controller_.session().language()));
}

QString ParticipantWindow::alternativeName(const QString& label) const {
  return localized(controller_.session().protocol().protocol.labels.prefix) + QStringLiteral(" ") +
         label;
}

void ParticipantWindow::retranslate() {
  next_->setText(tr("Next"));
  languages_->setAccessibleName(tr("Language"));
  operator_->setText(tr("Researcher"));
  const QLocale locale(QString::fromStdString(controller_.session().language()));
  setLayoutDirection(locale.textDirection());
}

void ParticipantWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void ParticipantWindow::showStep() {
  const auto& session = controller_.session();
  // The same trial is still running: keep its page, which has the mouse.
  if (trialPage_ != nullptr && controller_.isTrialRunning()) {
    trialPage_->setRunning(true);
    return;
  }
  retranslate();
  updateProgress();
  QSignalBlocker quiet(languages_);
  languages_->setCurrentIndex(languages_->findData(QString::fromStdString(session.language())));
  languages_->setVisible(languages_->count() > 1 && session.stepIndex() == 0);
  showPage(makePage());
}

void ParticipantWindow::showPage(QWidget* page) {
  if (page_ != nullptr) {
    page_->hide();
    page_->setParent(nullptr);  // so that findChild() does not return it any more
    page_->deleteLater();
  }
  page_ = page;
  place_->addWidget(page);
  page->setFocus();
}

QWidget* ParticipantWindow::makePage() {
  trialPage_ = nullptr;
  questions_ = nullptr;
  next_->setVisible(true);
  next_->setEnabled(true);
  const auto& session = controller_.session();
  if (session.isOver()) {
    next_->setVisible(false);
    return makeEnd();
  }
  if (session.state() == SessionState::Paused || session.state() == SessionState::Interrupted) {
    next_->setVisible(false);
    return makeMessage(tr("One moment, please"), tr("The researcher will go on in a moment."));
  }
  switch (session.step().kind) {
    case StepKind::Trial:
      return makeTrialPage();
    case StepKind::Benchmark:
      return makeBenchmark();
    case StepKind::Break:
      return makeBreak();
    case StepKind::Interview:
      next_->setVisible(false);
      return makeMessage(tr("A few questions"), tr("The researcher would like to talk with you."));
    default:
      return makeQuestionnaire();
  }
}

QWidget* ParticipantWindow::makeQuestionnaire() {
  const auto& session = controller_.session();
  const auto* instrument = session.instrument();
  QuestionnairePage::Content content{
      .title = localized(instrument->title),
      .introduction = localized(instrument->introduction),
      .items = session.items(),
      .choices = {},
      .language = QString::fromStdString(session.language()),
      .before = session.answers()};
  if (session.step().kind == StepKind::Questionnaire) {
    content.title = alternativeName(QString::number(session.step().label));
  }
  for (const auto& label : session.step().alternatives) {
    content.choices.alternatives.emplace_back(
        label, alternativeName(QString::fromStdString(label)));
  }
  questions_ = new QuestionnairePage(content, this);
  next_->setEnabled(questions_->isComplete());
  connect(questions_, &QuestionnairePage::answered, &controller_, &SessionController::answer);
  connect(questions_, &QuestionnairePage::retracted, &controller_, &SessionController::retract);
  connect(&controller_, &SessionController::notSaved, questions_, &QuestionnairePage::markUnsaved);
  connect(questions_, &QuestionnairePage::completeChanged, next_, &QPushButton::setEnabled);
  return questions_;
}

QWidget* ParticipantWindow::makeTrialPage() {
  next_->setVisible(false);
  const auto& step = controller_.session().step();
  const auto& protocol = controller_.session().protocol().protocol;
  const auto* need = protocol.device(protocol.condition(step.condition)->device);
  trialPage_ = new TrialPage(
      {.name = alternativeName(QString::number(step.label)),
       .minimumCuts = step.minimumCuts,
       .isOffered = step.isOffered,
       .device = need->kind,
       .language = controller_.session().language()},
      viewOfTrial(controller_, this),
      this);
  connect(trialPage_, &TrialPage::beginRequested, &controller_, &SessionController::beginTrial);
  connect(trialPage_, &TrialPage::declined, &controller_, &SessionController::declineOffer);
  connect(trialPage_, &TrialPage::enoughRequested, &controller_, &SessionController::finishTrial);
  connect(trialPage_, &TrialPage::reamerSwitched, &controller_, &SessionController::toggleReamer);
  connect(trialPage_, &TrialPage::handMoved, this, [this](double share) { moveHand_(share); });
  return trialPage_;
}

QWidget* ParticipantWindow::makeBenchmark() {
  const auto& step = controller_.session().step();
  const auto* phase = controller_.session().protocol().protocol.phase(step.phase);
  auto* page = new BenchmarkPage(localized(phase->text), step.minimumCuts, this);
  const auto show = [this, page] {
    const int cuts = controller_.session().benchmarkCuts();
    page->setCuts(cuts);
    next_->setEnabled(cuts >= controller_.session().step().minimumCuts);
  };
  connect(page, &BenchmarkPage::cutMade, this, [this, show] {
    controller_.countBenchmarkCut();
    show();
  });
  show();
  return page;
}

QWidget* ParticipantWindow::makeBreak() {
  const auto& step = controller_.session().step();
  const auto* phase = controller_.session().protocol().protocol.phase(step.phase);
  next_->setEnabled(false);
  auto* page = makeMessage(tr("A short break"), localized(phase->text));
  // The timer belongs to the page: if the page changes, Next must stay as the new page sets it.
  QTimer::singleShot(
      static_cast<int>(step.seconds * 1000.0), page, [this] { next_->setEnabled(true); });
  return page;
}

QWidget* ParticipantWindow::makeEnd() {
  switch (controller_.session().state()) {
    case SessionState::Declined:
      return makeMessage(
          tr("You do not take part"),
          tr("You need not say why. Please tell the researcher that you have decided."));
    case SessionState::Withdrawn:
      return makeMessage(
          tr("You have left the study"), tr("You need not say why. Please tell the researcher."));
    default:
      return makeMessage(tr("Thank you"), tr("This session is over. Please tell the researcher."));
  }
}

QWidget* ParticipantWindow::makeMessage(const QString& title, const QString& words) {
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->addStretch(1);
  auto* heading = titleLabel(title, page);
  auto* body = bodyLabel(words, page);
  heading->setAlignment(Qt::AlignCenter);
  body->setAlignment(Qt::AlignCenter);
  layout->addWidget(heading);
  layout->addWidget(body);
  layout->addStretch(2);
  return page;
}

void ParticipantWindow::updateProgress() {
  const auto& session = controller_.session();
  progress_->setRange(0, static_cast<int>(session.plan().size()));
  progress_->setValue(session.stepIndex());
  progress_->setAccessibleName(
      tr("Step %1 of %2").arg(session.stepIndex() + 1).arg(session.plan().size()));
}

void ParticipantWindow::updateTrial() {
  if (trialPage_ == nullptr) return;
  trialPage_->setCuts(controller_.trialStatus().cuts);
}

void ParticipantWindow::closeEvent(QCloseEvent* event) {
  // Only the operator can end a session.
  mayClose_ ? event->accept() : event->ignore();
}

}  // namespace study::gui
