"""Plan of a run: its models, its omissions with reasons, and its predicted errors."""
