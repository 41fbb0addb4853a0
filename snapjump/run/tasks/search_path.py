"""Hydra's search path for the configurations of members from outside."""

from hydra.core.config_search_path import ConfigSearchPath
from hydra.core.plugins import Plugins
from hydra.plugins.search_path_plugin import SearchPathPlugin

from snapjump.files import sources


class OfPlugins(SearchPathPlugin):
    """Adds the folders of plug-ins that are loaded when Hydra begins."""

    def manipulate_search_path(self, search_path: ConfigSearchPath) -> None:
        for folder in sources.PLUGINS:
            search_path.append("snapjump-plugins", f"file://{folder}")


def search_plugins() -> None:
    """Have Hydra ask for those folders."""
    Plugins.instance().register(OfPlugins)
