// Commands of the language of gmsh that a drawing has no need of: those that run programs, and read or write files.
//
// gmsh carries out a .geo like a script, so a scene of a stranger could do whatever its user may. Such commands are
// refused unless the user trusts the file.
#pragma once

#include <string>

namespace voussoir {

enum class Trust { no, yes };

/// A text of the language without its comments: as many lines, and strings kept or blank. Comments and strings are told
/// as gmsh tells them, in which a backslash means nothing.
enum class Strings { kept, blank };
std::string without_comments(const std::string& text, Strings);

/// What a drawing must not do, "line 3 has SystemCall, which runs programs"; "" for a drawing that does nothing of it.
std::string forbidden_command(const std::string& text);

/// Throws InputError for a .geo with such a command, and for a .msh that gmsh would read as one. Files that cannot be
/// read are left to who reads them.
/// @param file  as messages call it;  @param path  of it
void refuse_commands(const std::string& file, const std::string& path);

}  // namespace voussoir
