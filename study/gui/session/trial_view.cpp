#include "study/gui/session/trial_view.h"

#include <algorithm>

#include <QPointer>
#include <QTimer>
#include <QVBoxLayout>

#include "study/gui/scene/hip_scene.h"
#include "study/gui/scene/knee_scene.h"
#include "study/gui/widgets/desk_language.h"
#include "study/session/trial_setup.h"

namespace study::gui {
namespace {

using haptics::devices::View;
using scene::SimulationView;

/// @param view  must not be None.
/// @param knee  surfaces that replace the built-in ones; nullptr: none.
std::unique_ptr<scene::SimulatedScene> simulatedSceneOf(
    View view, const haptics::engine::SceneSpec& spec, const protocols::Anatomy* knee) {
  switch (view) {
    case View::Knee:
      return std::make_unique<scene::KneeScene>(knee);
    case View::Hip:
      return std::make_unique<scene::HipScene>(
          scene::HipScene::Options{.packing = haptics::engine::partsOf(spec.model).packing});
    case View::None:
      break;
  }
  return nullptr;
}

scene::TrialSnapshot snapshotOf(const SessionController& controller) {
  const auto status = controller.trialStatus();
  return {
      .travel = status.travel,
      .force = status.force,
      .isCutThrough = status.isCutThrough,
      .isRunning = controller.isTrialRunning(),
      .sampleTime = status.sampleTime,
      .mesh = controller.mesh(),
      .bone = controller.bone()};
}

/// Creates the view of the simulation in @p place and connects it to the trial.
void begin(QWidget& place, const haptics::engine::SceneSpec& spec, SessionController& controller) {
  const auto& session = controller.session();
  const auto* condition = session.protocol().protocol.condition(session.step().condition);
  auto* view = new SimulationView(
      simulatedSceneOf(deviceFor(session).kind->view, spec, condition->knee.get()),
      scene::makeRenderer(),
      &place);
  place.layout()->addWidget(view);
  view->setSnapshotSource([&controller] { return snapshotOf(controller); });
  controller.setView(view);
}

}  // namespace

QWidget* viewOfTrial(SessionController& controller, QWidget* parent) {
  controller.setView({});
  const auto spec = sceneFor(controller.session());
  const bool isVisualised =
      spec.isVisualised && deviceFor(controller.session()).kind->view != View::None;
  if (!isVisualised) return nullptr;
  auto* place = new QWidget(parent);
  place->setAttribute(Qt::WA_TransparentForMouseEvents);  // the page around it handles the mouse
  place->setProperty("role", QStringLiteral("scene"));
  place->setObjectName(QStringLiteral("scene"));
  place->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  (new QVBoxLayout(place))->setContentsMargins(0, 0, 0, 0);
  // The page appears at once. The renderer is created while the participant reads it.
  constexpr int kRendererDelay = 20;  // [ms]
  QTimer::singleShot(
      kRendererDelay,
      place,
      [place, spec, shown = QPointer(&controller), visit = controller.session().visit()] {
        if (shown.isNull()) return;  // the page is deleted a little later than the session's window
        const auto& session = shown->session();
        if (!session.isOver() && session.visit() == visit) begin(*place, spec, *shown);
      });
  return place;
}

QString viewInWords(const SessionController& controller) {
  const auto report = controller.viewReport();
  if (!report || report->frames < 2) return {};
  return deskText(" · %1 pictures a second, %2 ms old")
      .arg(report->rate, 0, 'f', 1)
      .arg(report->latencyMedian, 0, 'f', 0);
}

bool isAnyTrialVisualised(const protocols::Protocol& protocol) {
  const auto isVisualised = [](const auto& condition) { return condition.isVisualised; };
  const auto& conditions = protocol.conditions;
  return std::any_of(conditions.begin(), conditions.end(), isVisualised) ||
         std::any_of(protocol.phases.begin(), protocol.phases.end(), [](const auto& phase) {
           return phase.trials.isVisualised.value_or(false);
         });
}

}  // namespace study::gui
