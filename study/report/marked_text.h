#pragma once

#include <QString>

namespace study::report {

/// The HTML of a text in the subset of Markdown that instruments and protocols may use: headings,
/// paragraphs, lists, bold and italics. As in plain text, a line break stays one.
///
/// Links stay as their words. Pictures and HTML in the text are left out, so that a text can load
/// nothing.
QString asHtml(const QString& markdown);

}  // namespace study::report
