// Sends the device a scene that it renders itself: PunchDevice::renderOnDevice().
#include <vector>

#include "haptics/devices/device.h"
#include "haptics/devices/punch/punch_device.h"
#include "haptics/timing/monotonic_clock.h"

namespace haptics::devices {
namespace {

using namespace haptics::wire::punch;

float f32(double value) {
  return static_cast<float>(value);
}

/// Why the board cannot render the model; none if it can.
DeviceFault unsupportedFeature(const engine::InterpolationSpec& spec) {
  if (spec.branches != engine::Branches::ClosingOnly) return "device.scene.opening";
  if (spec.curve.size() > kLargestTable) return "device.scene.long_curve";
  return {};
}

DeviceFault unsupportedFeature(const engine::FiniteElementsSpec& spec) {
  if (!spec.elementStiffnesses.empty()) return "device.scene.uneven";
  if (spec.parameters.elements > 255) return "device.scene.many_elements";
  return {};
}

void fillIn(Model& model, const engine::FiniteElementsSpec& spec) {
  const auto& p = spec.parameters;
  model.elements = static_cast<std::uint8_t>(p.elements);
  model.equationVariants = static_cast<std::uint8_t>(
      static_cast<unsigned>(p.boundary) | static_cast<unsigned>(p.weights) << 1U |
      static_cast<unsigned>(p.yielding) << 3U);
  model.start = f32(p.start);
  model.end = f32(p.end);
  model.elementStiffness = f32(p.elementStiffness);
  model.toolPosition = f32(p.toolPosition);
  model.contact = f32(p.contact);
  model.yieldForce = f32(p.yieldForce);
}

void fillIn(Model& model, const engine::InterpolationSpec& spec) {
  model.tableSize = static_cast<std::uint8_t>(spec.curve.size());
  model.extrapolation = static_cast<std::uint8_t>(spec.options.extrapolation);
  model.rampLength = f32(spec.options.rampLength);
}

void fillIn(Model& model, const engine::KalmanSpec& spec) {
  fillIn(model, spec.interpolation);
  fillIn(model, spec.finiteElements);
  model.scheme = static_cast<std::uint8_t>(spec.scheme);
  const auto& n = spec.noise;
  const double noise[] = {
      n.processForce,
      n.processCovariance,
      n.processStiffness,
      n.finiteElements,
      n.interpolation,
      n.wandering};
  for (int i = 0; i < 6; ++i) model.noise[i] = f32(noise[i]);
}

/// Visitor of ModelSpec: builds the messages that describe a scene, the model and the points of its
/// curve.
struct ChipMessages {
  Model model;
  std::vector<ModelTable> tables;
  DeviceFault unsupported;

  void operator()(const engine::InterpolationSpec& spec) {
    unsupported = unsupportedFeature(spec);
    if (unsupported) return;
    model.kind = ModelKind::Interpolation;
    fillIn(model, spec);
    addTables(spec);
  }
  void operator()(const engine::FiniteElementsSpec& spec) {
    unsupported = unsupportedFeature(spec);
    model.kind = ModelKind::FiniteElements;
    fillIn(model, spec);
  }
  void operator()(const engine::KalmanSpec& spec) {
    unsupported = unsupportedFeature(spec.interpolation);
    if (!unsupported) unsupported = unsupportedFeature(spec.finiteElements);
    if (spec.isProcessAsPrinted) unsupported = "device.scene.as_printed";
    if (spec.smoothing != models::Smoothing::None) unsupported = "device.scene.smoothing";
    if (unsupported) return;
    model.kind = ModelKind::Kalman;
    fillIn(model, spec);
    addTables(spec.interpolation);
  }
  void operator()(const engine::MaterialSpec&) { unsupported = "device.scene.bone"; }
  void operator()(const engine::PackingSpec&) { unsupported = "device.scene.bone"; }

  void addTables(const engine::InterpolationSpec& spec) {
    for (std::size_t first = 0; first < spec.curve.size(); first += kTableChunk) {
      ModelTable table{.first = static_cast<std::uint8_t>(first)};
      for (std::size_t i = first; i < spec.curve.size() && table.count < kTableChunk; ++i) {
        table.travel[table.count] = f32(spec.curve[i].travel);
        table.force[table.count] = f32(spec.curve[i].force);
        ++table.count;
      }
      tables.push_back(table);
    }
  }
};

template <typename Message>
std::uint32_t hashOf(const Message& message, std::uint32_t before) {
  std::uint8_t payload[kLargestPayload];
  Writer writer(payload);
  write(writer, message);
  return wire::crc32(payload, writer.size(), before);
}

}  // namespace

ModelReply PunchDevice::awaitModelReply(std::int64_t deadline) {
  while (!lastModelReply_ && port_.isOpen() && timing::now() < deadline) {
    isNew_ = false;
    waitForMessage(deadline);
  }
  if (!lastModelReply_) throw DeviceError(deviceMessage("device.scene_unanswered", place()));
  return *lastModelReply_;
}

void PunchDevice::renderOnDevice(const engine::SceneSpec& scene, double largestForce) {
  ChipMessages messages;
  std::visit(messages, scene.model);
  if (messages.unsupported) throw DeviceError(messages.unsupported.of(place()));
  auto& model = messages.model;
  model.travelPerCount = f32(settings_.travelPerCount);
  model.travelAtZero = f32(settings_.travelAtZero);
  model.millivoltsPerNewton = f32(1000.0 / settings_.newtonsPerVolt);
  model.largestForce = f32(largestForce);

  if (lifecycle() != Lifecycle::Open && lifecycle() != Lifecycle::Checked) {
    throw DeviceError(deviceMessage("device.scene_too_early", place()));
  }
  stopKeepAlive();
  sceneHash_.reset();
  const auto ask = [&](const auto& message) {
    lastModelReply_.reset();
    send(message);
    return awaitModelReply(timing::now() + 500 * timing::kMillisecond);
  };
  std::uint32_t hash = hashOf(model, 0);
  ModelReply answer;
  try {
    answer = ask(model);
    for (const auto& table : messages.tables) {
      hash = hashOf(table, hash);
      answer = ask(table);
    }
  } catch (...) {
    startKeepAlive();
    throw;
  }
  startKeepAlive();
  if (answer.verdict != ModelVerdict::Accepted || answer.hash != hash) {
    throw DeviceError(
        answer.verdict == ModelVerdict::InvalidModel
            ? deviceMessage("device.scene_unsound", place())
            : deviceMessage("device.scene_differs", place()));
  }
  sceneHash_ = hash;
}

}  // namespace haptics::devices
