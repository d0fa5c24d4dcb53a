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
struct NamedValue {
  std::string_view name;
  Value value;
};

inline constexpr std::array kExtrapolationNames{
    NamedValue<models::Extrapolation>{"ramp-out", models::Extrapolation::RampOut},
    NamedValue<models::Extrapolation>{"hold", models::Extrapolation::Hold},
    NamedValue<models::Extrapolation>{"zero", models::Extrapolation::Zero},
    NamedValue<models::Extrapolation>{"authors-clamp", models::Extrapolation::AuthorsClamp},
    NamedValue<models::Extrapolation>{"absent", models::Extrapolation::Absent},
};
inline constexpr std::array kBranchesNames{
    NamedValue<Branches>{"closing-only", Branches::ClosingOnly},
    NamedValue<Branches>{"hysteresis", Branches::Hysteresis},
};
inline constexpr std::array kBoundaryNames{
    NamedValue<models::BoundaryCondition>{"A", models::BoundaryCondition::A},
    NamedValue<models::BoundaryCondition>{"B", models::BoundaryCondition::B},
};
inline constexpr std::array kToolInterpolationNames{
    NamedValue<models::ToolInterpolation>{"paper", models::ToolInterpolation::Paper},
    NamedValue<models::ToolInterpolation>{
        "authors-firmware", models::ToolInterpolation::AuthorsFirmware},
    NamedValue<models::ToolInterpolation>{"exact-kink", models::ToolInterpolation::ExactKink},
};
inline constexpr std::array kYieldLawNames{
    NamedValue<models::YieldLaw>{"clip", models::YieldLaw::Clip},
    NamedValue<models::YieldLaw>{"return-map", models::YieldLaw::ReturnMap},
};
inline constexpr std::array kSchemeNames{
    NamedValue<models::KalmanScheme>{"paper-text", models::KalmanScheme::PaperText},
    NamedValue<models::KalmanScheme>{"authors-firmware", models::KalmanScheme::AuthorsFirmware},
    NamedValue<models::KalmanScheme>{"sequential", models::KalmanScheme::Sequential},
    NamedValue<models::KalmanScheme>{"space-domain", models::KalmanScheme::SpaceDomain},
};
inline constexpr std::array kProcessNames{
    NamedValue<models::ProcessNoiseReading>{"as-printed", models::ProcessNoiseReading::AsPrinted},
    NamedValue<models::ProcessNoiseReading>{
        "symmetrised", models::ProcessNoiseReading::Symmetrised},
    NamedValue<models::ProcessNoiseReading>{"state-order", models::ProcessNoiseReading::StateOrder},
    NamedValue<models::ProcessNoiseReading>{"product", models::ProcessNoiseReading::Product},
};
inline constexpr std::array kSmoothingNames{
    NamedValue<models::Smoothing>{"none", models::Smoothing::None},
    NamedValue<models::Smoothing>{"two-point", models::Smoothing::TwoPoint},
    NamedValue<models::Smoothing>{"authors-firmware", models::Smoothing::AuthorsFirmware},
};

inline constexpr std::array kTissueDrawingNames{
    NamedValue<TissueDrawing>{"penetration", TissueDrawing::Penetration},
    NamedValue<TissueDrawing>{"force", TissueDrawing::Force},
};

/// @param value  one of @p names.
template <typename Value, std::size_t kCount>
constexpr std::string_view nameIn(const std::array<NamedValue<Value>, kCount>& names, Value value) {
  for (const auto& named : names) {
    if (named.value == value) return named.name;
  }
  return {};
}

/// @param name  one of @p names; for another name the first value is returned.
template <typename Value, std::size_t kCount>
constexpr Value valueIn(const std::array<NamedValue<Value>, kCount>& names, std::string_view name) {
  for (const auto& named : names) {
    if (named.name == name) return named.value;
  }
  return names[0].value;
}

}  // namespace haptics::engine
