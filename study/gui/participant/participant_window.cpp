#include "study/gui/participant/participant_window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <QAccessible>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QStyleHints>
#include <QTime>
#include <QTimer>

#include "study/gui/participant/benchmark_page.h"
#include "study/gui/participant/blank_text.h"
#include "study/gui/participant/column.h"
#include "study/gui/participant/questionnaire_page.h"
#include "study/gui/participant/rounds.h"
#include "study/gui/participant/thanks_page.h"
#include "study/gui/participant/trial_page.h"
#include "study/gui/session/tool_picture.h"
#include "study/gui/session/trial_view.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/mnemonics.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {

ParticipantWindow::ParticipantWindow(
    SessionController& controller,
    OperatorPin& pin,
    std::function<void(double)> moveHand,
    QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      moveHand_(std::move(moveHand)),
      progress_(new QProgressBar(this)),
      stepLabel_(bodyLabel({}, this)),
      languages_(new QComboBox(this)),
      rows_(new QVBoxLayout(this)),
      place_(new QVBoxLayout),
      foldLine_(new QFrame(this)),
      bottom_(new QWidget(this)),
      remark_(bodyLabel({}, this)),
      back_(new QPushButton(this)),
      next_(new QPushButton(this)),
      operator_(new QPushButton(this)),
      lock_(new ScreenLock(*this, *operator_, pin)),
      newPageTimer_(new QTimer(this)) {
  setWindowTitle(QStringLiteral("Palpate"));
  disableMnemonics(*this);
  progress_->setTextVisible(false);
  progress_->setFocusPolicy(Qt::NoFocus);
  addLanguages(*languages_, controller.session().protocol().protocol.languages);
  const QString present = QString::fromStdString(controller.session().language());
  languages_->setCurrentIndex(languages_->findData(present));
  next_->setProperty("role", QStringLiteral("next"));
  back_->setProperty("role", QStringLiteral("back"));
  remark_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);

  auto* header = new QWidget(this);
  auto* top = new QHBoxLayout;
  stepLabel_->setWordWrap(false);
  auto* end = new QHBoxLayout;
  for (auto* row : {top, end}) row->setSpacing(18);
  constexpr int kProgressShare = 11;  // shares of the width, so that the bar ends at one place
  constexpr int kEndShare = 9;
  top->addWidget(progress_, kProgressShare);
  top->addLayout(end, kEndShare);
  end->addStretch(1);
  end->addWidget(stepLabel_);
  languages_->setProperty("role", QStringLiteral("language"));
  languages_->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // the font grows with the window
  // The arrow grows as well, but Qt reserves only the width of a small one. A minimum length, in
  // letters as wide as "X", compensates for that.
  int longest = 0;
  for (int i = 0; i < languages_->count(); ++i) {
    longest = std::max(longest, static_cast<int>(languages_->itemText(i).size()));
  }
  languages_->setMinimumContentsLength(longest);
  end->addWidget(languages_);
  end->addWidget(operator_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(16);
  buttons->addWidget(back_);
  buttons->addWidget(remark_, 1);
  buttons->addWidget(next_);
  addColumn(*header, ColumnWidth::Page)->addLayout(top);
  auto* foot = addColumn(*bottom_, ColumnWidth::Page);
  foot->setSpacing(8);
  foot->addWidget(foldLine_);
  foot->addLayout(buttons);
  foldLine_->setProperty("role", QStringLiteral("fold"));
  auto place = foldLine_->sizePolicy();
  place.setRetainSizeWhenHidden(true);
  foldLine_->setSizePolicy(place);
  // A window that was made smaller gets its smaller scale only after the layout.
  rows_->setSizeConstraint(QLayout::SetNoConstraint);
  rows_->addWidget(header);
  rows_->addLayout(place_, 1);
  rows_->addWidget(bottom_);
  adjustScale();

  constexpr int kLeastIgnoreTime = 400;  // [ms]: the usual time of a double click
  newPageTimer_->setObjectName(QStringLiteral("new-page"));
  newPageTimer_->setSingleShot(true);
  newPageTimer_->setInterval(
      std::max(kLeastIgnoreTime, QGuiApplication::styleHints()->mouseDoubleClickInterval()));
  connect(newPageTimer_, &QTimer::timeout, this, [this] { takePresses(true); });
  connect(next_, &QPushButton::clicked, this, &ParticipantWindow::goOn);
  connect(back_, &QPushButton::clicked, this, &ParticipantWindow::goBack);
  connect(&controller_, &SessionController::aboutToLeave, this, [this] {
    if (questions_ != nullptr) questions_->flush();
  });
  connect(languages_, &QComboBox::currentIndexChanged, this, [this] {
    controller_.chooseLanguage(languages_->currentData().toString());
  });
  connect(&controller_, &SessionController::stepChanged, this, &ParticipantWindow::showStep);
  connect(&controller_, &SessionController::languageChanged, this, &ParticipantWindow::showStep);
  connect(&controller_, &SessionController::trialChanged, this, &ParticipantWindow::updateTrial);
  connect(lock_, &ScreenLock::opened, this, [this] {
    if (controller_.isWaiting()) showStep();
  });
  showStep();
}

void ParticipantWindow::showAsOn(QSize screen) {
  screen_ = screen;
  adjustScale();
}

void ParticipantWindow::adjustScale() {
  constexpr double kSteps = 100.0;  // of a picture of a screen
  const double ratio = screen_.isEmpty() ? 1.0 : 1.0 * width() / screen_.width();
  const double scale = screen_.isEmpty() ? scaleFor(size())
                                         : std::floor(kSteps * ratio * scaleFor(screen_)) / kSteps;
  if (scale == scale_) return;
  const double change = scale_ > 0.0 ? scale / scale_ : 1.0;
  for (auto* page : {page_, readAgainPage_}) {
    if (page != nullptr) scaleDistances(*page, change);
  }
  for (auto* frame : {rows_->itemAt(0)->widget(), bottom_}) scaleDistances(*frame, change);
  scale_ = scale;
  setWindowTheme(*this, ThemeName::Light, scale);  // the same for each participant
  // As high on each page as with the languages, so that all titles are at one height.
  languages_->ensurePolished();
  rows_->itemAt(0)->widget()->setMinimumHeight(languages_->sizeHint().height());
  const int above = scaled(*this, 14);
  rows_->setContentsMargins(scaled(*this, 8), above, scaled(*this, 8), above);
  rows_->setSpacing(0);
  place_->setContentsMargins(0, scaled(*this, 10), 0, 0);
}

void ParticipantWindow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  adjustScale();
}

