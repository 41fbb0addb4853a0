"""Parts of surrogates."""
