#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/export/column.h"
#include "study/export/export.h"

namespace study {

/// Which study, which version of the protocol, which program, and whether blinded: a JSON object.
std::string headAsJson(Study& study, const ExportOptions& options);

/// What a person who opens the folder reads first. @p sessions are in it; @p responses is the table
/// of answers, by its path in the folder.
std::string readmeOf(
    Study& study, const ExportOptions& options, std::size_t sessions, const std::string& responses);

/// Who reads a folder that is made with @p options.
Readers readersOf(Study& study, const ExportOptions& options);

/// All tables that @p options ask for, the one with a row per session or person first.
std::vector<ExportedTable> tablesFor(Study& study, const ExportOptions& options);

/// Lays the study out as Psych-DS asks for (psych-ds.github.io): tables with data dictionaries
/// below data/, what was asked below materials/. Unblinded also the protocol itself, which says
/// what codes stand for. @return  how many sessions are in it.
std::size_t writePsychDs(
    Study& study, const std::filesystem::path& folder, const ExportOptions& options);

/// Lays the study out as BIDS asks for: sub-<label>/ses-<label>/beh/, tables with tabs, a
/// dictionary beside each. @return  how many sessions are in it.
std::size_t writeBids(
    Study& study, const std::filesystem::path& folder, const ExportOptions& options);

/// What may stand as a label in the name of a file: the letters and digits of @p text.
std::string bidsLabel(const std::string& text);

/// The scripts that go with @p options: to read the tables with their types where R or Python is
/// asked for; unblinded, to compute the statistics table again from the responses.
void writeScripts(const std::filesystem::path& folder, const ExportOptions& options);

/// The 1 kHz traces of all trials that @p options choose, one gzip-compressed CSV each, as
/// `P001_session-1_step-07_attempt-1_force.csv.gz` in @p folder. The same study gives the same
/// bytes. @return  how many.
/// @throws storage::StorageError  if one cannot be read or written.
std::size_t writeTraces(
    Study& study, const std::filesystem::path& folder, const ExportOptions& options);

}  // namespace study