QString ParticipantWindow::localized(const questionnaires::LocalizedText& text) const {
  return withBlanksNamed(
      withUnbrokenNumbers(QString::fromStdString(text.in(controller_.session().language()))));
}

QString ParticipantWindow::alternativeName(const QString& label) const {
  const auto& session = controller_.session();
  return QString::fromStdString(
      session.protocol().protocol.labels.nameOf(label.toStdString(), session.language()));
}

/// "Alternative 1 of 3" if the number is the place in the round, and else only the name.
QString ParticipantWindow::alternativeTitle() const {
  return alternativeName(QString::number(controller_.session().step().label));
}

void ParticipantWindow::retranslate() {
  const auto& session = controller_.session();
  const bool isLast = session.stepIndex() + 1 == static_cast<int>(session.plan().size());
  next_->setText(isLast ? tr("Finish") : tr("Next"));
  back_->setText(tr("Back"));
  languages_->setAccessibleName(tr("Language"));
  operator_->setText(tr("Researcher"));
  const QLocale locale(QString::fromStdString(session.language()));
  setLayoutDirection(locale.textDirection());
}

void ParticipantWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void ParticipantWindow::showStep() {
  const auto& session = controller_.session();
  // The same trial is still running: its page may be in a drag of the mouse that moves the hand.
  if (trialPage_ != nullptr && controller_.isTrialRunning()) {
    trialPage_->setRunning(true, controller_.isDeviceVirtual());
    ignorePresses();
    return;
  }
  retranslate();
  QSignalBlocker quiet(languages_);
  languages_->setCurrentIndex(languages_->findData(QString::fromStdString(session.language())));
  languages_->setVisible(languages_->count() > 1 && session.stepIndex() == 0);
  showPage(makePage());
  updateProgress();
}

