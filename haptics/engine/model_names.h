#pragma once

#include <array>
#include <string_view>
#include <type_traits>
#include <variant>

#include "haptics/engine/scene_spec.h"

namespace haptics::engine {

template <typename... Spec>
constexpr auto namesOf(std::type_identity<std::variant<Spec...>>) {
  return std::array{Spec::kInfo.name...};
}
/// The names of all models, in the order of ModelSpec.
inline constexpr auto kModelNames = namesOf(std::type_identity<ModelSpec>{});

/// An enumerator of a model's option, with its name in protocols.
template <typename Value>
struct Named {
  std::string_view name;
  Value value;
};

inline constexpr std::array kExtrapolationNames{
    Named<models::Extrapolation>{"ramp-out", models::Extrapolation::RampOut},
    Named<models::Extrapolation>{"hold", models::Extrapolation::Hold},
    Named<models::Extrapolation>{"zero", models::Extrapolation::Zero},
    Named<models::Extrapolation>{"authors-clamp", models::Extrapolation::AuthorsClamp},
    Named<models::Extrapolation>{"absent", models::Extrapolation::Absent},
};
inline constexpr std::array kBranchesNames{
    Named<Branches>{"closing-only", Branches::ClosingOnly},
    Named<Branches>{"hysteresis", Branches::Hysteresis},
};
inline constexpr std::array kBoundaryNames{
    Named<models::BoundaryCondition>{"A", models::BoundaryCondition::A},
    Named<models::BoundaryCondition>{"B", models::BoundaryCondition::B},
};
inline constexpr std::array kWeightsNames{
    Named<models::ToolInterpolation>{"paper", models::ToolInterpolation::Paper},
    Named<models::ToolInterpolation>{
        "authors-firmware", models::ToolInterpolation::AuthorsFirmware},
    Named<models::ToolInterpolation>{"exact-kink", models::ToolInterpolation::ExactKink},
};
inline constexpr std::array kYieldLawNames{
    Named<models::YieldLaw>{"clip", models::YieldLaw::Clip},
    Named<models::YieldLaw>{"return-map", models::YieldLaw::ReturnMap},
};
inline constexpr std::array kSchemeNames{
    Named<models::KalmanScheme>{"paper-text", models::KalmanScheme::PaperText},
    Named<models::KalmanScheme>{"authors-firmware", models::KalmanScheme::AuthorsFirmware},
    Named<models::KalmanScheme>{"sequential", models::KalmanScheme::Sequential},
    Named<models::KalmanScheme>{"space-domain", models::KalmanScheme::SpaceDomain},
};
inline constexpr std::array kProcessNames{
    Named<models::ProcessNoiseReading>{"as-printed", models::ProcessNoiseReading::AsPrinted},
    Named<models::ProcessNoiseReading>{"symmetrised", models::ProcessNoiseReading::Symmetrised},
    Named<models::ProcessNoiseReading>{"state-order", models::ProcessNoiseReading::StateOrder},
    Named<models::ProcessNoiseReading>{"product", models::ProcessNoiseReading::Product},
};
inline constexpr std::array kSmoothingNames{
    Named<models::Smoothing>{"none", models::Smoothing::None},
    Named<models::Smoothing>{"two-point", models::Smoothing::TwoPoint},
    Named<models::Smoothing>{"authors-firmware", models::Smoothing::AuthorsFirmware},
};

inline constexpr std::array kTissueDrawingNames{
    Named<TissueDrawing>{"penetration", TissueDrawing::Penetration},
    Named<TissueDrawing>{"force", TissueDrawing::Force},
};

/// @param value  one of @p names.
template <typename Value, std::size_t kCount>
constexpr std::string_view nameIn(const std::array<Named<Value>, kCount>& names, Value value) {
  for (const auto& named : names) {
    if (named.value == value) return named.name;
  }
  return {};
}

/// @param name  one of @p names; for another name the first value is returned.
template <typename Value, std::size_t kCount>
constexpr Value valueIn(const std::array<Named<Value>, kCount>& names, std::string_view name) {
  for (const auto& named : names) {
    if (named.name == name) return named.value;
  }
  return names[0].value;
}

}  // namespace haptics::engine
