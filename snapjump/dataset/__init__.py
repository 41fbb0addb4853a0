"""Datasets: a plan's jumps in Parquet shards that are written whole, checked and continued."""
