"""What discretizations are made of, and the loose nodes of a scene without a beam."""
