#include "common/experiments/paraview/vtk_document.hpp"

#include "common/input/number_text.hpp"

#include <sstream>

namespace enduring {

VtkSection& VtkSection::add(const std::string& name, const char* type, int components,
                            const std::string& values)
{
    pugi::xml_node array = node_.append_child("DataArray");
    array.append_attribute("type") = type;
    array.append_attribute("Name") = name.c_str();
    array.append_attribute("NumberOfComponents") = components;
    array.append_attribute("format") = "ascii";
    array.text() = values.c_str();
    return *this;
}

VtkSection& VtkSection::add(const std::string& name, const std::vector<Vec3>& values)
{
    std::string text;
    for (const Vec3& value : values)
        text += shortest(value.x()) + ' ' + shortest(value.y()) + ' ' + shortest(value.z()) + '\n';
    return add(name, "Float64", 3, text);
}

VtkSection& VtkSection::add(const std::string& name, const std::vector<double>& values)
{
    std::string text;
    for (const double value : values)
        text += shortest(value) + '\n';
    return add(name, "Float64", 1, text);
}

VtkSection& VtkSection::add(const std::string& name, const std::vector<long>& values)
{
    std::string text;
    for (const long value : values)
        text += std::to_string(value) + ' ';
    return add(name, "Int64", 1, text);
}

VtkDocument::VtkDocument(const char* type, const std::vector<std::pair<const char*, std::size_t>>& counts)
    : piece_(begin_vtk_file(document_, type).append_child("Piece"))
{
    for (const auto& [name, count] : counts)
        piece_.append_attribute(name) = static_cast<unsigned long>(count);
}

std::string VtkDocument::text() const { return xml_text(document_); }

pugi::xml_node begin_vtk_file(pugi::xml_document& document, const char* type)
{
    pugi::xml_node root = document.append_child("VTKFile");
    root.append_attribute("type") = type;
    root.append_attribute("version") = "1.0";
    root.append_attribute("byte_order") = "LittleEndian";
    return root.append_child(type);
}

std::string xml_text(const pugi::xml_document& document)
{
    std::ostringstream out;
    document.save(out, " ");
    return out.str();
}

}  // namespace enduring
