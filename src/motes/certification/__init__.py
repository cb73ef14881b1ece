"""Proof that something reflects as it must, or its fault: `certify`, for materials, functions, other programs' BSDFs and tables."""

from motes.certification.certificate import Certificate, Check, Finding, Outcome
from motes.certification.certifying import certify
from motes.certification.specimen import Drawn, Specimen

__all__ = ["Certificate", "Check", "Drawn", "Finding", "Outcome", "Specimen", "certify"]