/// Whether the page before this step is one that was only read, and may be read again.
bool ParticipantWindow::mayReadAgain() const {
  const auto& session = controller_.session();
  if (session.isOver() || session.stepIndex() == 0) return false;
  return session.plan()[static_cast<std::size_t>(session.stepIndex() - 1)].kind ==
         StepKind::Reading;
}

/// Shows the text before this step once more, in place of the page, which is kept as it is. The
/// session stays at its step: nothing that was acknowledged or answered is taken back.
void ParticipantWindow::readAgain() {
  const auto& session = controller_.session();
  const auto& before = session.plan()[static_cast<std::size_t>(session.stepIndex() - 1)];
  const auto* instrument = session.protocol().instrument(before.instrument);
  readAgainPage_ = new QuestionnairePage(
      {.title = localized(instrument->title),
       .introduction = localized(instrument->introduction),
       .language = QString::fromStdString(session.language())},
      this);
  page_->hide();
  place_->addWidget(readAgainPage_);
  back_->hide();
  remark_->clear();
  readAgainPage_->setFocus();
  ignorePresses();
}

void ParticipantWindow::stopReadingAgain() {
  delete std::exchange(readAgainPage_, nullptr);
  page_->show();
  page_->setFocus();
  showUnanswered(false);
  ignorePresses();
}

void ParticipantWindow::goOn() {
  if (readAgainPage_ != nullptr) return stopReadingAgain();
  if (questions_ == nullptr) {
    controller_.finishStep();
    return;
  }
  if (questions_->progress().open > 0) {
    questions_->scrollToFirstUnanswered();
    showUnanswered(true);
    return;
  }
  showsUnanswered_ = false;
  questions_->turnSheet(true) ? ignorePresses() : controller_.finishStep();
}

void ParticipantWindow::goBack() {
  showsUnanswered_ = false;
  if (questions_ == nullptr || readAgainPage_ != nullptr) return;
  questions_->turnSheet(false) ? ignorePresses() : readAgain();
}

/// Ignores presses for a moment after a page has changed: the second press of a double click on
/// Next would fall on the next page, where it could begin a trial. The keyboard still works,
/// because the focus leaves the button with its page.
void ParticipantWindow::ignorePresses() {
  takePresses(false);
  newPageTimer_->start();
}

void ParticipantWindow::takePresses(bool isTaking) {
  for (auto* part : {page_, readAgainPage_, bottom_}) {
    if (part != nullptr) part->setAttribute(Qt::WA_TransparentForMouseEvents, !isTaking);
  }
}

