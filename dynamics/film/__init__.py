"""Air film under the disk: Reynolds' equation, closed-form forces, and activation."""
