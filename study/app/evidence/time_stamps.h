#pragma once

#include <string>

#include "study/session/verification.h"

namespace study::app {

/// The options for a time stamp of a public authority (RFC 3161) on the signed head of an audit
/// trail (docs/decisions/0058). Time stamps are made and verified with the programs openssl and,
/// for an authority on the network, curl.
struct TimeStampArguments {
  std::string folder;
  std::string authority;  ///< URL; empty: the request is written to a file and the reply read from
                          ///< a file
  std::string request;    ///< new file for the request, to be sent to an authority by another
                          ///< computer
  std::string reply;      ///< the authority's answer to an earlier request
  std::string certificate;  ///< of the authority's root (PEM)
};

/// Signs the audit trail and requests a time stamp, or writes the request to a file, or reads the
/// reply to an earlier request. A reply that is valid for the certificate is stored in the audit
/// trail. Returns the exit status, 0.
/// @throws UserError  if a file, the authority or a program fails, or the reply is not valid
int requestTimeStamp(const TimeStampArguments& options);

/// Verifies all time stamps in the audit trail and adds the results to @p verification. Without a
/// certificate it only adds their number. Adds nothing if the trail has no time stamp.
void checkTimeStamps(Study& study, const std::string& certificate, Verification& verification);

}  // namespace study::app
