#pragma once

#include <string>

#include "study/session/verification.h"

namespace study::app {

/// A time stamp of a public authority (RFC 3161) for the signed head of an audit trail
/// (docs/decisions/0058). The programs openssl, and curl for an authority on the network, do the
/// work.
struct TimeStampArguments {
  std::string folder;
  std::string authority;    ///< URL; empty: by files
  std::string request;      ///< new file, to be sent to an authority from another computer
  std::string reply;        ///< the authority's answer to it
  std::string certificate;  ///< of the authority's root, in PEM
};

/// Signs the audit trail, and asks for a time stamp or writes the request to a file; or keeps the
/// reply to an earlier request. A reply is kept in the audit trail if the certificate proves it.
/// @throws UserError
int timestamp(const TimeStampArguments& options);

/// Looks at all time stamps in the audit trail. Without a certificate it only says how many there
/// are; nothing if there are none.
void checkTimeStamps(Study& study, const std::string& certificate, Verification& verification);

}  // namespace study::app
