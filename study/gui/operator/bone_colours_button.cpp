#include "study/gui/operator/bone_colours_button.h"

#include <algorithm>

#include <QApplication>
#include <QScreen>

#include "study/gui/participant/participant_window.h"
#include "study/gui/widgets/message_box.h"
#include "study/session/trial_setup.h"

namespace study::gui {
namespace {

/// Whether any trial of @p protocol shows a bone of spheres. The result is the same in each step of
/// a study, so it does not reveal the condition of a step.
bool isBoneVisualised(const protocols::Protocol& protocol) {
  const bool isAnyBlockSeen =
      std::any_of(protocol.phases.begin(), protocol.phases.end(), [](const auto& phase) {
        return phase.trials.isVisualised.value_or(false);
      });
  const auto& conditions = protocol.conditions;
  return std::any_of(conditions.begin(), conditions.end(), [&](const auto& condition) {
    return haptics::engine::partsOf(*condition.model).packing != nullptr &&
           (isAnyBlockSeen || condition.isVisualised);
  });
}

}  // namespace

QString reasonForNoColours(const Session& session) {
  const bool areLabelsDrawn =
      session.protocol().protocol.labels.policy != protocols::LabelPolicy::Condition;
  if (!session.isBlinded() || !areLabelsDrawn) return {};
  return BoneColoursButton::tr(
      "This study is double-blind: which alternative is which is hidden from you as well, and the "
      "bone's colours could tell. In a pilot session they can be seen.");
}

BoneColoursButton::BoneColoursButton(QWidget* parent) : QPushButton(tr("See the bone…"), parent) {
  setProperty("role", QStringLiteral("tool"));
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(this, &QPushButton::clicked, this, &BoneColoursButton::openWindow);
  setController(nullptr);
}

BoneColoursButton::~BoneColoursButton() {
  closeWindow();
}

void BoneColoursButton::setController(SessionController* controller) {
  closeWindow();
  controller_ = controller;
  isAllowed_ = false;
  setVisible(controller != nullptr && isBoneVisualised(controller->session().protocol().protocol));
  if (controller == nullptr) return;
  const QString why = reasonForNoColours(controller->session());
  isAllowed_ = why.isEmpty();
  setToolTip(
      isAllowed_ ? tr("While a bone is reamed: how hard it is and what has been removed, in a "
                      "window of its own that participants do not see")
                 : why);
  refresh();
}

scene::BoneColoursWindow::FollowedTrial BoneColoursButton::present() const {
  if (controller_ == nullptr || !controller_->isTrialRunning()) return {};
  auto* bone = controller_->visibleHipScene();
  if (bone == nullptr || bone->spheres() == nullptr) return {};
  return {.participantView = bone, .isRunning = true};
}

void BoneColoursButton::refresh() {
  const bool isThere = isAllowed_ && present().participantView != nullptr;
  if (isEnabled() != isThere) setEnabled(isThere);
  if (!isThere) closeWindow();
}

void BoneColoursButton::closeWindow() {
  delete window_.data();  // at once, because the window's trial may be deleted next
}

bool BoneColoursButton::confirmOpening() {
  if (controller_->session().runMode() != RunMode::Live) return true;
  const auto windows = QApplication::topLevelWidgets();
  const bool isBesideParticipant = std::any_of(windows.begin(), windows.end(), [this](auto* each) {
    return qobject_cast<ParticipantWindow*>(each) != nullptr && each->isVisible() &&
           each->screen() == screen();
  });
  if (!isBesideParticipant) return true;
  return ask(this, MessageTopic::BoneBesideParticipant);
}

void BoneColoursButton::openWindow() {
  if (!isAllowed_ || present().participantView == nullptr || !confirmOpening()) return;
  if (present().participantView == nullptr) return;  // the trial may have ended meanwhile
  if (window_.isNull()) {
    const auto spec = sceneFor(controller_->session());
    window_ = new scene::BoneColoursWindow(
        *haptics::engine::partsOf(spec.model).packing, [this] { return present(); }, window());
  }
  window_->show();
  window_->raise();
}

}  // namespace study::gui
