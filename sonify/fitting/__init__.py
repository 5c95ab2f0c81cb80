"""RECORDINGS -> WHAT SLOWED THE DISK.

readings -- files as people have them; decline -- how a disk comes to rest, for any share of what slows it; phase -- the
rate of a tone from its phase, in the time that a decline keeps; estimate -- shares and intervals; ear -- which signal,
which line, the verdict; null, synthetic -- other mechanisms through the same ear; fu_berlin -- a published chain;
apart -- several recordings at once; result, report -- files together, and what is written.
"""