/// Says how many questions are open once Next was pressed, or that the page goes on below.
void ParticipantWindow::showUnanswered(bool isAskedFor) {
  // Answers typed before Back are stored while the text is read again.
  if (questions_ == nullptr || readAgainPage_ != nullptr) return;
  showsUnanswered_ = showsUnanswered_ || isAskedFor;
  const bool isFirst = controller_.session().stepIndex() == 0 && questions_->sheet() == 0;
  back_->setVisible(!isFirst && (questions_->sheet() > 0 || mayReadAgain()));
  foldLine_->setVisible(questions_->hasMoreBelow());
  updateProgress();
  const auto progress = questions_->progress();
  QString words;
  if (showsUnanswered_ && progress.open > 0) {
    words = progress.open == 1 ? tr("1 question still open")
                               : tr("%1 questions still open").arg(progress.open);
  } else {
    words = questions_->hasMoreBelow() ? tr("More below ↓") : QString();
  }
  remark_->setText(words);
  if (!isAskedFor) return;
  QAccessibleEvent alert(remark_, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void ParticipantWindow::showPage(QWidget* page) {
  delete std::exchange(readAgainPage_, nullptr);
  if (page_ != nullptr) {
    page_->hide();
    page_->setParent(nullptr);  // so that findChild() does not return it any more
    // Until the page is deleted its timers would go on and set the buttons of the next page.
    for (auto* timer : page_->findChildren<QTimer*>()) timer->stop();
    page_->deleteLater();
  }
  page_ = page;
  place_->addWidget(page);
  bottom_->setVisible(!next_->isHidden());
  page->show();
  // A part that is laid out may ask those around it for other sizes. Nothing of that is to be seen.
  constexpr int kRounds = 3;
  for (int i = 0; i < kRounds; ++i)
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  page->setFocus();
  ignorePresses();
}

QWidget* ParticipantWindow::makePage() {
  trialPage_ = nullptr;
  questions_ = nullptr;
  showsUnanswered_ = false;
  remark_->clear();
  back_->hide();
  foldLine_->hide();
  next_->setVisible(true);
  next_->setEnabled(true);
  const auto& session = controller_.session();
  if (session.isOver()) {
    next_->setVisible(false);
    return makeEnd();
  }
  if (controller_.isWaiting()) {
    next_->setVisible(false);
    // While this window covers the screen, the researcher does not see what happened.
    return makeMessage(
        tr("One moment, please"),
        lock_->isLocked() ? tr("Please call the researcher.")
                          : tr("The researcher will go on in a moment."));
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

static QString whenFelt(int place) {
  const std::array words{
      ParticipantWindow::tr("felt first"),
      ParticipantWindow::tr("felt second"),
      ParticipantWindow::tr("felt third"),
      ParticipantWindow::tr("felt fourth")};
  const auto index = static_cast<std::size_t>(place);
  return index < words.size() ? words[index] : QString();
}

QWidget* ParticipantWindow::makeQuestionnaire() {
  const auto& session = controller_.session();
  const auto* instrument = session.instrument();
  QuestionnairePage::Content content{
      .title = localized(instrument->title),
      .introduction = localized(instrument->introduction),
      .items = session.items(),
      .language = QString::fromStdString(session.language()),
      .before = session.answers()};
  if (session.step().kind == StepKind::Questionnaire) {
    content.title = alternativeTitle();
  }
  QStringList hints;
  if (session.step().kind == StepKind::Questionnaire)
    hints << tr("You can change your answers until you press Next.");
  if (isNumberedInFeltOrder(session))
    hints << tr("The numbers are in the order in which you felt them.");
  if (session.step().kind == StepKind::Preference) {
    hints << tr("Answer from memory. If you are unsure, follow your first impression.");
    if (const auto* next = nextTrial(session)) {
      hints
          << (keepsNumbers(session, *next)
                  ? tr("After this, another round follows, with the same alternatives by the same "
                       "numbers.")
                  : tr("After this, another round follows, in which the numbers start again."));
    }
  }
  const bool isLong = content.introduction.contains(u'\n');
  if (!content.introduction.isEmpty() && !hints.isEmpty())
    content.introduction += isLong ? QStringLiteral("\n\n") : QStringLiteral(" ");
  content.introduction += hints.join(QLatin1Char(' '));
  const auto order = feltOrder(session);
  for (const auto& label : session.alternatives()) {
    const auto place = order.find(label);
    content.choices.alternatives.push_back(
        {.id = label,
         .name = alternativeName(QString::fromStdString(label)),
         .note = place == order.end() ? QString() : whenFelt(place->second)});
  }
  questions_ = new QuestionnairePage(content, this);
  connect(questions_, &QuestionnairePage::answered, &controller_, &SessionController::answer);
  connect(questions_, &QuestionnairePage::retracted, &controller_, &SessionController::retract);
  connect(&controller_, &SessionController::notSaved, questions_, &QuestionnairePage::markUnsaved);
  for (const auto signal : {&QuestionnairePage::progressChanged, &QuestionnairePage::scrolled}) {
    connect(questions_, signal, this, [this] { showUnanswered(false); });
  }
  showUnanswered(false);
  return questions_;
}

QWidget* ParticipantWindow::makeTrialPage() {
  next_->setVisible(false);
  const auto& step = controller_.session().step();
  const auto& protocol = controller_.session().protocol().protocol;
  const auto* need = protocol.device(protocol.condition(step.condition)->device);
  auto* picture = viewOfTrial(controller_, this);
  trialPage_ = new TrialPage(
      {.name = alternativeName(QString::number(step.label)),
       .title = alternativeTitle(),
       .minimumCuts = step.minimumCuts,
       .isOptionalTrial = step.isOptionalTrial,
       .reusesLabels = reusesLabels(controller_.session()),
       .device = need->kind,
       .language = controller_.session().language(),
       .isByFeelAlone = picture == nullptr && isAnyTrialVisualised(protocol)},
      picture,
      this);
  connect(trialPage_, &TrialPage::beginRequested, &controller_, &SessionController::beginTrial);
  connect(trialPage_, &TrialPage::declined, &controller_, &SessionController::skipOptionalTrial);
  connect(trialPage_, &TrialPage::finishRequested, &controller_, &SessionController::finishTrial);
  connect(trialPage_, &TrialPage::reamerSwitched, &controller_, &SessionController::toggleReamer);
  connect(trialPage_, &TrialPage::handMoved, this, [this](double share) { moveHand_(share); });
  return trialPage_;
}

QWidget* ParticipantWindow::makeBenchmark() {
  const auto& step = controller_.session().step();
  const auto* phase = controller_.session().protocol().protocol.phase(step.phase);
  const auto& devices = controller_.session().protocol().protocol.devices;
  next_->setVisible(false);
  auto* page = new BenchmarkPage(
      {.text = localized(phase->text), .minimumCuts = step.minimumCuts, .next = next_->text()},
      devices.empty() ? nullptr : toolCardOf(*devices.front().kind, InstrumentIs::Real, this),
      this);
  const auto show = [this, page] { page->setCuts(controller_.session().benchmarkCuts()); };
  connect(page, &BenchmarkPage::finishRequested, &controller_, &SessionController::finishStep);
  connect(&controller_, &SessionController::benchmarkCutsChanged, page, show);
  show();
  return page;
}

QWidget* ParticipantWindow::makeBreak() {
  const auto& step = controller_.session().step();
  const auto* phase = controller_.session().protocol().protocol.phase(step.phase);
  auto* page = makeMessage(tr("A short break"), localized(phase->text));
  // The timer belongs to the page, and stops with it.
  auto* everySecond = new QTimer(page);
  const QDeadlineTimer end(static_cast<qint64>(step.seconds * 1000.0));
  const auto show = [this, end, everySecond] {
    const auto left = (end.remainingTime() + 999) / 1000;  // [s]
    next_->setEnabled(left == 0);
    remark_->setText(
        left == 0 ? QString()
                  : tr("You can go on in %1")
                        .arg(QTime(0, 0)
                                 .addSecs(static_cast<int>(left))
                                 .toString(QStringLiteral("m:ss"))));
    if (left > 0) everySecond->start(static_cast<int>(std::min<qint64>(end.remainingTime(), 1000)));
  };
  everySecond->setSingleShot(true);
  connect(everySecond, &QTimer::timeout, page, show);
  show();
  return page;
}

QWidget* ParticipantWindow::makeEnd() {
  switch (controller_.session().state()) {
    case SessionState::Declined:
      return makeMessage(
          tr("You do not take part"),
          tr("You need not say why. Please tell the researcher that you have decided."));
    case SessionState::Withdrawn:
      return makeThanks(
          tr("You have left the study"), tr("You need not say why. Please tell the researcher."));
    case SessionState::Completed:
      return makeThanks(tr("Thank you"), tr("This session is over. Please tell the researcher."));
    default:  // it may begin again, so nothing is explained
      return makeThanks(
          tr("This session has ended"), tr("This session is over. Please tell the researcher."));
  }
}

/// The last page with the participant's code. In a completed session it is the debrief, if the
/// protocol ends with one.
QWidget* ParticipantWindow::makeThanks(const QString& title, const QString& now) {
  const auto& session = controller_.session();
  const auto& last = session.plan().back();
  const bool isCompleted = session.state() == SessionState::Completed;
  const auto* debrief = isCompleted && last.kind == StepKind::Reading
                            ? session.protocol().instrument(last.instrument)
                            : nullptr;
  const auto& texts = session.protocol().protocol.texts;
  const auto written = texts.find("contact");
  const QString contact = written == texts.end() ? QString() : localized(written->second);
  const QString words = debrief == nullptr ? QString() : localized(debrief->introduction);
  const bool isToldWhomToAsk = !words.isEmpty() && (contact.isEmpty() || words.contains(contact));
  return new ThanksPage(
      {.title = debrief == nullptr ? title : localized(debrief->title),
       .now = words.isEmpty() ? now
                              : tr("Please leave the instrument where it is, and tell the "
                                   "researcher that you have finished."),
       .isCompleted = isCompleted,
       .code = QString::fromStdString(session.participant()),
       .debrief = words,
       .contact = isToldWhomToAsk ? QString()
                  : contact.isEmpty()
                      ? tr("Do you have a question, now or later? Please ask the researcher.")
                      : tr("Do you have a question, now or later? %1").arg(contact)},
      this);
}

QWidget* ParticipantWindow::makeMessage(const QString& title, const QString& words) {
  auto* page = new QWidget(this);
  auto* layout = addColumn(*page);
  layout->addStretch(1);
  auto* heading = titleLabel(title, page);
  auto* body = textLabel(words, page);
  heading->setAlignment(Qt::AlignCenter);
  body->setAlignment(Qt::AlignCenter);
  layout->addWidget(heading);
  layout->addWidget(body);
  layout->addStretch(2);
  return page;
}

/// The round, if there are several; the trial; without both the step; the page of a step that has
/// several.
QStringList ParticipantWindow::whereInSession() const {
  const auto& session = controller_.session();
  if (session.state() == SessionState::Completed) return {tr("Finished")};
  if (session.isOver()) return {};
  QStringList where;
  const auto place = placeOf(session);
  if (place.round > 0 && place.rounds > 1)
    where << tr("Round %1 of %2").arg(place.round).arg(place.rounds);
  if (place.position > 0) where << tr("Trial %1 of %2").arg(place.position).arg(place.alternatives);
  if (where.isEmpty())
    where << tr("Step %1 of %2").arg(session.stepIndex() + 1).arg(session.plan().size());
  if (questions_ != nullptr && questions_->sheets() > 1)
    where << tr("Page %1 of %2").arg(questions_->sheet() + 1).arg(questions_->sheets());
  return where;
}

void ParticipantWindow::updateProgress() {
  const auto& session = controller_.session();
  progress_->setRange(0, static_cast<int>(session.plan().size()));
  progress_->setValue(session.stepIndex() + 1);
  stepLabel_->setText(whereInSession().join(QStringLiteral(" · ")));
  progress_->setAccessibleName(stepLabel_->text());
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
