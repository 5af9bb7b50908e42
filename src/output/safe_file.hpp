// Files one rank writes for all (linalg/agree.hpp): whole or not at all.
#pragma once

#include <string>

namespace voussoir {

/// Writes `content` beside `path` and renames it, so that a reader or a killed run never sees half a file.
/// Not collective. Throws ResourceError.
void replace_file(const std::string& path, const std::string& content);

/// What helps where results cannot be written, beside freeing the place.
inline const std::string other_folder = "give another folder with --out=DIR";

/// Puts the finished file `beside` in the place of `path`: on disk first, then under its name, so that a loss of power
/// leaves the old file or the new one. Not collective. Throws ResourceError.
void publish_file(const std::string& beside, const std::string& path, const std::string& elsewhere = other_folder);

/// Appends a digest of all bytes of a file, by which check_seal knows it whole. Not collective. Throws ResourceError.
void seal_file(const std::string& path);

/// Throws ResourceError when the file cannot be read or is not as it was sealed. Not collective.
void check_seal(const std::string& path);

/// The three lines every message about a file that could not be written has: file, why, what to do.
std::string cannot_write(const std::string& path, const std::string& reason,
                         const std::string& elsewhere = other_folder);
/// Likewise of a file that could not be read.
std::string cannot_read(const std::string& path, const std::string& reason);

}  // namespace voussoir
