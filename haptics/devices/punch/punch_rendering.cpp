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

/// Names the feature of the model that the board cannot render; nullptr if it can render the model.
const char* unsupportedFeature(const engine::InterpolationSpec& spec) {
  if (spec.branches != engine::Branches::ClosingOnly) return "an opening branch";
  if (spec.curve.size() > kLargestTable) return "a curve of more than 128 points";
  return nullptr;
}

const char* unsupportedFeature(const engine::FiniteElementsSpec& spec) {
  if (!spec.elementStiffnesses.empty()) return "elements of different stiffness";
  return spec.parameters.elements > 255 ? "more than 255 elements" : nullptr;
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
  const char* unsupported = nullptr;

  void operator()(const engine::InterpolationSpec& spec) {
    unsupported = unsupportedFeature(spec);
    if (unsupported != nullptr) return;
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
    if (unsupported == nullptr) unsupported = unsupportedFeature(spec.finiteElements);
    if (spec.isProcessAsPrinted) unsupported = "Q as it is printed";
    if (spec.smoothing != models::Smoothing::None) unsupported = "smoothing";
    if (unsupported != nullptr) return;
    model.kind = ModelKind::Kalman;
    fillIn(model, spec);
    addTables(spec.interpolation);
  }
  void operator()(const engine::MaterialSpec&) { unsupported = "bone"; }
  void operator()(const engine::PackingSpec&) { unsupported = "bone"; }

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
  if (!lastModelReply_)
    throw DeviceError(name() + " does not answer to the scene it was sent. Try again.");
  return *lastModelReply_;
}

void PunchDevice::renderOnDevice(const engine::SceneSpec& scene, double largestForce) {
  ChipMessages messages;
  std::visit(messages, scene.model);
  if (messages.unsupported != nullptr) {
    throw DeviceError(
        name() + " cannot render this scene by itself: it has " + messages.unsupported +
        ". Let the host render it (\"renders\": \"host\" in the device file).");
  }
  auto& model = messages.model;
  model.travelPerCount = f32(settings_.travelPerCount);
  model.travelAtZero = f32(settings_.travelAtZero);
  model.millivoltsPerNewton = f32(1000.0 / settings_.newtonsPerVolt);
  model.largestForce = f32(largestForce);

  if (lifecycle() != Lifecycle::Open && lifecycle() != Lifecycle::Checked) {
    throw DeviceError(name() + " is not ready to be sent a scene. Connect it, and try again.");
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
        name() + " did not take the scene as it was sent (" +
        (answer.verdict == ModelVerdict::InvalidModel ? "it finds it unsound"
                                                      : "its hash differs") +
        "). Try again, or let the host render it.");
  }
  sceneHash_ = hash;
}

}  // namespace haptics::devices
