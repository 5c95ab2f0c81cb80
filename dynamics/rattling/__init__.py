"""A disk that rattles: contact anywhere on its rim, at several places at once."""
