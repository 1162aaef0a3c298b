"""Used by every module of the GUI: Qt, translation, theme, units, fault handling and application-wide objects."""
