//! Closest reachable motions of spatial linkages.
