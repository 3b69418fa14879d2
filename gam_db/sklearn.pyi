"""The name of ``sklearn.py``, from where it is made."""

from gam_db.lab.sklearn import NoveltyDetector as NoveltyDetector
