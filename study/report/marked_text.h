#pragma once

#include <QString>

namespace study::report {

/// The HTML of a text in the subset of Markdown that instruments and protocols may use: headings,
/// paragraphs, lists, bold and italics. Line breaks are kept.
///
/// A link becomes its plain text. Pictures and HTML are left out, so that a text cannot load
/// anything.
QString asHtml(const QString& markdown);

}  // namespace study::report
