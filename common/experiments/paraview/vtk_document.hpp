#pragma once

#include "common/geometry/vector.hpp"

#include <pugixml.hpp>

#include <string>
#include <utility>
#include <vector>

namespace enduring {

/// A part of a piece that holds arrays: Points, Polys, PointData ...
class VtkSection {
public:
    explicit VtkSection(pugi::xml_node node) : node_(node) {}
    VtkSection& add(const std::string& name, const std::vector<Vec3>& values);
    VtkSection& add(const std::string& name, const std::vector<double>& values);
    VtkSection& add(const std::string& name, const std::vector<long>& values);

private:
    VtkSection& add(const std::string& name, const char* type, int components, const std::string& values);

    pugi::xml_node node_;
};

/// A VTK file of one piece in the XML format, its arrays as text: numbers in the shortest form that reads
/// back the same. https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html
class VtkDocument {
public:
    /// @param type    "PolyData" or "UnstructuredGrid"
    /// @param counts  of the piece, as {"NumberOfPoints", 8}
    VtkDocument(const char* type, const std::vector<std::pair<const char*, std::size_t>>& counts);
    VtkSection section(const char* name) { return VtkSection(piece_.append_child(name)); }
    std::string text() const;

private:
    pugi::xml_document document_;
    pugi::xml_node piece_;
};

/// A new document with VTK's root element.
/// @return that element
pugi::xml_node begin_vtk_file(pugi::xml_document& document, const char* type);
std::string xml_text(const pugi::xml_document& document);

}  // namespace enduring
