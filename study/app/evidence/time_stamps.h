#pragma once

#include <string>

#include "study/session/verification.h"

namespace study::app {

/// A time stamp of a public authority (RFC 3161) for the signed head of an audit trail
/// (docs/decisions/0058). The programs openssl, and curl for an authority on the network, do the
/// work.
struct TimeStampArguments {
  std::string folder;
  std::string authority;  ///< URL; empty: use request and reply files
  std::string request;  ///< new file for the request, which another computer sends to an authority
  std::string reply;    ///< the authority's answer to an earlier request
  std::string certificate;  ///< of the authority's root, in PEM
};

/// Signs the audit trail and requests a time stamp, or writes the request to a file, or reads the
/// reply to an earlier request. A reply is stored in the audit trail if it is valid by the
/// certificate. Returns the exit status, 0.
/// @throws UserError  if a file, the authority or a program fails, or the reply is not valid
int timestamp(const TimeStampArguments& options);

/// Verifies all time stamps in the audit trail and adds the results to @p verification. Without a
/// certificate it only adds their number. Adds nothing if there are none.
void checkTimeStamps(Study& study, const std::string& certificate, Verification& verification);

}  // namespace study::app
