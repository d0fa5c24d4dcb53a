#include "haptics/engine/compiled_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "haptics/engine/bone_models.h"
#include "haptics/engine/model_names.h"
#include "haptics/engine/punch_models.h"
#include "haptics/engine/reamed_material.h"
#include "haptics/recordings/recording.h"

namespace haptics::engine {
namespace {

constexpr const char* kInterpolation = "interpolation of the recorded cut";
constexpr const char* kOpening = "opening branch of the recorded cut";
constexpr const char* kFiniteElements = "finite elements: force";
constexpr const char* kMesh = "finite elements: mesh";
constexpr const char* kFilter = "Kalman filter";
constexpr const char* kMaterial = "bone material";
constexpr const char* kPacking = "sphere packing";
constexpr const char* kRemoval = "removal of bone";
constexpr const char* kTorque = "torque about the tool's axis";
constexpr const char* kBoneView = "bone: what changes in it";

/// The interpretations of the paper that are used, by their names in protocols.
std::string describe(const models::FiniteElements<double>::Parameters& p) {
  std::string words = "boundary ";
  words.append(nameIn(kBoundaryNames, p.boundary));
  words.append(", weights ").append(nameIn(kToolInterpolationNames, p.weights));
  return words.append(", yielding ").append(nameIn(kYieldLawNames, p.yielding));
}

std::string describe(const KalmanSpec& spec) {
  std::string words = "variant ";
  words.append(nameIn(kSchemeNames, spec.scheme));
  if (spec.isProcessAsPrinted) words += ", process as-printed";
  words.append(", smoothing ").append(nameIn(kSmoothingNames, spec.smoothing));
  return words + ", the interpolation weighs " + recordings::decimal(interpolationWeight(spec), 2);
}

/// Describes how fast a reamer advances through bone; empty for a reamer without a limit.
std::string describeFeed(const Reamer& reamer) {
  constexpr double kMillimetresPerMetre = 1000.0;
  const double feed = kMillimetresPerMetre * reamer.mostFeed();
  if (std::isinf(feed)) return "";
  if (reamer.speed == 0.0) return "; the reamer stands still, and removes nothing";
  if (reamer.speed < 0.0) return "; the reamer turns backwards, and removes nothing";
  char text[160];
  std::snprintf(
      text,
      sizeof text,
      ", at most %.3g mm/s: %.3g turns a second, %d teeth, %.3g mm per tooth",
      feed,
      reamer.speed,
      reamer.teeth,
      kMillimetresPerMetre * reamer.feedPerTooth);
  return text;
}

/// Visitor of ModelSpec: builds the force model and lists its passes.
struct Builder {
  bool isVisualised = false;
  Reamer reamer;
  std::unique_ptr<ForceModel> model;
  BoneView* bone = nullptr;
  std::vector<Pass> passes;

  void use(const char* name, std::string why, std::size_t bytes) {
    passes.push_back({name, true, std::move(why), bytes});
  }
  void leaveOut(const char* name, std::string why) {
    passes.push_back({name, false, std::move(why), 0});
  }

  void interpolation(const InterpolationSpec& spec, const char* why, std::size_t bytes) {
    const bool isBothWays = spec.branches == Branches::Hysteresis;
    use(kInterpolation, why, bytes);
    if (isBothWays) {
      use(kOpening, "opening is felt as it was recorded", 0);
    } else {
      leaveOut(kOpening, "opening goes back along the closing branch");
    }
  }

  void leaveOutBone() {
    for (const auto* part : {kMaterial, kPacking, kRemoval}) leaveOut(part, "no bone is reamed");
  }
  void leaveOutPunch() {
    leaveOut(kInterpolation, "no cut is replayed");
    leaveOut(kFiniteElements, "no meniscus is pressed");
    leaveOut(kFilter, "there is one force, so nothing to fuse");
  }

  void operator()(const InterpolationSpec& spec) {
    auto recorded = std::make_unique<InterpolationModel>(spec);
    interpolation(spec, "this is the force", recorded->bytes());
    model = std::move(recorded);
    leaveOut(kFiniteElements, "the force comes from the recording alone");
    leaveOut(kFilter, "there is one force, so nothing to fuse");
    leaveOutBone();
  }

  void operator()(const FiniteElementsSpec& spec) {
    model = std::make_unique<FiniteElementModel>(spec);
    leaveOut(kInterpolation, "the force comes from the finite elements alone");
    use(kFiniteElements,
        "this is the force: " + describe(spec.parameters),
        sizeof(FiniteElementModel));
    leaveOut(kFilter, "there is one force, so nothing to fuse");
    leaveOutBone();
  }

  void operator()(const KalmanSpec& spec) {
    if (spec.isProcessAsPrinted) {
      model = std::make_unique<KalmanModelWithPrintedNoise>(spec, spec.noise.asPrinted());
    } else {
      model = std::make_unique<FactoredKalmanModel>(spec, spec.noise.factored());
    }
    const bool isAbsent = spec.interpolation.options.extrapolation == models::Extrapolation::Absent;
    interpolation(
        spec.interpolation,
        isAbsent ? "the filter corrects with it; beyond it there is no measurement (absent)"
                 : "the filter corrects with it",
        InterpolationModel(spec.interpolation).bytes());
    use(kFiniteElements,
        "the filter corrects with it: " + describe(spec.finiteElements.parameters),
        sizeof(FiniteElementModel));
    use(kFilter, "this is the force: " + describe(spec), sizeof(models::KalmanFilter<double>));
    leaveOutBone();
  }

