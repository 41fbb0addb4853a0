"""Time saved and error made by what each scene leaves out."""
