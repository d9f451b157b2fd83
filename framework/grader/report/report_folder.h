#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace muelle::grader {

/// A file name made of a submission's: printable, without separators, not hidden, at most 100 bytes; "submission" when
/// nothing is left of it.
std::string fileNameFor(const std::string& name);

/// The folder for the reports of the submission at `submission`, below `parent` and made when missing: its own name,
/// or, when that is another submission's already, the name and eight digits of its path. Two submissions never share
/// one; the same submission gets the same again. Throws std::runtime_error when it cannot be made, or a link stands in
/// its place that leads out of `parent`.
std::filesystem::path reportFolder(const std::filesystem::path& parent, const std::filesystem::path& submission);

/// The folder that reportFolder() has made for the submission before; nullopt when there is none.
std::optional<std::filesystem::path> findReportFolder(const std::filesystem::path& parent,
                                                      const std::filesystem::path& submission);

/// Makes `folder`, whose name is given, the submission's: marked, so that no other one's reports overwrite its.
/// Throws as reportFolder() and requireOwn() do.
void claim(const std::filesystem::path& folder, const std::filesystem::path& submission);

/// True when `folder` is marked as the submission's.
bool isOwn(const std::filesystem::path& folder, const std::filesystem::path& submission);

/// Throws std::invalid_argument with what to do when `folder` holds another submission's reports.
void requireOwn(const std::filesystem::path& folder, const std::filesystem::path& submission);

/// Throws std::invalid_argument with what to do when `folder` lies in the submission, or is it: the reports would be
/// handed in with it. The same for a class.
void requireOutside(const std::filesystem::path& folder, const std::filesystem::path& submission);

/// Throws std::runtime_error when `folder` is a link that leads out of the folder it stands in.
void refuseLinkOut(const std::filesystem::path& folder);

}  // namespace muelle::grader
