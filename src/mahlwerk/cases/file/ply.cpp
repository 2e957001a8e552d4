// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

#include "mahlwerk/base/text.hpp"
#include "mahlwerk/cases/file/mesh_file.hpp"

namespace mahlwerk::cases {
namespace {

enum class Encoding { ascii, little, big };

struct ScalarType {
  std::array<std::string_view, 2> names;
  std::size_t size;  // [bytes]
  char kind;         // 'i' signed, 'u' unsigned, 'f' floating point
};
constexpr ScalarType scalar_types[] = {
    {{"char", "int8"}, 1, 'i'},     {{"uchar", "uint8"}, 1, 'u'},   {{"short", "int16"}, 2, 'i'},
    {{"ushort", "uint16"}, 2, 'u'}, {{"int", "int32"}, 4, 'i'},     {{"uint", "uint32"}, 4, 'u'},
    {{"float", "float32"}, 4, 'f'}, {{"double", "float64"}, 8, 'f'}};

struct Property {
  std::string_view name;
  const ScalarType* type = nullptr;
  const ScalarType* count = nullptr;  // of a list; null: one number
};
struct Element {
  std::string_view name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

const ScalarType& type_called(std::string_view name) {
  for (const ScalarType& type : scalar_types)
    if (name == type.names[0] || name == type.names[1]) return type;
  throw MeshFileError(fmt::format("its header has the type \"{}\"", name.substr(0, 40)));
}

/// Words and numbers of a PLY file, one after the other.
class PlyData {
 public:
  explicit PlyData(std::string_view bytes) : bytes_(bytes) {}

  std::string_view line() {
    if (at_ >= bytes_.size()) throw MeshFileError("it is cut off in its header");
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    const std::string_view found = trimmed(bytes_.substr(at_, end - at_));
    at_ = end + 1;
    return found;
  }
  double number(const ScalarType& type, Encoding encoding) {
    return encoding == Encoding::ascii ? written() : binary(type, encoding);
  }

