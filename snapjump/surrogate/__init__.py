"""Networks and other learners of the map from designs to apexes, one file each."""
