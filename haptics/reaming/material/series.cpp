#include "haptics/reaming/material/series.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "base/file.h"
#include "base/text_table.h"
#include "haptics/filters/averages.h"
#include "haptics/recordings/recording.h"

namespace haptics::reaming {
namespace {

using base::TextLine;

struct Unit {
  const char* name;
  double factor;  ///< converts to SI
};

/// A quantity with its names and units; the first unit is SI.
struct Quantity {
  const char* name;
  std::vector<const char*> heads;  ///< in lower case
  std::vector<Unit> units;
  bool isNeeded = true;
};

const std::array<Quantity, 4>& quantities() {
  static const std::array<Quantity, 4> kAll{
      {{"time", {"time", "t", "zeit"}, {{"s", 1.0}, {"ms", 1e-3}}},
       {"displacement",
        {"displacement", "depth", "travel", "weg", "s", "position"},
        {{"m", 1.0}, {"mm", 1e-3}, {"um", 1e-6}, {"µm", 1e-6}}},
       {"force", {"force", "f", "kraft"}, {{"n", 1.0}, {"kn", 1e3}}},
       {"torque",
        {"torque", "moment", "m", "drehmoment"},
        {{"nm", 1.0}, {"n·m", 1.0}, {"nmm", 1e-3}},
        false}}};
  return kAll;
}

constexpr std::string_view kSyntheticMark = "# SYNTHETIC";

/// The lines of a table that are neither empty nor comments (#).
struct Lines {
  std::vector<TextLine> all;
  bool isSynthetic = false;  ///< a comment says that the data are synthetic
};

Lines linesWithoutComments(std::string_view text) {
  Lines lines;
  for (const TextLine& line : base::linesOf(text)) {
    const bool isRemark = lines.all.empty() && line.text.starts_with('#');
    lines.isSynthetic |= isRemark && line.text.starts_with(kSyntheticMark);
    if (!isRemark) lines.all.push_back(line);
  }
  return lines;
}

/// The column of a quantity, and its conversion to SI.
struct Column {
  std::size_t place = 0;
  double factor = 1.0;
};

double factorOf(const Quantity& quantity, const std::string& unit, const std::string& name) {
  std::string known;
  for (const auto& candidate : quantity.units) {
    if (base::lowerCase(unit) == candidate.name) return candidate.factor;
    known += (known.empty() ? "" : ", ") + std::string(candidate.name);
  }
  throw base::UserError(
      unit.empty() ? name + ": the " + quantity.name +
                         " has no unit. Write one into its head, as "
                         "in '" +
                         quantity.name + " [" + quantity.units.back().name +
                         "]', or say it with --unit. There are: " + known + "."
                   : name + ": '" + unit + "' is no unit of " + quantity.name +
                         " that this program knows. There are: " + known + ".");
}

std::optional<Column> columnOf(
    const Quantity& quantity,
    const std::vector<std::string>& heads,
    const SeriesMapping& mapping,
    const std::string& name) {
  const auto given = mapping.heads.find(quantity.name);
  for (std::size_t place = 0; place < heads.size(); ++place) {
    const base::ColumnHeading head = base::columnHeadingOf(base::lowerCase(heads[place]));
    const bool isUsual = std::ranges::any_of(
        quantity.heads, [&head](const char* usual) { return head.name == usual; });
    const bool isIt = given != mapping.heads.end() ? heads[place] == given->second : isUsual;
    if (!isIt) continue;
    const auto unit = mapping.units.find(quantity.name);
    return Column{
        place, factorOf(quantity, unit != mapping.units.end() ? unit->second : head.unit, name)};
  }
  if (!quantity.isNeeded && given == mapping.heads.end()) return std::nullopt;
  throw base::UserError(
      name + " has no column for the " + quantity.name + ". Its columns are " +
      base::listed(heads) + "; say which one it is with --column " + quantity.name + "=HEAD.");
}

/// The sampling rate [Hz]. @throws UserError if a sample is missing.
double rateOf(
    const std::vector<double>& time, const std::vector<TextLine>& lines, const std::string& name) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  const double usual = filters::upperMedian(std::move(steps));
  if (!(usual > 0.0)) throw base::UserError(name + ": the time does not go on.");
  for (std::size_t i = 1; i < time.size(); ++i) {
    const double step = time[i] - time[i - 1];
    if (step > 0.5 * usual && step < 1.5 * usual) continue;
    throw base::UserError(
        name + ": between lines " + std::to_string(lines[i].number) + " and " +
        std::to_string(lines[i + 1].number) + " the time goes on by " + std::to_string(step) +
        " s, usually by " + std::to_string(usual) +
        " s. Cut the file there, or record the series again.");
  }
  return static_cast<double>(time.size() - 1) / (time.back() - time.front());
}

/// Refuses values that are impossible for an acetabulum, because a unit is probably wrong. @throws
/// UserError
void checkUnits(const Series& series) {
  constexpr double kLargestDisplacement = 0.2;  // [m]
  constexpr double kLargestForce = 20e3;        // [N]
  const auto refuse = [&](const std::string& what, const char* quantity, const char* units) {
    throw base::UserError(
        series.name + ": " + what + ". Its unit must be another one (" + units +
        "?): correct the head, or say it with --unit " + quantity + "=UNIT.");
  };
  const auto [least, most] =
      std::minmax_element(series.displacement.begin(), series.displacement.end());
  if (*most - *least > kLargestDisplacement) {
    refuse(
        "the displacement goes over " + recordings::decimal(*most - *least, 3) +
            " m, and no reamer goes farther than " + recordings::decimal(kLargestDisplacement, 1) +
            " m",
        "displacement",
        "mm, um");
  }
  double strongest = 0.0;
  for (const double force : series.force) strongest = std::max(strongest, std::abs(force));
  if (strongest > kLargestForce) {
    refuse(
        "the force goes to " + recordings::decimal(strongest / 1000.0, 1) +
            " kN, and no bone holds more than " + recordings::decimal(kLargestForce / 1000.0, 0) +
            " kN",
        "force",
        "N");
  }
}

}  // namespace

