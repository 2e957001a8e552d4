// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/state_file.hpp"

#include <algorithm>
#include <fstream>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/results/files/folder.hpp"

namespace mahlwerk::campaign {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view any_magic = "mahlwerk checkpoint ";
constexpr std::string_view magic = "mahlwerk checkpoint 12\n";
constexpr std::size_t piece_size = std::size_t{1} << 20U;  // [bytes] read at a time
constexpr std::size_t number_size = sizeof(std::uint64_t);

InputError refusal(const fs::path& file, std::string what, std::string remedy) {
  return InputError(
      Fault{file.generic_string(), std::move(what), std::move(remedy), "bad-checkpoint"});
}

std::string_view as_bytes(const std::uint64_t& number) {
  return {reinterpret_cast<const char*>(&number), number_size};
}

/// Passes on `size` bytes of a stream, piece by piece; false if there are fewer.
bool read_pieces(std::istream& from, std::uint64_t size,
                 const std::function<void(std::string_view)>& take) {
  std::string piece;
  for (; size > 0; size -= piece.size()) {
    piece.resize(static_cast<std::size_t>(std::min<std::uint64_t>(size, piece_size)));
    if (!from.read(piece.data(), static_cast<std::streamsize>(piece.size()))) return false;
    take(piece);
  }
  return true;
}

/// Reads a file from its beginning up to its fingerprint, never beyond.
class Reader {
 public:
  explicit Reader(const fs::path& file) : stream_(file, std::ios::binary), file_(file) {
    std::error_code none;
    const std::uintmax_t size = fs::file_size(file, none);  // of a device: none
    if (!none && size > number_size) left_ = size - number_size;
  }
  bool open() const { return stream_.is_open(); }
  std::uint64_t left() const { return left_; }
  std::uint64_t place() { return static_cast<std::uint64_t>(stream_.tellg()); }
  std::uint64_t number() {
    std::uint64_t read = 0;
    need(number_size);
    stream_.read(reinterpret_cast<char*>(&read), number_size);
    return read;
  }
  std::string text(std::uint64_t size) {
    need(size);
    std::string read;
    if (!read_pieces(stream_, size, [&](std::string_view piece) { read += piece; }))
      throw StateFile::damaged(file_);
    return read;
  }
  void skip(std::uint64_t size) {
    need(size);
    stream_.seekg(static_cast<std::streamoff>(size), std::ios::cur);
  }
  /// Whether the fingerprint at the end is that of all before it. Without this check a run would
  /// continue with wrong results from a corrupted state.
  bool sealed() {
    std::uint64_t own = fingerprint(""), kept = 0;
    const auto add = [&](std::string_view piece) { own = fingerprint(piece, own); };
    const bool read = read_pieces(stream_, left_, add) &&
                      stream_.read(reinterpret_cast<char*>(&kept), number_size);
    stream_.clear();
    stream_.seekg(0);
    return read && kept == own;
  }

 private:
  void need(std::uint64_t size) {
    if (size > left_) throw StateFile::damaged(file_);
    left_ -= size;
  }
  std::ifstream stream_;
  fs::path file_;
  std::uint64_t left_ = 0;  // [bytes] before the fingerprint
};

}  // namespace

InputError StateFile::damaged(const fs::path& file) {
  return refusal(file, "the checkpoint is damaged", "start the run again, without --resume");
}

StateFile::StateFile(fs::path file, std::string what, std::size_t jobs)
    : file_(std::move(file)), run_id_(std::move(what)), states_(jobs) {
  std::error_code none;
  fs::remove(temporary_file(), none);
}

void StateFile::load() {
  Reader reader(file_);
  if (!reader.open())
    throw refusal(
        file_, "there is no checkpoint to resume from",
        "leave out --resume to start from the beginning; a run of more than a minute keeps a "
        "checkpoint when it is interrupted, a shorter one with --checkpoint");
  const bool whole = reader.sealed();
  const std::string title = reader.text(reader.number());
  if (!title.starts_with(any_magic) || (title == magic && !whole)) throw StateFile::damaged(file_);
  const auto of_another_run = [&] {
    return refusal(file_, "the checkpoint belongs to another run: case, settings or version differ",
                   "resume with the original case and settings, or leave out --resume");
  };
  if (title != magic) throw of_another_run();
  const std::string what = reader.text(reader.number());
  const std::uint64_t jobs = reader.number();
  std::vector<State> found;
  for (std::uint64_t i = 0; i < jobs; ++i) {
    const std::uint64_t size = reader.number();
    found.push_back({.bytes = {}, .place = reader.place(), .size = size});
    reader.skip(size);
  }
  if (reader.left() > 0) throw StateFile::damaged(file_);
  if (what != run_id_ || found.size() != states_.size()) throw of_another_run();
  states_ = std::move(found);
  count();
}

std::string StateFile::state(std::size_t job) const {
  const State& kept = states_[job];
  if (!kept.only_in_file()) return kept.bytes;
  std::string bytes;
  std::ifstream from(file_, std::ios::binary);
  if (!give(kept, from, [&](std::string_view piece) { bytes += piece; })) throw damaged(file_);
  return bytes;
}

void StateFile::set(std::size_t job, std::string bytes) {
  const std::uint64_t size = bytes.size();
  State& mine = states_[job];
  (mine.only_in_file() ? in_file_ : in_memory_) -= static_cast<std::size_t>(mine.size);
  in_memory_ += size;
  mine = {.bytes = std::move(bytes), .place = 0, .size = size};
}

void StateFile::clear() {
  states_.assign(states_.size(), {});
  count();
}

void StateFile::count() {
  in_memory_ = in_file_ = 0;
  for (const State& one : states_)
    (one.only_in_file() ? in_file_ : in_memory_) += static_cast<std::size_t>(one.size);
}

/// A file that somebody removed has taken its states with it; the next one goes on without them.
void StateFile::forget_lost() {
  std::error_code none;
  if (in_file_ == 0 || fs::exists(file_, none) || none) return;
  for (State& one : states_)
    if (one.only_in_file()) one = {};
  count();
}

/// Passes on a state; false if the file no longer gives it.
bool StateFile::give(const State& state, std::istream& from, const Put& put) {
  if (!state.only_in_file()) {
    put(state.bytes);
    return true;
  }
  from.seekg(static_cast<std::streamoff>(state.place));
  return read_pieces(from, state.size, put);
}

void StateFile::write() {
  forget_lost();
  std::ifstream from;
  if (in_file_ > 0) from.open(file_, std::ios::binary);
  std::vector<State> written;
  written.reserve(states_.size());
  results::write_pieces(temporary_file(), [&](const Put& put) {
    std::uint64_t seal = fingerprint(""), place = 0;
    const Put sealed = [&](std::string_view piece) {
      seal = fingerprint(piece, seal);
      place += piece.size();
      put(piece);
    };
    const auto put_text = [&](std::string_view text) {
      sealed(as_bytes(text.size()));
      sealed(text);
    };
    put_text(magic);
    put_text(run_id_);
    sealed(as_bytes(states_.size()));
    for (const State& one : states_) {
      sealed(as_bytes(one.size));
      written.push_back({.bytes = {}, .place = place, .size = one.size});
      if (!give(one, from, sealed))
        throw refusal(file_, "cannot be read any more", "leave the file to the run");
    }
    put(as_bytes(seal));
  });
  fs::rename(temporary_file(), file_);
  states_ = std::move(written);
  count();
}

}  // namespace mahlwerk::campaign
