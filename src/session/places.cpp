#include "session/places.h"

#include "session/session.h"

namespace rasterwalk {

namespace {

bool move_between(Session& session, std::vector<Place>& from, std::vector<Place>& to) {
    if (from.empty()) return false;
    PlaceHistory& places = session.places;
    to.push_back(places.now);
    places.now = from.back();
    from.pop_back();
    Place& here = session;
    here = places.now;
    session.play.running = false;
    return true;
}

} // namespace

void record_visit(Session& session) {
    PlaceHistory& places = session.places;
    const Place& place = session;
    const bool is_new = place.selection != places.now.selection || session.jumps != places.jumps;
    if (is_new && place != places.now) {
        if (places.past.size() == most_places) places.past.erase(places.past.begin());
        places.past.push_back(places.now);
        places.future.clear();
    }
    places.now = place;
    places.jumps = session.jumps;
}

bool go_back(Session& session) {
    record_visit(session);
    return move_between(session, session.places.past, session.places.future);
}

bool go_forward(Session& session) {
    record_visit(session);
    return move_between(session, session.places.future, session.places.past);
}

} // namespace rasterwalk
