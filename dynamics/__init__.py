"""SCENE -> MOTION: a rigid disk that rolls and slides on a plane, event by event."""
