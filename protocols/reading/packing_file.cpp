#include "protocols/reading/packing_file.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>

#include <nlohmann/json.hpp>

#include "questionnaires/json/document.h"

namespace protocols {
namespace {

namespace reaming = haptics::reaming;
using questionnaires::Node;
using questionnaires::Problems;

constexpr std::string_view kPackingFormat = "palpate-packing-1";
constexpr std::size_t kDigits = 8;  // hexadecimal digits of a number in single precision
constexpr double kMostSpheres = 50e6;

struct PackingHeader {
  reaming::PackedBone bone;
  std::size_t spheres = 0;
  bool isFitted = false;
};

std::optional<PackingHeader> readHeader(
    std::string_view line, Problems& problems, PackingOrigin* origin) {
  const auto value = questionnaires::parseJson(line, problems);
  if (!value) return std::nullopt;
  const Node root(*value, "$", problems);
  if (!root.isObjectWithOnlyKeys(
          {"format",
           "name",
           "title",
           "synthetic",
           "spheres",
           "fitted",
           "volume_m3",
           "reamer_radius_m",
           "friction",
           "mesh",
           "mesh_sha256",
           "material",
           "seed"})) {
    return std::nullopt;
  }
  root.requireFormat("format", kPackingFormat, "write one with 'palpate packing build'");
  PackingHeader head;
  head.bone.name = root.id("name");
  head.bone.title = root.text("title");
  head.bone.isSynthetic = root.flag("synthetic", false);
  head.bone.packing.volume = root.number("volume_m3", 1e-12, 1.0);
  head.bone.reamerRadius = root.number("reamer_radius_m", 0.001, 0.1, head.bone.reamerRadius);
  if (root.has("friction")) head.bone.friction = root.number("friction", 0.0, 100.0);
  head.spheres = static_cast<std::size_t>(
      root.wholeNumber("spheres", 1, static_cast<std::int64_t>(kMostSpheres)));
  head.isFitted = root.flag("fitted", false);
  if (origin != nullptr) {
    if (root.has("mesh")) origin->mesh = root.text("mesh");
    if (root.has("mesh_sha256")) origin->sha256 = root.text("mesh_sha256");
    if (root.has("material")) origin->material = root.text("material");
    origin->seed = static_cast<std::uint64_t>(root.wholeNumber("seed", 0, INT64_MAX, 1));
  }
  return head;
}

/// The number at index @p index of @p line; NaN if its digits are invalid.
float numberAt(std::string_view line, std::size_t index) {
  const char* begin = line.data() + kDigits * index;
  std::uint32_t bits = 0;
  const auto [end, error] = std::from_chars(begin, begin + kDigits, bits, 16);
  const bool isWhole = error == std::errc() && end == begin + kDigits;
  return isWhole ? std::bit_cast<float>(bits) : std::nanf("");
}

bool readSphere(std::string_view line, bool isFitted, reaming::PackedBone& bone) {
  const std::size_t numbers = isFitted ? 7 : 4;
  if (line.size() != kDigits * numbers) return false;
  std::array<float, 7> all{};
  for (std::size_t i = 0; i < numbers; ++i) {
    all[i] = numberAt(line, i);
    if (!std::isfinite(all[i])) return false;
  }
  if (!(all[3] > 0.0F) || all[4] < 0.0F || all[5] < 0.0F || all[6] < 0.0F) return false;
  bone.packing.spheres.push_back({all[0], all[1], all[2], all[3]});
  if (!isFitted) return true;
  bone.minimum.push_back(all[4]);
  bone.average.push_back(all[5]);
  bone.maximum.push_back(all[6]);
  return true;
}

void appendNumber(float number, std::string& text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  const auto bits = std::bit_cast<std::uint32_t>(number);
  for (int shift = 28; shift >= 0; shift -= 4) text += kHex[(bits >> shift) & 15U];
}

}  // namespace

std::optional<reaming::PackedBone> readPacking(
    std::string_view text, Problems& problems, PackingOrigin* origin) {
  Problems found;
  const auto end = text.find('\n');
  auto head = readHeader(text.substr(0, end), found, origin);
  if (head && !found.hasErrors()) {
    auto rest = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    while (!rest.empty()) {
      const auto stop = std::min(rest.find('\n'), rest.size());
      if (!readSphere(rest.substr(0, stop), head->isFitted, head->bone)) {
        found.add(
            "$",
            "line " + std::to_string(head->bone.packing.spheres.size() + 2) +
                " holds no sphere: the file is damaged",
            "copy it again, or build it again");
        break;
      }
      rest.remove_prefix(std::min(stop + 1, rest.size()));
    }
    if (!found.hasErrors() && head->bone.packing.spheres.size() != head->spheres) {
      found.add(
          "$.spheres",
          "there are " + std::to_string(head->bone.packing.spheres.size()) + " spheres, not " +
              std::to_string(head->spheres) + ": the file is cut short",
          "copy it again, or build it again");
    }
  }
  problems.append(found);
  if (!head || found.hasErrors()) return std::nullopt;
  return std::move(head->bone);
}

std::string packingAsText(const reaming::PackedBone& bone, const PackingOrigin& origin) {
  const auto& spheres = bone.packing.spheres;
  const bool isFitted = bone.minimum.size() == spheres.size();
  nlohmann::ordered_json head{
      {"format", kPackingFormat},
      {"name", bone.name},
      {"title", bone.title},
      {"synthetic", bone.isSynthetic},
      {"spheres", spheres.size()},
      {"fitted", isFitted},
      {"volume_m3", bone.packing.volume},
      {"reamer_radius_m", bone.reamerRadius},
      {"mesh", origin.mesh}};
  if (bone.friction) head["friction"] = *bone.friction;
  if (!origin.sha256.empty()) head["mesh_sha256"] = origin.sha256;
  if (!origin.material.empty()) head["material"] = origin.material;
  head["seed"] = origin.seed;
  std::string text =
      head.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  text.reserve(text.size() + spheres.size() * (kDigits * 7 + 1));
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    for (const float number : {spheres[i].x, spheres[i].y, spheres[i].z, spheres[i].radius}) {
      appendNumber(number, text);
    }
    if (isFitted) {
      for (const float density : {bone.minimum[i], bone.average[i], bone.maximum[i]}) {
        appendNumber(density, text);
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace protocols
