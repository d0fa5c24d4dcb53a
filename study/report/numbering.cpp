#include "study/report/numbering.h"

#include <array>
#include <map>
#include <stdexcept>
#include <string_view>

#include "study/report/html_text.h"

namespace study::report {
namespace {

/// What a reference to a caption becomes.
struct Target {
  std::string id;    ///< "table-3"
  std::string name;  ///< "Table 3"
};

/// An element that has a caption.
struct CaptionedElement {
  std::string_view element;      ///< its opening tag
  std::string_view caption;      ///< the beginning of its caption's tag
  std::string_view id;           ///< what its id begins with
  std::string_view labelFormat;  ///< "Table {}"
};
constexpr std::array kCaptionedElements{
    CaptionedElement{"<table>", "<caption", "table-", "Table {}"},
    CaptionedElement{"<figure>", "<figcaption", "figure-", "Figure {}"}};

using Position = std::string::size_type;

/// Removes the key from the tag of a caption, which begins at @p at, and returns it; empty if the
/// caption has no key.
std::string takeKey(std::string& html, Position at) {
  constexpr std::string_view kId = " id=\"";
  const auto end = html.find('>', at);
  const auto begin = html.find(kId, at);
  if (begin == std::string::npos || begin > end) return {};
  auto key = html.substr(begin + kId.size(), end - 1 - begin - kId.size());
  html.erase(begin, end - begin);
  return key;
}

/// Fills in the references to @p targets.
void fillInReferences(std::string& html, const std::map<std::string, Target>& targets) {
  constexpr std::string_view kBegin = "<a href=\"#";
  constexpr std::string_view kEnd = "\"></a>";
  for (auto at = html.find(kBegin); at != std::string::npos; at = html.find(kBegin, at + 1)) {
    const auto key = at + kBegin.size();
    const auto end = html.find(kEnd, key);
    const auto found = targets.find(html.substr(key, end - key));
    if (found == targets.end()) {
      throw std::logic_error("no caption has the key " + html.substr(key, end - key));
    }
    const auto& [id, name] = found->second;
    html.replace(key, end + kEnd.size() - key, id + "\">" + name + "</a>");
  }
}

}  // namespace

std::string Numbering::numbered(const std::string& page, const words::Words& words) {
  std::string html = page;
  std::map<std::string, Target> targets;
  for (std::size_t kind = 0; kind < kCaptionedElements.size(); ++kind) {
    const auto& [element, caption, prefix, labelFormat] = kCaptionedElements[kind];
    for (auto at = html.find(element); at != std::string::npos; at = html.find(element, at + 1)) {
      const auto tag = html.find(caption, at);
      if (tag == std::string::npos) break;
      const bool isInAppendix = at > html.find("<h2 class=\"appendix\">");
      auto& counts = isInAppendix ? appendix_ : main_;
      const int count = ++(kind == 0 ? counts.tables : counts.figures);
      const auto number = (isInAppendix ? "A" : "") + std::to_string(count);
      const Target target{std::string(prefix) + number, words.say(labelFormat, number)};
      const auto key = takeKey(html, tag);
      if (!key.empty()) targets.emplace(key, target);
      const auto name = "<b>" + escaped(target.name) + ".</b> ";
      html.insert(html.find('>', tag) + 1, name);
      html.insert(at + element.size() - 1, " id=\"" + target.id + "\"");
    }
  }
  fillInReferences(html, targets);
  return html;
}

}  // namespace study::report
