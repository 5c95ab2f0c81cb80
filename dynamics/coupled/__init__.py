"""The disk on an elastic, rough contact.

contact, creep, table -- the law of the contact as data; resonance -- the disk on its springs; roughness, profile --
heights of table and edge; filter -- the force of a contact that is kept, along a rigid motion; full -- the compliant
motion, of the steps in march, normal, tangential and gap on the array of state, entered and read by handover; waves,
waving, bending -- the steps on a table that acts back, and of a disk that bends on it; sections, from_scene, choice --
what a scene asks for, and which model it needs; motion, record -- the solved motion.
"""
