#include "output/xdmf.hpp"

#include <sstream>

#include "base/check.hpp"

namespace voussoir {
namespace {

enum class Number { real, integer, long_integer };

class XdmfWriter {
 public:
  explicit XdmfWriter(const XdmfContent& content) : content_(content) { text_.precision(15); }

  std::string whole(XdmfOf what) {
    text_ << "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n";
    if (what == XdmfOf::stones) collection("blocks", &XdmfWriter::blocks);
    if (what == XdmfOf::joints) collection("joints", &XdmfWriter::joints);
    if (what == XdmfOf::last_stones && !content_.steps.empty()) {
      // Without a time: meshio.read takes a grid of topology, geometry and attributes alone.
      text_ << "<Grid Name=\"blocks\" GridType=\"Uniform\">\n";
      blocks(content_.steps.back());
      text_ << "</Grid>\n";
    }
    text_ << "</Domain>\n</Xdmf>\n";
    return text_.str();
  }

 private:
  void collection(const char* name, void (XdmfWriter::*grid)(const XdmfContent::Step&)) {
    text_ << "<Grid Name=\"" << name << "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    for (const auto& step : content_.steps) {
      text_ << "<Grid Name=\"" << name << "\" GridType=\"Uniform\">\n<Time Value=\"" << step.time << "\"/>\n";
      (this->*grid)(step);
      text_ << "</Grid>\n";
    }
    text_ << "</Grid>\n";
  }

  void blocks(const XdmfContent::Step& step) {
    const auto& group = step.group;
    if (content_.mixed > 0)
      topology("Mixed", content_.cells, content_.mixed, 1, mixed_cells);
    else
      topology(cell_name(), content_.cells, content_.cells, content_.corners, "/mesh/cells");
    geometry("/mesh/coordinates", content_.nodes);
    attribute("displacement [m]", "Vector", "Node", Number::real, content_.nodes, 3,
              vectors_for_viewers(group + "/displacement", content_.dim));
    if (step.moving)
      attribute("velocity [m/s]", "Vector", "Node", Number::real, content_.nodes, 3,
                vectors_for_viewers(group + "/velocity", content_.dim));
    if (content_.dim == 2)
      attribute("stress xx, yy, xy [Pa]", "Vector", "Cell", Number::real, content_.cells, 3, group + "/stress");
    else
      attribute("stress [Pa]", "Tensor6", "Cell", Number::real, content_.cells, 6, group + "/stress");
    attribute("block", "Scalar", "Cell", Number::integer, content_.cells, 1, "/mesh/block_of_cell");
    attribute("rank", "Scalar", "Cell", Number::integer, content_.cells, 1, "/mesh/rank_of_cell");
  }

  void joints(const XdmfContent::Step& step) {
    const auto& group = step.group;
    const long long points = content_.points;
    topology("Polyvertex", points, points, 1, "/joints/point");
    geometry("/joints/position", points);
    attribute("normal", "Vector", "Node", Number::real, points, 3, vectors_for_viewers("/joints/normal", content_.dim));
    const auto scalar = [&](const char* name, Number number, const char* table) {
      attribute(name, "Scalar", "Node", number, points, 1, group + "/" + table);
    };
    scalar("gap [m]", Number::real, "joint_gap_m");
    scalar("slip [m]", Number::real, "joint_slip_m");
    scalar("normal force [N]", Number::real, "joint_normal_force_N");
    scalar("tangential force [N]", Number::real, "joint_tangential_force_N");
    if (content_.dim == 3)
      attribute("force on block j [N]", "Vector", "Node", Number::real, points, 3, group + "/joint_force_N");
    scalar("status", Number::integer, "joint_status");
    scalar("selected", Number::integer, "joint_selected");
    if (content_.damage) scalar("damage", Number::real, "joint_damage");
  }

  const char* cell_name() const {
    if (content_.dim == 2) return content_.corners == 3 ? "Triangle" : "Quadrilateral";
    return content_.corners == 4 ? "Tetrahedron" : "Hexahedron";
  }

  void topology(const std::string& type, long long count, long long rows, int corners, const std::string& table) {
    text_ << "<Topology TopologyType=\"" << type << "\" NumberOfElements=\"" << count << '"';
    if (type == "Polyvertex") text_ << " NodesPerElement=\"1\"";
    text_ << ">\n";
    item(Number::long_integer, rows, corners, table);
    text_ << "</Topology>\n";
  }

  void geometry(const char* table, long long count) {
    text_ << "<Geometry GeometryType=\"" << (content_.dim == 2 ? "XY" : "XYZ") << "\">\n";
    item(Number::real, count, content_.dim, table);
    text_ << "</Geometry>\n";
  }

  void attribute(const char* name, const char* type, const char* center, Number number, long long rows, int columns,
                 const std::string& table) {
    text_ << "<Attribute Name=\"" << name << "\" AttributeType=\"" << type << "\" Center=\"" << center << "\">\n";
    item(number, rows, columns, table);
    text_ << "</Attribute>\n";
  }

  void item(Number number, long long rows, int columns, const std::string& table) {
    text_ << "<DataItem Dimensions=\"" << rows;
    if (columns > 1) text_ << ' ' << columns;
    text_ << "\" NumberType=\"" << (number == Number::real ? "Float" : "Int") << "\" Precision=\""
          << (number == Number::integer ? 4 : 8) << "\" Format=\"HDF\">" << content_.fields << ':' << table
          << "</DataItem>\n";
  }

  const XdmfContent& content_;
  std::ostringstream text_;
};

}  // namespace

long long xdmf_kind_of_solid(int corners) {
  constexpr long long tetrahedron = 6, hexahedron = 9;
  VOUSSOIR_EXPECT(corners == 4 || corners == 8);
  return corners == 4 ? tetrahedron : hexahedron;
}

std::string xdmf_text(const XdmfContent& content, XdmfOf what) {
  VOUSSOIR_EXPECT(content.dim == 2 || content.dim == 3);
  return XdmfWriter(content).whole(what);
}

std::string vectors_for_viewers(const std::string& table, int dim) { return dim == 2 ? table + "_xyz" : table; }

}  // namespace voussoir
