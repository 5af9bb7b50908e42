// Drawings of stones from the files people have: CSV, DXF, SVG, GeoJSON.
#pragma once

#include <string>

#include "drawings/outlined_stone.hpp"

namespace voussoir {

/// The stones of a file, in the order they are drawn, in the lengths and the axes of the file.
///
/// CSV      a row for each corner: stone, x, y, and where wanted set and hole (a number from 1 for corners of a hole)
/// DXF      closed LWPOLYLINE and POLYLINE, bulges in chords, and CIRCLE; the layer is a set; on a layer called `holes`
///          they are holes of the stone around them; where a block is inserted its outlines are drawn, its name is a
///          set
/// SVG      path, polygon, closed polyline, rect, circle, ellipse, with transforms; id is the name, words of class and
///          layers of Inkscape are sets; what lies in an outline of the same path is a hole; a `use` draws once more
/// GEOJSON  Polygon and MultiPolygon; of properties `name` (or id) is the name, `set` or `layer` a set
///
/// Throws InputError, naming file, line and place, for what is no such file and for outlines that are not closed.
DrawnFile read_drawing(const std::string& path);

/// The same of the contents of a file; `file` is for messages and names.
DrawnFile read_csv_stones(const std::string& file, const std::string& contents);
DrawnFile read_dxf_stones(const std::string& file, const std::string& contents);
DrawnFile read_svg_stones(const std::string& file, const std::string& contents);
DrawnFile read_geojson_stones(const std::string& file, const std::string& contents);

}  // namespace voussoir
