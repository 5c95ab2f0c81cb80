"""A disk that rattles on an uneven table: several intermittent contacts around the rim."""
