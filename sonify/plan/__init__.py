"""SCENE -> PLAN: the models of a run, its omissions with reasons, and its predicted errors."""
