"""The disk on an elastic, rough contact: law of the contact, its resonances, roughness, and the motions with both."""
