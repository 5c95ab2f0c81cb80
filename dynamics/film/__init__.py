"""Air film under the disk: its law in the motion, the decision when it acts, and Reynolds' equation
behind the law.
"""
