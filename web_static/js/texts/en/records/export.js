/** Texts of the export of a patient's recordings and measures. */
export default {
  "export.title": "Export for other programs",
  "export.lead": "Recordings and measures as one zip file. It names the patient by the code, and says what was simulated.",
  "export.form": "Form",
  "export.form.csv": "CSV: opens in a spreadsheet",
  "export.form.parquet": "Parquet: for Python and R",
  "export.form.xdf": "XDF: for laboratories that measure movement",
  "export.form.bids": "BIDS-motion: for archives of research data",
  "export.form.fhir": "FHIR: measures for a hospital's records",
  "export.what": "Sessions",
  "export.all": "All sessions",
  "export.session": "Session {number}",
  "export.go": "Export",
  "export.go.label": "Export of {code}",
  "export.wait": "Long recordings take a minute or more. The log keeps who exported what.",
  "export.consent": "An export needs the patient's consent to sharing outside: ask, and enter it above.",
};
