"""The walkthrough for the site and for paper: its chapters, their questions, and handouts to print."""
