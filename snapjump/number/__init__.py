"""Numbers that kernels compute with: one robot's, or many robots' side by side."""

from snapjump.number.compile_cache import use_cache_folder

use_cache_folder()
