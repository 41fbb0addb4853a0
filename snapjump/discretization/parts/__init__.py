"""Parts of discretizations: elements, chains, and the loose nodes of a scene without a beam."""
