"""Pictures of a run folder of Breccia: frames with cracks, histories, the energy ledger."""
