#pragma once

#include <QString>

#include "protocols/model/loaded_protocol.h"

namespace study::gui {

/// A protocol in a page, below its title, for a reader who has not seen its file: what it asks, who
/// takes part, what is compared, which questions there are. Markdown, in the language of the desk.
/// It names the conditions.
QString protocolSummary(const protocols::LoadedProtocol& loaded);

}  // namespace study::gui
