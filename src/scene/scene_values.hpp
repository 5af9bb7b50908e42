// All that a scene says, key by key, as its modules declare it: to compare two scenes, and to look at every value.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/parameter_section.hpp"
#include "scene/scene.hpp"

namespace voussoir {

/// Visits what is chosen of declared parameters, from top to bottom. What nobody set is not called.
class ParameterWalk final : public ParameterSection {
 public:
  /// Of every key with a value; the path is "joints > dry > cohesion".
  std::function<void(const std::string& path, const Parameter&)> parameter;
  /// Of every family: the names of its members, in their order.
  std::function<void(const std::string& path, const std::vector<std::string>& names)> family;
  /// Of everything that is allowed and probably not meant (ParameterSection::expect).
  std::function<void(const std::string& path, const std::string& value, const std::string& why,
                     const std::string& advice)>
      doubt;

 private:
  void visit(const Parameter&) override;
  void visit(const Subsection&, const std::function<void()>& declare) override;
  void visit(const Family&) override;
  void refuse(const std::string&, const std::string&, const std::string&, const std::string&) override {}
  void wonder(const std::string& name, const std::string& value, const std::string& why,
              const std::string& advice) override;
  std::string path(const std::string& name) const { return path_.empty() ? name : path_ + " > " + name; }

  std::string path_;
};

/// Paths and values of a scene in the order of its file, defaults included: equal where two scenes say the same, to the
/// last bit. A long value is shortened, with a digest of all of it. A family has the names of its members as its value.
/// How steps are solved is left out where it is as usual.
using SceneValues = std::vector<std::pair<std::string, std::string>>;

/// @param content  what stands for a file that a load reads, given its path
SceneValues scene_values(const Scene&, const std::function<std::string(const std::string& file)>& content);

}  // namespace voussoir
