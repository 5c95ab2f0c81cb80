"""Short scripts to begin with: `python -m sonify.examples.one_motion`, and so on;
tests/cli/test_examples.py runs each."""
