#include "study/gui/desk/shape_window.h"

#include <memory>
#include <utility>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include "protocols/reading/anatomy_file.h"
#include "protocols/reading/packing_file.h"
#include "questionnaires/json/document.h"
#include "study/gui/scene/cup_window.h"
#include "study/gui/scene/knee_scene.h"
#include "study/gui/scene/simulation_view.h"
#include "study/gui/widgets/attempt.h"

namespace study::gui {
namespace {

QWidget* boneWindow(const std::string& path, QWidget* parent) {
  questionnaires::Problems problems;
  auto bone = protocols::readPacking(
      questionnaires::readTextFile(path, protocols::kLargestPacking), problems);
  if (!bone) throw base::UserError(questionnaires::describe(problems.all()));
  const bool isFitted = !bone->average.empty();
  if (!isFitted) {
    const std::vector<float> ones(bone->packing.spheres.size(), 1.0F);
    bone->minimum = bone->average = bone->maximum = ones;
  }
  const haptics::engine::PackingSpec spec{
      .bone = std::make_shared<const haptics::reaming::PackedBone>(std::move(*bone))};
  auto* window = new scene::CupWindow(spec, {}, parent);
  window->removeColours(scene::SphereColours::Removal);
  if (!isFitted) window->removeColours(scene::SphereColours::Density);
  return window;
}

QWidget* kneeWindow(const std::string& path, QWidget* parent) {
  questionnaires::Problems problems;
  const auto knee = protocols::readAnatomy(
      questionnaires::readTextFile(path, protocols::kLargestAnatomy), problems);
  if (!knee) throw base::UserError(questionnaires::describe(problems.all()));
  auto* view = new scene::SimulationView(
      std::make_unique<scene::KneeScene>(&*knee),
      scene::openGraphics(),
      scene::SimulationView::Pace::Display,
      parent);
  view->setWindowFlag(Qt::Window);
  view->setAttribute(Qt::WA_DeleteOnClose);
  view->setAttribute(Qt::WA_TransparentForMouseEvents, false);
  return view;
}

}  // namespace

QWidget* openShape(const QString& path, QWidget* parent) {
  const bool isBone = path.toStdString().ends_with(protocols::kPackingEnding);
  auto* window =
      isBone ? boneWindow(path.toStdString(), parent) : kneeWindow(path.toStdString(), parent);
  window->setWindowTitle(QFileInfo(path).fileName());
  window->show();
  return window;
}

void chooseAndOpenShape(QWidget* parent) {
  const QString path = QFileDialog::getOpenFileName(
      parent,
      QFileDialog::tr("Look at a bone or a knee"),
      QDir::homePath(),
      QFileDialog::tr("Bones of spheres, and knees (*.packing *.obj)"));
  if (!path.isEmpty()) attempt(parent, [&] { openShape(path, parent); });
}

}  // namespace study::gui
