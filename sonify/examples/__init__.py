"""Short example scripts, run for example with `python -m sonify.examples.one_motion`;
tests/cli/test_examples.py runs each of them."""
