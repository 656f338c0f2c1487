/** Names of the path measures. */
export default {
  "measure.dist": "Dist, distance driven",
  "measure.e_diff": "E_diff, area beside the path",
  "measure.time": "Time",
  "measure.dist_ratio": "Distance over path length",
  "measure.cross_track_rms": "Distance from the path (rms)",
  "measure.cross_track_max": "Largest distance from the path",
  "measure.mean_speed": "Mean speed",
  "measure.stops": "Stops",
  "measure.collisions": "Contacts",
  "measure.contact_time": "Time in contact",
  "measure.turn_reversals": "Changes of turning",
  "measure.pulses_per_metre": "Commands per metre",
  "measure.sparc": "Smoothness (SPARC)",
  "measure.ldlj": "Smoothness (log jerk)",
};