Series readSeries(std::string_view text, const std::string& name, const SeriesMapping& mapping) {
  const auto found = linesWithoutComments(base::withoutByteOrderMark(text));
  const auto& lines = found.all;
  constexpr std::size_t kFewestRows = 3;
  if (lines.size() < kFewestRows + 1) {
    throw base::UserError(
        name + " has " + std::to_string(lines.empty() ? 0 : lines.size() - 1) +
        " rows below its head; that is no measurement.");
  }
  const char separator = base::separatorOf(lines.front().text);
  const auto heads = base::cellsOf(lines.front().text, separator);
  std::array<std::optional<Column>, 4> columns;
  std::array<std::vector<double>, 4> values;
  for (std::size_t q = 0; q < columns.size(); ++q) {
    columns[q] = columnOf(quantities()[q], heads, mapping, name);
  }
  for (std::size_t row = 1; row < lines.size(); ++row) {
    const auto cells = base::cellsOf(lines[row].text, separator);
    for (std::size_t q = 0; q < columns.size(); ++q) {
      if (!columns[q]) continue;
      const auto place = columns[q]->place;
      const auto value =
          place < cells.size() ? base::numberIn(cells[place], separator) : std::nullopt;
      if (!value) {
        throw base::UserError(
            name + ", line " + std::to_string(lines[row].number) + ": the " + quantities()[q].name +
            " is '" + (place < cells.size() ? cells[place] : "") + "', which is no number.");
      }
      values[q].push_back(*value * columns[q]->factor);
    }
  }
  Series series{
      .name = name,
      .rate = rateOf(values[0], lines, name),
      .displacement = std::move(values[1]),
      .force = std::move(values[2]),
      .torque = std::move(values[3]),
      .isSynthetic = found.isSynthetic};
  checkUnits(series);
  return series;
}

std::string contentOfSeriesFile(const std::string& path) {
  auto text = base::readFile(path);
  if (!text)
    throw base::UserError("There is no series '" + path + "': check the name and the folder.");
  return std::move(*text);
}

Series readSeriesFile(const std::string& path, TestSet set, const SeriesMapping& mapping) {
  const std::string text = contentOfSeriesFile(path);
  auto series = readSeries(text, std::filesystem::path(path).filename().string(), mapping);
  series.set = set;
  return series;
}

