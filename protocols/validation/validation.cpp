#include "protocols/validation/validation.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "base/search.h"
#include "protocols/model/protocol.h"
#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_file.h"

namespace protocols {
namespace {

using haptics::devices::DeviceKind;
using haptics::devices::Tissue;
using haptics::devices::View;
using questionnaires::Instrument;
using questionnaires::ItemType;
using questionnaires::OptionSource;
using questionnaires::Problems;
using questionnaires::shown;

std::string pathTo(const char* list, std::size_t index) {
  return "$." + std::string(list) + "[" + std::to_string(index) + "]";
}

template <typename T>
void checkUnique(
    const std::vector<T>& things, const char* list, const char* what, Problems& problems) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (!things[i].id.empty() && !seen.insert(things[i].id).second) {
      problems.add(
          pathTo(list, i) + ".id",
          std::string("two ") + what + " share the id '" + shown(things[i].id) + "'",
          "give each its own");
    }
  }
}

void checkScene(
    const haptics::engine::SceneSpec& scene,
    const DeviceKind& device,
    const std::string& path,
    Problems& problems) {
  const auto& [name, tissue, travelUnit] = haptics::engine::infoOf(scene.model);
  if (tissue != device.tissue) {
    problems.add(
        path + ".model",
        (tissue == Tissue::Bone ? "a reaming material is felt on a reamer, not on a "
                                : "this model is felt on a punch, not on a ") +
            std::string(device.name),
        "choose another model, or another device");
  } else if (!travelUnit.empty() && travelUnit != device.travel.unit) {
    problems.add(
        path + ".model",
        "the travel of " + std::string(name) + " is in '" + std::string(travelUnit) +
            "', and that of a " + std::string(device.name) + " in '" +
            std::string(device.travel.unit) + "'",
        "choose another model, or another device");
  }
  for (const auto& wrong : haptics::engine::problemsOf(scene)) {
    problems.add(path + ".parameters", wrong, "see \"Scenes\" in docs/protocol-format.md");
  }
}

/// Whether the tissue of @p condition is shown, because of its scene or of a block.
bool isVisualised(const UnvalidatedProtocol& draft, const Condition& condition) {
  const auto& phases = draft.loaded.protocol.phases;
  return condition.isVisualised || std::ranges::any_of(phases, [&](const auto& phase) {
           return phase.trials.isVisualised.value_or(false) &&
                  base::contains(phase.trials.conditions, condition.id);
         });
}

void checkCondition(const UnvalidatedProtocol& draft, std::size_t index, Problems& problems) {
  const auto& condition = draft.loaded.protocol.conditions[index];
  const std::string path = pathTo("conditions", index) + ".scene";
  if (draft.lacksDevice(condition.device)) {
    problems.add(
        path + ".device",
        "there is no device '" + shown(condition.device) + "' in this protocol",
        "add it to 'devices', or correct the name");
  }
  const auto* device = draft.loaded.protocol.device(condition.device);
  if (condition.anatomy && device != nullptr && device->kind->view != View::Knee) {
    problems.add(
        path + ".anatomy",
        "a knee is seen with a punch, not with a " + std::string(device->kind->name),
        device->kind->view == View::Hip ? "remove it; the bone that a reamer shows is its packing"
                                        : "remove it");
  }
  if (device != nullptr && device->kind->view == View::None && isVisualised(draft, condition)) {
    problems.add(
        path + ".visualisation",
        "nothing can be seen with a " + std::string(device->kind->name),
        "set it to false, here and in the blocks that show this condition");
  }
  if (condition.model && device != nullptr) {
    checkScene(condition.scene(), *device->kind, path, problems);
  }
}

bool hasConsentItem(const Instrument& instrument) {
  return std::ranges::any_of(
      instrument.items, [](const auto& item) { return !item.consentOption.empty(); });
}

bool asksForAlternatives(const Instrument& instrument) {
  return std::ranges::any_of(instrument.items, [](const auto& item) {
    return item.optionSource == OptionSource::Alternatives;
  });
}

bool asksForOneAlternative(const Instrument& instrument) {
  return std::ranges::any_of(instrument.items, [](const auto& item) {
    return item.type == ItemType::SingleChoice && item.optionSource == OptionSource::Alternatives;
  });
}

