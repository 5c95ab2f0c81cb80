"""The last milliseconds: a nearly flat disk without its rolling contact comes to rest."""
