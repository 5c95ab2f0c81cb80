"""Methods to compare with: textbook schemes and the event-driven model on other integrators."""
