"""Motion of the disk on an elastic, rough contact.

contact, creep, table -- law of the contact as data resonance -- linearised contact roughness,
profile -- heights of table and edge filter -- vibration of a contact without loss, along a rigid
motion full -- compliant motion, with the steps of march, normal, tangential and gap on the state of
state.py handover -- conversion between this state and the columns of a Motion waves, waving,
bending -- steps on a table with modes, and of a disk that bends on it sections, from_scene, choice,
acting -- sections of a scene, and the choice of the model motion, record, handed -- the solved
motion
"""