  /// @param of  what the torque is computed from.
  /// @param noTorqueReason  the reason that is reported if the reamer turns but the model has no
  /// torque.
  void torque(const std::string& of, const char* noTorqueReason) {
    if (!reamer.hasTorque) {
      leaveOut(kTorque, "release 0.1, under which this study began, rendered forces alone");
    } else if (reamer.speed == 0.0) {
      leaveOut(kTorque, "the reamer stands still");
    } else if (model->hasTorque()) {
      use(kTorque, of, 0);
    } else {
      leaveOut(kTorque, noTorqueReason);
    }
  }

  void operator()(const MaterialSpec& spec) {
    leaveOutPunch();
    const std::string curves = spec.isMeasured ? "the measured curves" : "its curves";
    const std::string why = "this is the force; " + curves + " were blended beforehand";
    if (spec.isRemoved) {
      auto reamed = std::make_unique<ReamedMaterialModel>(spec, reamer);
      use(kMaterial, why, reamed->bytes());
      leaveOut(kPacking, "the force depends on depth and feed alone");
      use(kRemoval, "the reamer goes on as it removes bone" + describeFeed(reamer), 0);
      model = std::move(reamed);
    } else {
      auto material = std::make_unique<MaterialModel>(spec, reamer);
      use(kMaterial, why, material->bytes());
      leaveOut(kPacking, "the force depends on depth alone");
      leaveOut(kRemoval, "the bone stays as it is");
      model = std::move(material);
    }
    torque(
        (spec.isMeasured ? "the measured curve" : "its curve") +
            std::string(" of torque, against the spin"),
        "the material has no curve of torque");
  }

  void operator()(const PackingSpec& spec) {
    leaveOutPunch();
    leaveOut(kMaterial, "the spheres have been fitted to it; the curve itself is not needed");
    const std::string spheres =
        "this is the force: " + std::to_string(spec.bone->packing.spheres.size()) + " spheres";
    if (spec.isRemoved) {
      auto removal = std::make_unique<RemovalModel>(spec, isVisualised, reamer);
      bone = removal->view();
      use(kPacking, spheres, removal->bytes());
      use(kRemoval,
          "what the reamer goes through is taken away" + describeFeed(reamer),
          removal->bytes());
      model = std::move(removal);
    } else {
      auto packing = std::make_unique<PackingModel>(spec, reamer);
      use(kPacking, spheres, packing->bytes());
      leaveOut(kRemoval, "the bone stays as it is");
      model = std::move(packing);
    }
    torque(
        "friction " + recordings::decimal(spec.options.friction, 2) +
            " on the spheres, against the spin",
        "there is no friction");
  }
};

/// The finite elements that are drawn for a punch: the model's own, else elements that match its
/// recorded cut, else the default elements.
FiniteElementsSpec drawnTissue(const SceneSpec& spec) {
  const auto parts = partsOf(spec.model);
  if (parts.elements != nullptr) return *parts.elements;
  return parts.cut != nullptr ? elementsMatching(*parts.cut) : FiniteElementsSpec{};
}

}  // namespace

MeshView::MeshView(const FiniteElementsSpec& spec, TissueDrawing drawing)
    : drawing_(drawing), contact_(spec.parameters.contact) {
  const models::FiniteElements<double> elements(spec.asParameters());
  std::vector<double> displacements(static_cast<std::size_t>(elements.elements()));
  elements.writeMeshShape(displacements.data());
  shape_.push_back({elements.position(0), 0.0});
  const double scale = drawing == TissueDrawing::Penetration ? elements.stiffness() : 1.0;
  for (int node = 1; node <= elements.elements(); ++node) {
    const double displacement = scale * displacements[static_cast<std::size_t>(node) - 1];
    shape_.push_back({elements.position(node), std::isfinite(displacement) ? displacement : 0.0});
  }
  shape_.push_back({elements.position(elements.elements() + 1), 0.0});
}

std::vector<MeshView::Point> MeshView::at(double travel, double force) const {
  std::vector<Point> points = shape_;
  const double pressed =
      drawing_ == TissueDrawing::Penetration ? std::max(travel - contact_, 0.0) : force;
  for (auto& point : points) point.displacement *= pressed;
  return points;
}

CompiledScene::CompiledScene(const SceneSpec& spec) {
  std::string wrong;
  for (const auto& problem : problemsOf(spec)) wrong += (wrong.empty() ? "" : "; ") + problem;
  if (!wrong.empty()) throw std::invalid_argument(wrong);

  Builder builder{.isVisualised = spec.isVisualised, .reamer = spec.reamer};
  std::visit(builder, spec.model);
  const bool isMeniscus = infoOf(spec.model).tissue == devices::Tissue::Meniscus;
  if (spec.isVisualised && isMeniscus) {
    mesh_.emplace(drawnTissue(spec), spec.tissueDrawing);
    std::string why = "the tissue is shown and follows the ";
    why.append(nameIn(kTissueDrawingNames, spec.tissueDrawing));
    builder.use(kMesh, why + "; solved when a picture is drawn, not in the tick", 0);
  } else {
    builder.leaveOut(kMesh, isMeniscus ? "nothing is shown" : "no meniscus is shown");
  }
  bone_ = builder.bone;
  if (bone_ != nullptr) {
    builder.use(
        kBoneView, "the bone is shown; the tick names the spheres that change", sizeof(BoneView));
  } else {
    builder.leaveOut(kBoneView, spec.isVisualised ? "nothing in it changes" : "nothing is shown");
  }
  model_ = std::move(builder.model);
  passes_ = std::move(builder.passes);
}

}  // namespace haptics::engine
