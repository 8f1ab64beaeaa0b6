"""The offsets that plans tolerate in another engine, compared with those that `assembly-plan tolerance` predicts."""
