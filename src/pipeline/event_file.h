#pragma once

// Recordings of events as text files, so that a program that is not ours can be walked. The first
// line is "rasterwalk events 1" and the last one "end". In between there is a line for each event,
// in order of time, with tabs between its kind, its moment and its fields:
//
//     fragment  at=t0/r3/c5  column=12  row=9  fate=written  depth=0.25  after=0.8,0.8,0.8  ...
//
// Vectors and lists have commas between their numbers. A field that is left out is 0. What a field
// means, and its unit, is written next to the member that it is read into, see observer.h.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/event_source.h"

namespace rasterwalk {

/// The most events of a recording, and the largest file, bytes.
inline constexpr std::size_t most_recorded_events = 1'000'000;
inline constexpr std::size_t largest_recording = std::size_t{256} << 20;

/// What a source tells in a window, sorted by time. Throws UsageError if it is too much.
std::vector<Event> record(const EventSource& source, const DrawWindow& window = {});

/// The text of a recording; reading it gives the same events to the last bit.
std::string recording_text(const std::vector<Event>& events);

/// Reads the text of a recording. Throws InputError with the line at fault.
/// @param path for messages
std::vector<Event> parse_recording(std::string_view text, const std::string& path);

/// Reads a file. Throws AccessError too.
std::vector<Event> read_recording(const std::string& path);

} // namespace rasterwalk
