"""Air film under the disk: Reynolds' equation, forces in closed form, and when the film acts."""
