// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/result_file.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "mahlwerk/results/files/hdf5_handle.hpp"

namespace mahlwerk::results {
namespace {

/// Writes data sets. Records failures and reports them at the end.
class Writer {
 public:
  explicit Writer(const std::filesystem::path& path) : path_(path) {
    const Handle how(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    H5Pset_obj_track_times(how, false);
    file_ = Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, how, H5P_DEFAULT), H5Fclose);
    if (!file_.valid()) throw failure("create the file");
  }

  void attribute(Handle::Id object, const std::string& name, std::string_view text) {
    good_ = write_attribute(object, name, text) && good_;
  }
  void attribute(const std::string& name, std::string_view text) { attribute(file_, name, text); }

  /// Writes a data set. Groups in `name` are created.
  Handle dataset(const std::string& name, Handle::Id type, const std::vector<hsize_t>& shape,
                 const void* content) {
    const Handle groups(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(groups, 1);
    const auto rank = static_cast<int>(shape.size());
    const Handle space(H5Screate_simple(rank, shape.data(), nullptr), H5Sclose);
    const Handle how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(how, false);
    const bool empty = std::find(shape.begin(), shape.end(), 0) != shape.end();
    if (!empty) {
      std::vector<hsize_t> part = shape;  // at most some 100 kB each
      for (hsize_t& n : part) n = std::min<hsize_t>(n, rank == 1 ? 4096 : rank == 2 ? 64 : 16);
      H5Pset_chunk(how, rank, part.data());
      H5Pset_shuffle(how);
      H5Pset_deflate(how, deflation);
    }
    Handle set(H5Dcreate2(file_, name.c_str(), type, space, groups, how, H5P_DEFAULT), H5Dclose);
    good_ = good_ && set.valid();
    if (!empty) good_ = good_ && H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, content) >= 0;
    return set;
  }

  void finish() {
    good_ = H5Fflush(file_, H5F_SCOPE_GLOBAL) >= 0 && good_;
    good_ = file_.close() && good_;
    if (!good_) throw failure("write the file");
  }

 private:
  InputError failure(const char* doing) const {
    return hdf5_failure(path_, doing,
                        "free some space or correct the permissions, or choose another folder with "
                        "--out");
  }

  std::filesystem::path path_;
  Handle file_;
  bool good_ = true;
};

/// Fixed-length text type, as long as the longest word, padded with zeros.
Handle text_type(const Column& column) {
  std::size_t longest = 1;
  for (const std::string& word : column.words) longest = std::max(longest, word.size());
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, longest);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

/// Writes rows as compound records with a field for each column.
void write_table(Writer& out, const std::string& name, const std::string& about,
                 const Table& table) {
  std::vector<Handle> types;
  std::vector<std::size_t> places;
  std::size_t size = 0;
  for (const Column& c : table.columns) {
    types.push_back(c.words.empty() ? Handle(H5Tcopy(H5T_NATIVE_DOUBLE), H5Tclose) : text_type(c));
    places.push_back(size);
    size += H5Tget_size(types.back());
  }
  const Handle record(H5Tcreate(H5T_COMPOUND, size), H5Tclose);
  for (std::size_t i = 0; i < types.size(); ++i)
    H5Tinsert(record, table.columns[i].name.c_str(), places[i], types[i]);
  std::vector<char> content(table.rows.size() * size);
  for (std::size_t r = 0; r < table.rows.size(); ++r)
    for (std::size_t i = 0; i < types.size(); ++i) {
      const double value = table.rows[r][i];
      char* cell = content.data() + r * size + places[i];
      const std::vector<std::string>& words = table.columns[i].words;
      if (words.empty()) {
        std::memcpy(cell, &value, sizeof value);
      } else {
        const std::string& word = words[static_cast<std::size_t>(value)];
        std::memcpy(cell, word.data(), word.size());
      }
    }
  const Handle set = out.dataset(name, record, {table.rows.size()}, content.data());
  out.attribute(set, "about", about);
  for (const Column& c : table.columns) {
    out.attribute(set, "unit_" + c.name, c.unit);
    out.attribute(set, "about_" + c.name, c.about);
  }
}

Table summary_table(const std::vector<Quantity>& quantities) {
  Table table{{{"name", "1", "name of the quantity, as in summary.json"},
               {"value", "see unit", "mean over replicates"},
               {"ci95", "see unit", "half-width of its 95 % confidence interval over replicates"},
               {"ci95_time", "see unit",
                "half-width of the 95 % confidence interval from the scatter over time"},
               {"unit", "1", "unit of value and ci95"},
               {"about", "1", "description of the quantity"}},
              {}};
  for (const Quantity& q : quantities)
    table.rows.push_back({table.columns[0].number_of(q.name), q.value, q.ci95, q.ci95_time,
                          table.columns[4].number_of(q.unit), table.columns[5].number_of(q.about)});
  return table;
}

void write_matrix(Writer& out, const Matrix& m) {
  std::size_t cells = 1;
  bool fits = m.axes.size() == m.shape.size() && m.edges.size() == m.shape.size();
  for (std::size_t k = 0; fits && k < m.shape.size(); ++k) {
    cells *= m.shape[k];
    fits = m.edges[k].size() == m.shape[k] + 1;
  }
  if (!fits || cells != m.values.size())
    throw std::invalid_argument("the matrix " + m.name +
                                " has a number of values that differs from its shape");
  const auto numbers = [&](const std::string& name, const std::vector<hsize_t>& shape,
                           const std::vector<double>& values, const std::string& unit,
                           const std::string& about) {
    Handle set = out.dataset(name, H5T_NATIVE_DOUBLE, shape, values.data());
    out.attribute(set, "about", about);
    out.attribute(set, "unit", unit);
    return set;
  };
  const Handle set = numbers(m.name, {m.shape.begin(), m.shape.end()}, m.values, m.unit, m.about);
  std::string names;
  for (std::size_t k = 0; k < m.axes.size(); ++k) {
    const Column& axis = m.axes[k];
    names += (k > 0 ? ", " : "") + axis.name;
    numbers(m.name + "_edges/" + axis.name, {m.edges[k].size()}, m.edges[k], axis.unit, axis.about);
  }
  out.attribute(set, "axes", names);
}

}  // namespace

void write_result_file(const std::filesystem::path& file, const std::vector<NamedTable>& tables,
                       const std::vector<Matrix>& matrices, const std::vector<Quantity>& quantities,
                       std::string_view case_text, std::string_view version) {
  const auto lock = hdf5_library();
  errno = 0;
  Writer out(file);
  out.attribute("mahlwerk", version);
  out.attribute("case", case_text);
  write_table(out, "summary", "the quantities of summary.json", summary_table(quantities));
  for (const NamedTable& t : tables) write_table(out, t.name, t.about, t.table);
  for (const Matrix& m : matrices) write_matrix(out, m);
  out.finish();
}

}  // namespace mahlwerk::results
