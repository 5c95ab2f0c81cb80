"""Optional packages that only some commands need."""

from importlib.util import find_spec

from sonify.scene_errors import InputError


def require_extra(feature: str, package: str, extra: str) -> None:
    """Raise InputError with the installation command if `package` is not installed.

    Parameters
    ----------
    feature : str
        Start of the message: what requires the package.
    package : str
        Name under which the package is imported.
    extra : str
        Optional dependency of this project that installs the package.
    """
    if find_spec(package) is None:
        raise InputError(
            f"{feature} requires {package}; install it with: "
            f'python -m pip install -e ".[{extra}]"'
        )
