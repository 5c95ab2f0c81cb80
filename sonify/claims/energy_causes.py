"""Descriptions of the causes of energy loss."""

CAUSE_IN_WORDS = {
    "contact": "impacts and compression of the contact",
    "creep": "creep of the contact",
    "slip": "sliding",
    "moments": "friction of rolling and pivoting",
    "table": "the table",
    "film": "the film of air",
    "body": "the modes of the disk",
}
"""Description of each cause, by its key."""
