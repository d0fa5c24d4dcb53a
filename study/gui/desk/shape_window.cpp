#include "study/gui/desk/shape_window.h"

#include <memory>
#include <utility>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include "haptics/engine/built_in_models.h"
#include "protocols/reading/anatomy_file.h"
#include "protocols/reading/packing_file.h"
#include "questionnaires/json/document.h"
#include "study/gui/scene/bone_colours_window.h"
#include "study/gui/scene/knee_scene.h"
#include "study/gui/scene/simulation_view.h"
#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"

namespace study::gui {
namespace {

QWidget* boneWindow(std::shared_ptr<const haptics::reaming::PackedBone> bone, QWidget* parent) {
  const bool isFitted = !bone->average.empty();
  if (!isFitted) {
    auto uniform = std::make_shared<haptics::reaming::PackedBone>(*bone);
    const std::vector<float> ones(bone->packing.spheres.size(), 1.0F);
    uniform->minimum = uniform->average = uniform->maximum = ones;
    bone = uniform;
  }
  const haptics::engine::PackingSpec spec{.bone = std::move(bone)};
  auto* window = new scene::BoneColoursWindow(spec, {}, parent);
  window->removeColours(scene::SphereColours::Removal);
  if (!isFitted) window->removeColours(scene::SphereColours::Density);
  return window;
}

QWidget* kneeWindow(const protocols::Anatomy* knee, QWidget* parent) {
  auto* view = new scene::SimulationView(
      std::make_unique<scene::KneeScene>(knee), scene::makeRenderer(), parent);
  view->setWindowFlag(Qt::Window);
  view->setAttribute(Qt::WA_DeleteOnClose);
  view->setAttribute(Qt::WA_TransparentForMouseEvents, false);
  return view;
}

QWidget* windowOfFile(const std::string& path, QWidget* parent) {
  questionnaires::Problems problems;
  const bool isBone = path.ends_with(protocols::kPackingExtension);
  const auto largest = isBone ? protocols::kMaxPackingBytes : protocols::kMaxAnatomyBytes;
  const auto text = questionnaires::readTextFile(path, largest);
  if (isBone) {
    if (auto bone = protocols::readPacking(text, problems)) {
      return boneWindow(
          std::make_shared<const haptics::reaming::PackedBone>(std::move(*bone)), parent);
    }
  } else if (const auto knee = protocols::readAnatomy(text, problems)) {
    return kneeWindow(&*knee, parent);
  }
  throw base::UserError(questionnaires::describe(problems.all()));
}

QWidget* showTitled(QWidget* window, const QString& title) {
  window->setWindowTitle(title);
  window->show();
  return window;
}

}  // namespace

QWidget* openShapeWindow(const QString& path, QWidget* parent) {
  return showTitled(windowOfFile(path.toStdString(), parent), QFileInfo(path).fileName());
}

QWidget* openBuiltInBone(QWidget* parent) {
  return showTitled(
      boneWindow(haptics::engine::parametricBone(), parent), deskText("Built-in bone"));
}

QWidget* openBuiltInKnee(QWidget* parent) {
  return showTitled(kneeWindow(nullptr, parent), deskText("Built-in knee"));
}

void chooseAndOpenShape(QWidget* parent) {
  const QString path = QFileDialog::getOpenFileName(
      parent,
      QFileDialog::tr("Look at a bone or a knee"),
      QDir::homePath(),
      QFileDialog::tr("Bones of spheres, and knees (*.packing *.obj)"));
  if (!path.isEmpty())
    attempt(parent, MessageTopic::FileNotShown, [&] { openShapeWindow(path, parent); });
}

}  // namespace study::gui