 private:
  double written() {
    const std::size_t from = bytes_.find_first_not_of(" \t\r\n", std::min(at_, bytes_.size()));
    if (from == std::string_view::npos) throw MeshFileError("it is cut off");
    const std::size_t end = std::min(bytes_.find_first_of(" \t\r\n", from), bytes_.size());
    at_ = end;
    double value = 0;
    const auto [stop, error] = std::from_chars(bytes_.data() + from, bytes_.data() + end, value);
    if (error != std::errc{} || stop != bytes_.data() + end)
      throw MeshFileError(fmt::format("\"{}\" is not a number",
                                      bytes_.substr(from, std::min<std::size_t>(end - from, 40))));
    return value;
  }
  double binary(const ScalarType& type, Encoding encoding) {
    if (at_ + type.size > bytes_.size()) throw MeshFileError("it is cut off");
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < type.size; ++k) {
      const std::size_t from = encoding == Encoding::little ? type.size - 1 - k : k;
      bits = bits << 8 | static_cast<unsigned char>(bytes_[at_ + from]);
    }
    at_ += type.size;
    if (type.kind == 'f')
      return type.size == 4
                 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                 : std::bit_cast<double>(bits);
    const std::uint64_t sign = std::uint64_t{1} << (8 * type.size - 1);
    if (type.kind == 'i' && (bits & sign) != 0)
      return -static_cast<double>((~bits + 1) & ((sign << 1) - 1));
    return static_cast<double>(bits);
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
};

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

struct PlyHeader {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
};

void add_property(PlyHeader& header, const std::vector<std::string_view>& words) {
  if (header.elements.empty()) throw MeshFileError("its header has a property of no element");
  Property property;
  if (words.size() == 5 && words[1] == "list")
    property = {words[4], &type_called(words[3]), &type_called(words[2])};
  else if (words.size() == 3)
    property = {words[2], &type_called(words[1]), nullptr};
  else
    throw MeshFileError("its header has a property without type or name");
  header.elements.back().properties.push_back(property);
}

PlyHeader read_header(PlyData& data) {
  PlyHeader header;
  data.line();  // ply
  for (;;) {
    const std::vector<std::string_view> words = words_of(data.line());
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") return header;
    if (words[0] == "format" && words.size() > 1) {
      header.encoding =
          words[1] == "ascii"                  ? Encoding::ascii
          : words[1] == "binary_little_endian" ? Encoding::little
          : words[1] == "binary_big_endian"
              ? Encoding::big
              : throw MeshFileError(fmt::format("its format is \"{}\"", words[1].substr(0, 40)));
    } else if (words[0] == "element" && words.size() == 3) {
      std::size_t count = 0;
      const auto [end, error] =
          std::from_chars(words[2].data(), words[2].data() + words[2].size(), count);
      if (error != std::errc{} || end != words[2].data() + words[2].size())
        throw MeshFileError("its header has an element without a number");
      header.elements.push_back({words[1], count, {}});
    } else if (words[0] == "property") {
      add_property(header, words);
    } else {
      throw MeshFileError(fmt::format("its header has the line \"{}\"", words[0].substr(0, 40)));
    }
  }
}

std::int64_t whole(double value, const std::string& what) {
  if (!(value >= 0 && value <= 1e15) || value != std::floor(value))
    throw MeshFileError(fmt::format("{} is not a whole number", what));
  return static_cast<std::int64_t>(value);
}

/// The numbers of a property of one vertex or face.
std::vector<double> numbers_of(PlyData& data, const Property& property, Encoding encoding) {
  std::size_t count = 1;
  if (property.count != nullptr)
    count = static_cast<std::size_t>(whole(data.number(*property.count, encoding), "a count"));
  std::vector<double> all;
  for (std::size_t k = 0; k < count; ++k) all.push_back(data.number(*property.type, encoding));
  return all;
}

void read_vertex(PlyData& data, const Element& element, Encoding encoding, PolygonList& polygons) {
  Vec3 p;
  int given = 0;
  for (const Property& property : element.properties) {
    const std::vector<double> numbers = numbers_of(data, property, encoding);
    if (property.count != nullptr || property.name.size() != 1) continue;
    double* to = property.name == "x"   ? &p.x
                 : property.name == "y" ? &p.y
                 : property.name == "z" ? &p.z
                                        : nullptr;
    if (to == nullptr) continue;
    *to = numbers[0];
    ++given;
  }
  if (given != 3) throw MeshFileError("its vertices have no x, y and z");
  if (!std::isfinite(p.x + p.y + p.z))
    throw MeshFileError(
        fmt::format("vertex {} has a coordinate that is not a number", polygons.vertices() + 1));
  polygons.add_vertex(p.x, p.y, p.z);
}

void read_face(PlyData& data, const Element& element, Encoding encoding, std::size_t number,
               PolygonList& polygons) {
  const std::string what = fmt::format("face {}", number);
  for (const Property& property : element.properties) {
    const std::vector<double> numbers = numbers_of(data, property, encoding);
    if (property.name != "vertex_indices" && property.name != "vertex_index") continue;
    std::vector<std::int64_t> corners;
    for (const double n : numbers) corners.push_back(whole(n, "a corner of " + what));
    polygons.add_polygon(corners, what);
  }
}

}  // namespace

std::vector<geometry::Corners> read_ply(std::string_view bytes, double scale) {
  PlyData data(bytes);
  const PlyHeader header = read_header(data);
  PolygonList polygons(scale);
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    for (std::size_t i = 0; i < element.count; ++i) {
      if (element.name == "vertex")
        read_vertex(data, element, header.encoding, polygons);
      else if (element.name == "face")
        read_face(data, element, header.encoding, i + 1, polygons);
      else
        for (const Property& property : element.properties)
          numbers_of(data, property, header.encoding);
    }
  }
  return std::move(polygons).triangles();
}

}  // namespace mahlwerk::cases