void checkInstrumentFitsPhase(
    const Instrument& instrument, PhaseType phase, const std::string& path, Problems& problems) {
  if (phase == PhaseType::Consent && !hasConsentItem(instrument)) {
    problems.add(
        path,
        "'" + instrument.id + "' asks for no consent",
        "it needs an item with 'consent_option'");
  }
  if (phase == PhaseType::Preference && !asksForOneAlternative(instrument)) {
    problems.add(
        path,
        "'" + instrument.id + "' does not ask for an alternative",
        "it needs a single_choice item with \"options_from\": \"alternatives\"");
  }
  if (phase != PhaseType::Preference && asksForAlternatives(instrument)) {
    problems.add(
        path,
        "'" + instrument.id + "' asks for an alternative, and there are none to choose from here",
        "ask it in a phase of type 'preference'");
  }
}

/// The names of the library's instruments: "background, consent-punch, …".
std::string namesOfTheLibrary() {
  constexpr std::string_view kEnding = ".json";
  std::string names;
  for (const auto& file : questionnaires::libraryFiles()) {
    if (file.name.ends_with(".schema.json")) continue;
    names += names.empty() ? "" : ", ";
    names += file.name.substr(0, file.name.size() - kEnding.size());
  }
  return names;
}

/// The fix if @p id is unknown: the id that the file of that name has, or the names of the library.
std::string adviceOnInstrument(const LoadedProtocol& loaded, const std::string& id) {
  const auto& files = loaded.protocol.instrumentFiles;
  for (std::size_t i = 0; i < files.size() && i < loaded.instruments.size(); ++i) {
    if (std::filesystem::path(files[i]).stem() != id) continue;
    return "the file '" + shown(files[i]) + "' holds the instrument '" + loaded.instruments[i].id +
           "': write that id here, or change it in the file";
  }
  return "name one of the library (" + namesOfTheLibrary() +
         "), or list its file in 'instrument_files'";
}

void checkInstrument(
    const UnvalidatedProtocol& draft, const InstrumentUse& use, Problems& problems) {
  if (draft.lacksInstrument(use.instrument)) {
    problems.add(
        use.path,
        "there is no instrument '" + shown(use.instrument) + "'",
        adviceOnInstrument(draft.loaded, use.instrument));
  }
  const auto* instrument = draft.loaded.instrument(use.instrument);
  if (instrument != nullptr) checkInstrumentFitsPhase(*instrument, use.phase, use.path, problems);
}

void checkConsentComesFirst(const Protocol& protocol, Problems& problems) {
  for (std::size_t i = 0; i < protocol.phases.size(); ++i) {
    const auto& phase = protocol.phases[i];
    if (phase.type == PhaseType::Consent || phase.id.empty()) return;
    if (phase.type == PhaseType::Block || phase.type == PhaseType::Benchmark) {
      problems.add(
          pathTo("phases", i),
          "something is felt here before anybody has agreed to take part",
          "put a phase of type 'consent' before it");
      return;
    }
  }
}

}  // namespace

void validate(const UnvalidatedProtocol& draft, Problems& problems) {
  const auto& protocol = draft.loaded.protocol;
  checkUnique(protocol.cohorts, "cohorts", "cohorts", problems);
  checkUnique(protocol.devices, "devices", "devices", problems);
  checkUnique(protocol.conditions, "conditions", "conditions", problems);
  checkUnique(protocol.phases, "phases", "phases", problems);
  checkUnique(protocol.analysis.families, "analysis.families", "families", problems);
  for (std::size_t i = 0; i < protocol.conditions.size(); ++i) checkCondition(draft, i, problems);
  checkConsentComesFirst(protocol, problems);
  for (const auto& use : instrumentUses(protocol)) checkInstrument(draft, use, problems);
  validateBlocks(draft, problems);
  validateAnalysis(draft, problems);
}