std::string asText(const Series& series) {
  const auto exact = [](double value) {
    char digits[32];
    return std::string(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  };
  const bool hasTorque = !series.torque.empty();
  std::string text;
  if (series.isSynthetic) text += std::string(kSyntheticMark) + ": nobody measured this\n";
  text +=
      hasTorque ? "time_s,displacement_mm,force_n,torque_nm\n" : "time_s,displacement_mm,force_n\n";
  for (std::size_t i = 0; i < series.force.size(); ++i) {
    text += exact(static_cast<double>(i) / series.rate) + "," +
            exact(1000.0 * series.displacement[i]) + "," + exact(series.force[i]);
    if (hasTorque) text += "," + exact(series.torque[i]);
    text += "\n";
  }
  return text;
}

namespace {

constexpr double kMillimetres = 1000.0;

std::optional<std::string> implausibilityIn(const Series& series) {
  constexpr std::size_t kFewest = 100;
  const auto& x = series.displacement;
  if (x.size() != series.force.size() ||
      (!series.torque.empty() && series.torque.size() != x.size())) {
    return "its columns differ in length";
  }
  if (x.size() < kFewest) {
    return "it has " + std::to_string(x.size()) + " samples; a test takes " +
           std::to_string(kFewest) + " and more";
  }
  for (const auto* column : {&series.displacement, &series.force, &series.torque}) {
    for (std::size_t i = 0; i < column->size(); ++i) {
      if (!std::isfinite((*column)[i])) {
        return "sample " + std::to_string(i + 1) + " is no number";
      }
    }
  }
  const double way = x.back() - x.front();
  if (!(way > 0.0)) {
    return "its displacement goes from " + recordings::decimal(kMillimetres * x.front(), 2) +
           " to " + recordings::decimal(kMillimetres * x.back(), 2) +
           " mm; the axis is reversed, or nothing moved";
  }
  const double least = *std::ranges::min_element(x);
  if (x.front() - least > 0.05 * way) return "the reamer goes back at its beginning";
  return std::nullopt;
}

std::optional<std::string> feedChangeIn(const Series& series) {
  constexpr std::size_t kParts = 20;
  constexpr double kToleratedChange = 1.0 / 3.0;
  const auto& x = series.displacement;
  std::vector<double> feeds;
  for (std::size_t part = 0; part < kParts; ++part) {
    const std::size_t from = part * (x.size() - 1) / kParts;
    const std::size_t to = (part + 1) * (x.size() - 1) / kParts;
    feeds.push_back((x[to] - x[from]) * series.rate / static_cast<double>(to - from));
  }
  const double usual = filters::upperMedian(feeds);
  for (std::size_t part = 0; part < kParts; ++part) {
    if (std::abs(feeds[part] - usual) <= kToleratedChange * usual) continue;
    const auto second = [&](std::size_t of) {
      const std::size_t sample = of * (x.size() - 1) / kParts;
      return recordings::decimal(static_cast<double>(sample) / series.rate, 1);
    };
    return "the feed was changed: it is " + recordings::decimal(kMillimetres * feeds[part], 3) +
           " mm/s between " + second(part) + " and " + second(part + 1) + " s, and mostly " +
           recordings::decimal(kMillimetres * usual, 3) + " mm/s";
  }
  return std::nullopt;
}

/// The mean force of each half second.
std::vector<double> halfSecondMeans(const Series& series) {
  const auto length = std::max<std::size_t>(1, static_cast<std::size_t>(series.rate / 2.0));
  std::vector<double> means;
  for (std::size_t at = 0; at + length <= series.force.size(); at += length) {
    double sum = 0.0;
    for (std::size_t i = at; i < at + length; ++i) sum += series.force[i];
    means.push_back(sum / static_cast<double>(length));
  }
  return means;
}

std::optional<std::string> breakOutIn(const Series& series) {
  constexpr double kLeastBreakingForce = 20.0;  // [N]
  const auto means = halfSecondMeans(series);
  for (std::size_t i = 2; i < means.size(); ++i) {
    // Compare with two intervals before, since the break may happen within an interval.
    const double before = means[i - 2];
    if (before < kLeastBreakingForce || means[i] > 0.5 * before) continue;
    const double after =
        *std::max_element(means.begin() + static_cast<std::ptrdiff_t>(i), means.end());
    if (after > 0.75 * before) continue;
    return "the force falls from " + recordings::decimal(before, 0) + " to " +
           recordings::decimal(means[i], 0) + " N within a second, at " +
           recordings::decimal(static_cast<double>(i) / 2.0, 1) + " s, and does not come back";
  }
  return std::nullopt;
}

std::optional<std::string> reamingThroughIn(const Series& series) {
  constexpr double kEarliestDepth = 0.010;  // [m]
  constexpr double kLeastLength = 0.001;    // [m]
  const auto means = halfSecondMeans(series);
  if (means.empty()) return std::nullopt;
  const double most = *std::ranges::max_element(means);
  const double start = series.displacement.front();
  const std::size_t length = series.force.size() / means.size();
  std::size_t empty = means.size();
  while (empty > 0 && means[empty - 1] < 0.1 * most) --empty;
  if (empty == means.size()) return std::nullopt;
  const double from = series.displacement[empty * length] - start;
  const double to = series.displacement.back() - start;
  if (from < kEarliestDepth || to - from < kLeastLength) return std::nullopt;
  return "nothing is felt any more from " + recordings::decimal(kMillimetres * from, 1) + " mm on";
}

}  // namespace

Exclusion exclusionOf(const Series& series) {
  if (const auto why = implausibilityIn(series)) return {ExclusionReason::Implausible, *why};
  if (const auto why = feedChangeIn(series)) return {ExclusionReason::FeedChanged, *why};
  if (series.set == TestSet::Static) return {};
  // The force also falls when the bone is reamed through, so this is checked first.
  if (const auto why = reamingThroughIn(series)) return {ExclusionReason::ReamedThrough, *why};
  if (const auto why = breakOutIn(series)) return {ExclusionReason::BrokeOut, *why};
  return {};
}

}  // namespace haptics::reaming
