"""The film of air under the disk: its law in the motion, when it acts, and Reynolds' equation that it comes from."""
