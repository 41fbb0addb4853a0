"""Are the sensitivities right, and what do they cost?"""
