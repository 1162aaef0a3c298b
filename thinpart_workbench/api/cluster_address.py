"""The address of the scheduler of a Dask cluster."""

from urllib.parse import urlsplit

from ..core.errors import ThinPartError


def cluster_address(text):
    """The complete address of a scheduler; also accepts ``HOST:PORT``.

    Raises
    ------
    ThinPartError
        kind ``usage``.
    """
    address = text if "://" in text else f"tcp://{text}"
    try:
        parts = urlsplit(address)
        usable = parts.scheme in ("tcp", "tls") and parts.hostname and parts.port
    except ValueError:
        usable = False
    if not usable or parts.path or parts.query or parts.username:
        raise ThinPartError(
            f"'{text}' is not the address of a Dask scheduler: write it as tcp://HOST:PORT.", "usage")
    return address
