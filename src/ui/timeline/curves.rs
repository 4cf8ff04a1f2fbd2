//! Curves of one node over time, worked out apart from painting.
