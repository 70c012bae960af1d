#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/draw.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/work.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// The framebuffer of a frame at any moment. Forward, it draws on from where it is. Backward, it
/// takes the pixels that have changed since from a copy of an earlier moment, and redraws those: a
/// step back costs what it undoes.
///
/// Copies (keyframes) are made at marks spread evenly over the work of the frame, as many as the
/// budget holds. In a frame of much work one or two are made during the first drawing, the others,
/// one per call, after the first step back.
class Replay {
  public:
    explicit Replay(std::size_t budget_bytes = std::size_t{64} << 20) : budget_(budget_bytes) {}

    /// Starts over with this frame, which must live while the replay uses it.
    void begin(const Frame& frame);

    /// The same with its work already estimated; `work` gets the memory of the previous frame's in
    /// exchange.
    void begin(const Frame& frame, FrameWork& work);

    /// The framebuffer with everything before `cursor` drawn; valid until the next call.
    const Framebuffer& at(const Cursor& cursor) { return toward(cursor, {}); }

    /// Goes toward the cursor as far as the limit allows, and stays where it is if it
    /// is_deferred(). The framebuffer has everything before drawn() drawn; valid until the next
    /// call. As long as it is not clear, it is cleared first, even if it is_deferred(): until then
    /// its non-empty pixels can be those of the previous frame.
    const Framebuffer& toward(const Cursor& cursor, const WorkLimit& limit);
    const Cursor& drawn() const { return cursor_; }

    /// Is there nothing left of the previous frame in the framebuffer?
    bool is_clear() const { return is_empty(uncleared_); }
    /// Does the framebuffer have everything before the cursor, and nothing else?
    bool is_at(const Cursor& cursor) const { return is_clear() && cursor_ == cursor; }

    /// Is more left to draw up to the cursor than the limit allows?
    bool is_deferred(const Cursor& cursor, const WorkLimit& limit) const;

    /// All pixels that the last call has changed in any plane lie in this rectangle; after the
    /// first call since begin(), also those that begin() has changed.
    const Rectangle& changed() const { return changed_; }

    /// The tally of the frame so far, counting everything once, and the moment it has reached.
    const DrawTally& tally() const { return tally_; }
    const Cursor& tallied() const { return tallied_; }

    const FrameWork& work() const { return work_; }

    /// Memory that the copies take.
    std::size_t keyframe_bytes() const;
    std::size_t keyframe_count() const;

  private:
    struct Mark {
        Cursor cursor;
        bool in_first_pass = false; ///< to be made before any step back
        Framebuffer copy;           ///< of this moment; without pixels until it is made

        bool is_saved() const { return !copy.depth.empty(); }
    };
    void begin_clear();
    void clear_some(const WorkLimit& limit);
    Framebuffer spare_copy();
    void place_marks();
    const Mark* last_saved(const Cursor& cursor) const;
    Rectangle changed_between(const Cursor& from, const Cursor& to) const;
    void restore(const Rectangle& pixels, const Mark* mark);
    void go_back(const Cursor& cursor, const Mark* mark, const WorkLimit& limit);
    Cursor part_end(const Cursor& cursor, const WorkLimit& limit) const;
    void save_keyframes_and_draw(const Cursor& cursor);
    void draw_on(const Cursor& cursor);

    const Frame* frame_ = nullptr;
    FrameWork work_;
    Framebuffer framebuffer_;
    Cursor cursor_ = cursor_begin;
    Rectangle changed_;
    Rectangle uncleared_; ///< pixels of the previous frame lie in it
    Rectangle touched_;   ///< all pixels that are not empty lie in it, or in uncleared_
    Rectangle begun_;     ///< what begin() has changed, until changed() reports it
    int owners_ = 0;      ///< triangles of the frame that the previous owners belong to
    DrawTally tally_;
    Cursor tallied_ = cursor_begin;
    std::vector<Mark> marks_;        ///< in order of time
    std::vector<Framebuffer> spare_; ///< copies of the previous frame: their memory is used
    std::size_t budget_;
    bool has_stepped_back_ = false;
};

} // namespace rasterwalk