namespace {

using questionnaires::shown;

/// The largest force that hands and fingers bear without pain when clamped [N]: table A.2 of ISO/TS
/// 15066:2016, "Robots and robotic devices – Collaborative robots", quasi-static contact.
constexpr double kPainlessForce = 140.0;

constexpr double kTick = 0.001;  // period of the force loop [s]

/// Refuses a rate limit so high that a value could rise from zero to its largest within one tick,
/// which the hand would feel as a blow.
/// @param what  name of the value: "force" or "torque"
/// @param rate  limit of its rate [@p unit]
/// @param largest  limit of the value itself
void validateRate(
    const std::string& path,
    const std::string& what,
    double rate,
    const std::string& unit,
    double largest,
    const std::string& usualAdvice,
    questionnaires::Problems& problems) {
  const double steepest = largest / kTick;
  if (rate <= steepest) return;
  problems.add(
      path,
      "a device is sent a " + what + " every 1 ms, and at " + shown(rate) + " " + unit +
          " the largest one comes at once, as a blow",
      "write at most " + shown(steepest) + "; " + usualAdvice);
}

void validateTorque(
    const DeviceRequirement& device, const std::string& path, questionnaires::Problems& problems) {
  const double most = device.kind->simulatedMaxTorque;
  if (most == 0.0) return;  // the limits have no effect
  if (device.maxTorque > most) {
    problems.add(
        path + "max_torque_nm",
        "a " + std::string(device.kind->name) + " gives " + shown(most) +
            " N·m (docs/devices.md), and this is " + shown(device.maxTorque) +
            " N·m: what is asked for beyond is not felt",
        "write " + shown(most) + " or less");
  }
  validateRate(
      path + "max_torque_rate_nm_per_s",
      "torque",
      device.maxTorqueRate,
      "N·m/s",
      device.maxTorque,
      "50 is usual for 5 N·m",
      problems);
}

/// Reports limits of @p device that cannot be kept or have no effect. Values that could not be read
/// were reported already.
void validateLimits(
    const DeviceRequirement& device, const std::string& place, questionnaires::Problems& problems) {
  const auto isRead = [&](const char* key) {
    return std::ranges::none_of(problems.all(), [&](const auto& problem) {
      return problem.path == place || problem.path == place + "." + key;
    });
  };
  if (!isRead("kind") || !isRead("max_force_n")) return;
  const std::string path = place + ".";
  const double most = device.kind->simulatedMaxForce;
  if (device.maxForce > most) {
    problems.add(
        path + "max_force_n",
        "a " + std::string(device.kind->name) + " gives " + shown(most) +
            " N (docs/devices.md, 'Saturation'), and this is " + shown(device.maxForce) +
            " N: what is asked for beyond is not felt",
        "write " + shown(most) +
            " or less; scenes of bone can be scaled ('force_scale'), recorded cuts cannot");
  }
  if (device.maxForce > kPainlessForce) {
    problems.add(
        path + "max_force_n",
        "a hand stands " + shown(kPainlessForce) +
            " N without pain (ISO/TS 15066:2016, table A.2, hands and fingers), and this is " +
            shown(device.maxForce) + " N",
        "write " + shown(kPainlessForce) + " or less, and scale the scenes by 'force_scale'");
  }
  if (isRead("max_force_rate_n_per_s")) {
    validateRate(
        path + "max_force_rate_n_per_s",
        "force",
        device.maxForceRate,
        "N/s",
        device.maxForce,
        "shipped protocols have 500 for 8 N",
        problems);
  }
  if (isRead("max_torque_nm") && isRead("max_torque_rate_nm_per_s")) {
    validateTorque(device, path, problems);
  }
}

std::string titleOf(const Cohort& cohort) {
  return cohort.title.in("en");
}

std::string titleOf(const Condition& condition) {
  return condition.title;
}

/// Reports a title that two things share, because reports name them by it.
template <typename T>
void checkTitles(
    const std::vector<T>& things, const char* list, questionnaires::Problems& problems) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < things.size(); ++i) {
    const auto title = titleOf(things[i]);
    if (title.empty() || seen.insert(title).second) continue;
    problems.add(
        pathTo(list, i) + ".title",
        "two " + std::string(list) + " have the title '" + shown(title) +
            "', and reports name them by it",
        "give each its own");
  }
}

/// Reports equivalence margins as wide as the scale, within which every difference lies.
void validateMargins(const UnvalidatedProtocol& draft, questionnaires::Problems& problems) {
  const auto& families = draft.loaded.protocol.analysis.families;
  for (std::size_t i = 0; i < families.size(); ++i) {
    const auto& family = families[i];
    const auto* instrument = draft.loaded.instrument(family.instrument);
    if (!family.equivalenceBound || instrument == nullptr) continue;
    const auto scale = scaleOf(family, *instrument);
    if (!scale || *family.equivalenceBound < scale->highest - scale->lowest) continue;
    problems.add(
        pathTo("analysis.families", i) + ".equivalence_bound",
        "no difference can be larger: the scale goes from " + shown(scale->lowest) + " to " +
            shown(scale->highest),
        "write the largest difference that is still negligible, in points of the scale");
  }
}

}  // namespace

void validateNewFile(const UnvalidatedProtocol& draft, questionnaires::Problems& problems) {
  const auto& protocol = draft.loaded.protocol;
  for (std::size_t i = 0; i < protocol.devices.size(); ++i) {
    validateLimits(protocol.devices[i], pathTo("devices", i), problems);
  }
  checkTitles(protocol.cohorts, "cohorts", problems);
  checkTitles(protocol.conditions, "conditions", problems);
  validateMargins(draft, problems);
}

}  // namespace protocols
