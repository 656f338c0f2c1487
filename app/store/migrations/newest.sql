CREATE TABLE alembic_version (
	version_num VARCHAR(32) NOT NULL, 
	CONSTRAINT alembic_version_pkc PRIMARY KEY (version_num)
);

CREATE TABLE clinic (
	id INTEGER NOT NULL, 
	name VARCHAR(80) NOT NULL, 
	created DATETIME NOT NULL, 
	shirt JSON, 
	body JSON, 
	unused JSON NOT NULL, chair JSON, limits JSON, head JSON, 
	CONSTRAINT pk_clinic PRIMARY KEY (id)
);

CREATE TABLE log (
	id INTEGER NOT NULL, 
	at DATETIME NOT NULL, 
	person VARCHAR(80), 
	what VARCHAR(40) NOT NULL, 
	details JSON NOT NULL, 
	previous_hash VARCHAR(64) NOT NULL, 
	hash VARCHAR(64) NOT NULL, 
	CONSTRAINT pk_log PRIMARY KEY (id)
);

CREATE TABLE patient (
	id INTEGER NOT NULL, 
	clinic_id INTEGER NOT NULL, 
	code VARCHAR(64) NOT NULL, 
	pseudonym VARCHAR(80) NOT NULL, 
	note VARCHAR(2000) NOT NULL, 
	created DATETIME NOT NULL, 
	deleted DATETIME, adaptation VARCHAR(8) DEFAULT 'off' NOT NULL, deletion_reason VARCHAR(400), 
	CONSTRAINT pk_patient PRIMARY KEY (id), 
	CONSTRAINT fk_patient_clinic_id FOREIGN KEY(clinic_id) REFERENCES clinic (id), 
	CONSTRAINT uq_patient_clinic_id_code UNIQUE (clinic_id, code)
);

CREATE TABLE person (
	id INTEGER NOT NULL, 
	clinic_id INTEGER NOT NULL, 
	name VARCHAR(80) NOT NULL, 
	role VARCHAR(16) NOT NULL, 
	password_hash VARCHAR, 
	created DATETIME NOT NULL, 
	disabled DATETIME, patients JSON, introduced BOOLEAN DEFAULT '0' NOT NULL, 
	CONSTRAINT pk_person PRIMARY KEY (id), 
	CONSTRAINT fk_person_clinic_id FOREIGN KEY(clinic_id) REFERENCES clinic (id), 
	CONSTRAINT uq_person_clinic_id_name UNIQUE (clinic_id, name)
);

CREATE TABLE auth_session (
	id INTEGER NOT NULL, 
	token_hash VARCHAR(64) NOT NULL, 
	person_id INTEGER NOT NULL, 
	created DATETIME NOT NULL, 
	expires DATETIME NOT NULL, active DATETIME DEFAULT '2000-01-01 00:00:00.000000' NOT NULL, 
	CONSTRAINT pk_auth_session PRIMARY KEY (id), 
	CONSTRAINT fk_auth_session_person_id FOREIGN KEY(person_id) REFERENCES person (id), 
	CONSTRAINT uq_auth_session_token_hash UNIQUE (token_hash)
);

CREATE TABLE session (
	id INTEGER NOT NULL, 
	clinic_id INTEGER NOT NULL, 
	patient_id INTEGER NOT NULL, 
	number INTEGER NOT NULL, 
	started DATETIME NOT NULL, 
	ended DATETIME, 
	script JSON, 
	current_step VARCHAR(64), 
	result JSON, 
	accepted BOOLEAN NOT NULL, screen JSON, opened_by VARCHAR(80), goal VARCHAR(1000) DEFAULT '' NOT NULL, version VARCHAR(40) DEFAULT '' NOT NULL, 
	CONSTRAINT pk_session PRIMARY KEY (id), 
	CONSTRAINT fk_session_clinic_id FOREIGN KEY(clinic_id) REFERENCES clinic (id), 
	CONSTRAINT fk_session_patient_id FOREIGN KEY(patient_id) REFERENCES patient (id), 
	CONSTRAINT uq_session_patient_id_number UNIQUE (patient_id, number)
);

CREATE UNIQUE INDEX uq_session_open ON session (clinic_id) WHERE ended IS NULL;

CREATE TABLE profile (
	id INTEGER NOT NULL, 
	patient_id INTEGER NOT NULL, 
	session_id INTEGER NOT NULL, 
	version INTEGER NOT NULL, 
	document JSON NOT NULL, 
	created DATETIME NOT NULL, origin VARCHAR(16) DEFAULT 'calibration' NOT NULL, parent INTEGER, difference JSON, simulated BOOLEAN, 
	CONSTRAINT pk_profile PRIMARY KEY (id), 
	CONSTRAINT fk_profile_patient_id FOREIGN KEY(patient_id) REFERENCES patient (id), 
	CONSTRAINT fk_profile_session_id FOREIGN KEY(session_id) REFERENCES session (id), 
	CONSTRAINT uq_profile_patient_id_version UNIQUE (patient_id, version)
);

CREATE TABLE run (
	id VARCHAR(36) NOT NULL, 
	session_id INTEGER NOT NULL, 
	kind VARCHAR(16) NOT NULL, 
	folder VARCHAR NOT NULL, 
	started DATETIME NOT NULL, 
	ended DATETIME, 
	rows INTEGER, 
	dropped INTEGER, shirt VARCHAR(32) DEFAULT 'unknown' NOT NULL, body VARCHAR(32), chair VARCHAR(32) DEFAULT 'unknown' NOT NULL, simulated BOOLEAN, 
	CONSTRAINT pk_run PRIMARY KEY (id), 
	CONSTRAINT fk_run_session_id FOREIGN KEY(session_id) REFERENCES session (id)
);

CREATE INDEX ix_run_session_id ON run (session_id);

CREATE TABLE calibration_step (
	session_id INTEGER NOT NULL, 
	step VARCHAR(64) NOT NULL, 
	status VARCHAR(16) NOT NULL, 
	words VARCHAR(400) NOT NULL, 
	run_id VARCHAR(36), 
	CONSTRAINT pk_calibration_step PRIMARY KEY (session_id, step), 
	CONSTRAINT fk_calibration_step_run_id FOREIGN KEY(run_id) REFERENCES run (id), 
	CONSTRAINT fk_calibration_step_session_id FOREIGN KEY(session_id) REFERENCES session (id)
);

CREATE TABLE parameters (
	id INTEGER NOT NULL, 
	profile_id INTEGER NOT NULL, 
	title VARCHAR(80) NOT NULL, 
	settings JSON NOT NULL, 
	hash VARCHAR(64) NOT NULL, 
	created DATETIME NOT NULL, 
	current BOOLEAN NOT NULL, 
	abandoned BOOLEAN NOT NULL, 
	CONSTRAINT pk_parameters PRIMARY KEY (id), 
	CONSTRAINT fk_parameters_profile_id FOREIGN KEY(profile_id) REFERENCES profile (id)
);

CREATE INDEX ix_parameters_profile_id ON parameters (profile_id);

CREATE TABLE trial (
	id INTEGER NOT NULL, 
	clinic_id INTEGER NOT NULL, 
	patient_id INTEGER NOT NULL, 
	session_id INTEGER NOT NULL, 
	parameters_id INTEGER NOT NULL, 
	run_id VARCHAR(36) NOT NULL, 
	number INTEGER NOT NULL, 
	floorplan VARCHAR(64) NOT NULL, 
	floorplan_title VARCHAR(80) NOT NULL, 
	path VARCHAR(64) NOT NULL, 
	path_points JSON NOT NULL, 
	started DATETIME NOT NULL, 
	status VARCHAR(16) NOT NULL, 
	"end" VARCHAR(16), 
	kept BOOLEAN NOT NULL, 
	discard_reason VARCHAR(200), 
	measures JSON, quality JSON, 
	CONSTRAINT pk_trial PRIMARY KEY (id), 
	CONSTRAINT fk_trial_clinic_id FOREIGN KEY(clinic_id) REFERENCES clinic (id), 
	CONSTRAINT fk_trial_parameters_id FOREIGN KEY(parameters_id) REFERENCES parameters (id), 
	CONSTRAINT fk_trial_patient_id FOREIGN KEY(patient_id) REFERENCES patient (id), 
	CONSTRAINT fk_trial_run_id FOREIGN KEY(run_id) REFERENCES run (id), 
	CONSTRAINT fk_trial_session_id FOREIGN KEY(session_id) REFERENCES session (id), 
	CONSTRAINT uq_trial_patient_id_floorplan_path_number UNIQUE (patient_id, floorplan, path, number)
);

CREATE TRIGGER log_no_update BEFORE UPDATE ON log BEGIN SELECT RAISE(ABORT, 'the log is only ever appended to'); END;

CREATE TRIGGER log_no_delete BEFORE DELETE ON log BEGIN SELECT RAISE(ABORT, 'the log is only ever appended to'); END;

CREATE TABLE chair (
	id INTEGER NOT NULL, 
	clinic_id INTEGER NOT NULL, 
	name VARCHAR(80) NOT NULL, 
	host VARCHAR(253) NOT NULL, 
	port INTEGER NOT NULL, 
	key_id INTEGER NOT NULL, 
	speeds JSON NOT NULL, 
	paired DATETIME NOT NULL, 
	removed DATETIME, 
	CONSTRAINT pk_chair PRIMARY KEY (id), 
	CONSTRAINT fk_chair_clinic_id FOREIGN KEY(clinic_id) REFERENCES clinic (id), 
	CONSTRAINT uq_chair_clinic_id_key_id UNIQUE (clinic_id, key_id)
);

CREATE TABLE drive (
	id INTEGER NOT NULL, 
	clinic_id INTEGER NOT NULL, 
	patient_id INTEGER NOT NULL, 
	session_id INTEGER NOT NULL, 
	run_id VARCHAR(36) NOT NULL, 
	chair_id INTEGER NOT NULL, 
	parameters_id INTEGER NOT NULL, 
	hash VARCHAR(64) NOT NULL, 
	started DATETIME NOT NULL, 
	ended DATETIME, 
	"end" VARCHAR(16), 
	distance FLOAT, 
	CONSTRAINT pk_drive PRIMARY KEY (id), 
	CONSTRAINT fk_drive_chair_id FOREIGN KEY(chair_id) REFERENCES chair (id), 
	CONSTRAINT fk_drive_clinic_id FOREIGN KEY(clinic_id) REFERENCES clinic (id), 
	CONSTRAINT fk_drive_parameters_id FOREIGN KEY(parameters_id) REFERENCES parameters (id), 
	CONSTRAINT fk_drive_patient_id FOREIGN KEY(patient_id) REFERENCES patient (id), 
	CONSTRAINT fk_drive_run_id FOREIGN KEY(run_id) REFERENCES run (id), 
	CONSTRAINT fk_drive_session_id FOREIGN KEY(session_id) REFERENCES session (id)
);

CREATE INDEX ix_drive_patient_id ON drive (patient_id);

CREATE TABLE patient_screen (
	id INTEGER NOT NULL, 
	clinic_id INTEGER NOT NULL, 
	session_id INTEGER NOT NULL, 
	token_hash VARCHAR(64) NOT NULL, 
	number INTEGER NOT NULL, 
	paired DATETIME NOT NULL, 
	expires DATETIME NOT NULL, 
	unpaired DATETIME, 
	CONSTRAINT pk_patient_screen PRIMARY KEY (id), 
	CONSTRAINT fk_patient_screen_clinic_id FOREIGN KEY(clinic_id) REFERENCES clinic (id), 
	CONSTRAINT fk_patient_screen_session_id FOREIGN KEY(session_id) REFERENCES session (id), 
	CONSTRAINT uq_patient_screen_token_hash UNIQUE (token_hash)
);

CREATE INDEX ix_patient_screen_session_id ON patient_screen (session_id);

CREATE TABLE known_browser (
	id INTEGER NOT NULL, 
	person_id INTEGER NOT NULL, 
	token_hash VARCHAR(64) NOT NULL, 
	created DATETIME NOT NULL, 
	expires DATETIME NOT NULL, 
	CONSTRAINT pk_known_browser PRIMARY KEY (id), 
	CONSTRAINT fk_known_browser_person_id FOREIGN KEY(person_id) REFERENCES person (id), 
	CONSTRAINT uq_known_browser_token_hash UNIQUE (token_hash)
);

CREATE INDEX ix_known_browser_person_id ON known_browser (person_id);

CREATE TABLE invitation (
	id INTEGER NOT NULL, 
	person_id INTEGER NOT NULL, 
	code_hash VARCHAR(64) NOT NULL, 
	created DATETIME NOT NULL, 
	expires DATETIME NOT NULL, 
	CONSTRAINT pk_invitation PRIMARY KEY (id), 
	CONSTRAINT fk_invitation_person_id FOREIGN KEY(person_id) REFERENCES person (id), 
	CONSTRAINT uq_invitation_person_id UNIQUE (person_id), 
	CONSTRAINT uq_invitation_code_hash UNIQUE (code_hash)
);

CREATE TABLE session_note (
	id INTEGER NOT NULL, 
	session_id INTEGER NOT NULL, 
	CONSTRAINT pk_session_note PRIMARY KEY (id), 
	CONSTRAINT fk_session_note_session_id FOREIGN KEY(session_id) REFERENCES session (id)
);

CREATE INDEX ix_session_note_session_id ON session_note (session_id);

CREATE TABLE note_revision (
	id INTEGER NOT NULL, 
	note_id INTEGER NOT NULL, 
	text VARCHAR(8000) NOT NULL, 
	person VARCHAR(80) NOT NULL, 
	written DATETIME NOT NULL, 
	CONSTRAINT pk_note_revision PRIMARY KEY (id), 
	CONSTRAINT fk_note_revision_note_id FOREIGN KEY(note_id) REFERENCES session_note (id)
);

CREATE INDEX ix_note_revision_note_id ON note_revision (note_id);

CREATE TABLE outcome_scale (
	id INTEGER NOT NULL, 
	session_id INTEGER NOT NULL, 
	name VARCHAR(80) NOT NULL, 
	total FLOAT NOT NULL, 
	day DATE NOT NULL, 
	CONSTRAINT pk_outcome_scale PRIMARY KEY (id), 
	CONSTRAINT fk_outcome_scale_session_id FOREIGN KEY(session_id) REFERENCES session (id)
);

CREATE INDEX ix_outcome_scale_session_id ON outcome_scale (session_id);

CREATE TABLE session_sign_off (
	id INTEGER NOT NULL, 
	session_id INTEGER NOT NULL, 
	person VARCHAR(80) NOT NULL, 
	at DATETIME NOT NULL, 
	unlocked DATETIME, 
	unlocked_by VARCHAR(80), 
	reason VARCHAR(200), 
	CONSTRAINT pk_session_sign_off PRIMARY KEY (id), 
	CONSTRAINT fk_session_sign_off_session_id FOREIGN KEY(session_id) REFERENCES session (id)
);

CREATE INDEX ix_session_sign_off_session_id ON session_sign_off (session_id);

CREATE UNIQUE INDEX uq_session_sign_off_in_force ON session_sign_off (session_id) WHERE unlocked IS NULL;

CREATE TABLE patient_consent (
	id INTEGER NOT NULL, 
	patient_id INTEGER NOT NULL, 
	consent VARCHAR(16) NOT NULL, 
	given DATE NOT NULL, 
	person VARCHAR(80), 
	written DATETIME NOT NULL, 
	withdrawn DATETIME, 
	withdrawn_by VARCHAR(80), 
	CONSTRAINT pk_patient_consent PRIMARY KEY (id), 
	CONSTRAINT fk_patient_consent_patient_id FOREIGN KEY(patient_id) REFERENCES patient (id)
);

CREATE INDEX ix_patient_consent_patient_id ON patient_consent (patient_id);

CREATE UNIQUE INDEX uq_patient_consent_in_force ON patient_consent (patient_id, consent) WHERE withdrawn IS NULL;

CREATE TABLE record_keeping (
	clinic_id INTEGER NOT NULL, 
	years INTEGER, 
	folder VARCHAR, 
	hour INTEGER DEFAULT '2' NOT NULL, 
	with_keys BOOLEAN DEFAULT '0' NOT NULL, 
	CONSTRAINT pk_record_keeping PRIMARY KEY (clinic_id), 
	CONSTRAINT fk_record_keeping_clinic_id FOREIGN KEY(clinic_id) REFERENCES clinic (id)
);

CREATE TABLE erased_patient (
	id INTEGER NOT NULL, 
	created DATETIME NOT NULL, 
	erased DATETIME NOT NULL, 
	files JSON NOT NULL, 
	CONSTRAINT pk_erased_patient PRIMARY KEY (id)
);

CREATE TABLE last_id (
	name VARCHAR(64) NOT NULL, 
	id INTEGER NOT NULL, 
	CONSTRAINT pk_last_id PRIMARY KEY (name)
);

CREATE TABLE patient_file (
	id INTEGER NOT NULL, 
	patient_id INTEGER NOT NULL, 
	name VARCHAR(80) NOT NULL, 
	current BOOLEAN NOT NULL, 
	CONSTRAINT pk_patient_file PRIMARY KEY (id), 
	CONSTRAINT fk_patient_file_patient_id FOREIGN KEY(patient_id) REFERENCES patient (id)
);

CREATE INDEX ix_patient_file_patient_id ON patient_file (patient_id);

CREATE TABLE incident (
	id INTEGER NOT NULL, 
	clinic_id INTEGER NOT NULL, 
	made DATETIME NOT NULL, 
	since DATETIME NOT NULL, 
	hash VARCHAR(64) NOT NULL, 
	lifted DATETIME, 
	reason VARCHAR(400), 
	CONSTRAINT pk_incident PRIMARY KEY (id), 
	CONSTRAINT fk_incident_clinic_id FOREIGN KEY(clinic_id) REFERENCES clinic (id)
);

CREATE TABLE incident_patient (
	incident_id INTEGER NOT NULL, 
	patient_id INTEGER NOT NULL, 
	CONSTRAINT pk_incident_patient PRIMARY KEY (incident_id, patient_id), 
	CONSTRAINT fk_incident_patient_incident_id FOREIGN KEY(incident_id) REFERENCES incident (id), 
	CONSTRAINT fk_incident_patient_patient_id FOREIGN KEY(patient_id) REFERENCES patient (id)
);

CREATE TABLE made_backup (
	id INTEGER NOT NULL, 
	at DATETIME NOT NULL, 
	place VARCHAR NOT NULL, 
	name VARCHAR(80) NOT NULL, 
	in_folder BOOLEAN NOT NULL, 
	good BOOLEAN NOT NULL, 
	words VARCHAR(400) NOT NULL, 
	files INTEGER NOT NULL, 
	bytes INTEGER NOT NULL, 
	encrypted BOOLEAN NOT NULL, 
	with_keys BOOLEAN NOT NULL, 
	CONSTRAINT pk_made_backup PRIMARY KEY (id)
);

CREATE INDEX ix_made_backup_at ON made_backup (at);

CREATE TABLE share_link (
	id INTEGER NOT NULL, 
	clinic_id INTEGER NOT NULL, 
	patient_id INTEGER NOT NULL, 
	session_id INTEGER, 
	token_hash VARCHAR(64) NOT NULL, 
	pin_hash VARCHAR NOT NULL, 
	person VARCHAR(80) NOT NULL, 
	created DATETIME NOT NULL, 
	expires DATETIME NOT NULL, 
	revoked DATETIME, 
	wrong_pins INTEGER NOT NULL, 
	openings INTEGER NOT NULL, 
	CONSTRAINT pk_share_link PRIMARY KEY (id), 
	CONSTRAINT uq_share_link_token_hash UNIQUE (token_hash), 
	CONSTRAINT fk_share_link_clinic_id FOREIGN KEY(clinic_id) REFERENCES clinic (id), 
	CONSTRAINT fk_share_link_patient_id FOREIGN KEY(patient_id) REFERENCES patient (id), 
	CONSTRAINT fk_share_link_session_id FOREIGN KEY(session_id) REFERENCES session (id)
);

CREATE INDEX ix_share_link_patient_id ON share_link (patient_id);

CREATE TABLE share_visit (
	id INTEGER NOT NULL, 
	share_id INTEGER NOT NULL, 
	token_hash VARCHAR(64) NOT NULL, 
	expires DATETIME NOT NULL, 
	CONSTRAINT pk_share_visit PRIMARY KEY (id), 
	CONSTRAINT uq_share_visit_token_hash UNIQUE (token_hash), 
	CONSTRAINT fk_share_visit_share_id FOREIGN KEY(share_id) REFERENCES share_link (id)
);

CREATE INDEX ix_share_visit_share_id ON share_visit (share_id);

CREATE TABLE patient_import (
	id INTEGER NOT NULL, 
	patient_id INTEGER NOT NULL, 
	archive VARCHAR(64) NOT NULL, 
	clinic VARCHAR(80) NOT NULL, 
	person VARCHAR(80) NOT NULL, 
	at DATETIME NOT NULL, 
	CONSTRAINT pk_patient_import PRIMARY KEY (id), 
	CONSTRAINT fk_patient_import_patient_id FOREIGN KEY(patient_id) REFERENCES patient (id), 
	CONSTRAINT uq_patient_import_archive UNIQUE (archive)
);

CREATE INDEX ix_patient_import_patient_id ON patient_import (patient_id);

CREATE TABLE imported_session (
	session_id INTEGER NOT NULL, 
	import_id INTEGER NOT NULL, 
	CONSTRAINT pk_imported_session PRIMARY KEY (session_id), 
	CONSTRAINT fk_imported_session_session_id FOREIGN KEY(session_id) REFERENCES session (id), 
	CONSTRAINT fk_imported_session_import_id FOREIGN KEY(import_id) REFERENCES patient_import (id)
);

CREATE INDEX ix_trial_floorplan_path_status ON trial (floorplan, path, status);

CREATE TABLE interface_test (
	id INTEGER NOT NULL, 
	clinic_id INTEGER NOT NULL, 
	patient_id INTEGER NOT NULL, 
	session_id INTEGER NOT NULL, 
	parameters_id INTEGER NOT NULL, 
	run_id VARCHAR(36) NOT NULL, 
	number INTEGER NOT NULL, 
	started DATETIME NOT NULL, 
	status VARCHAR(16) NOT NULL, 
	"end" VARCHAR(16), 
	"plan" JSON NOT NULL, 
	measures JSON, 
	workload JSON, 
	CONSTRAINT pk_interface_test PRIMARY KEY (id), 
	CONSTRAINT fk_interface_test_clinic_id FOREIGN KEY(clinic_id) REFERENCES clinic (id), 
	CONSTRAINT fk_interface_test_patient_id FOREIGN KEY(patient_id) REFERENCES patient (id), 
	CONSTRAINT fk_interface_test_session_id FOREIGN KEY(session_id) REFERENCES session (id), 
	CONSTRAINT fk_interface_test_parameters_id FOREIGN KEY(parameters_id) REFERENCES parameters (id), 
	CONSTRAINT fk_interface_test_run_id FOREIGN KEY(run_id) REFERENCES run (id), 
	CONSTRAINT uq_interface_test_patient_id_number UNIQUE (patient_id, number)
);

CREATE INDEX ix_interface_test_session_id ON interface_test (session_id);

CREATE TABLE prior_entry (
	id INTEGER NOT NULL, 
	patient_id INTEGER NOT NULL, 
	shirt VARCHAR(64) NOT NULL, 
	simulated BOOLEAN NOT NULL, 
	document JSON NOT NULL, 
	made DATETIME NOT NULL, 
	CONSTRAINT pk_prior_entry PRIMARY KEY (id), 
	CONSTRAINT fk_prior_entry_patient_id FOREIGN KEY(patient_id) REFERENCES patient (id), 
	CONSTRAINT uq_prior_entry_patient_id_shirt_simulated UNIQUE (patient_id, shirt, simulated)
);

CREATE TABLE prior_switch (
	clinic_id INTEGER NOT NULL, 
	"on" BOOLEAN NOT NULL, 
	CONSTRAINT pk_prior_switch PRIMARY KEY (clinic_id), 
	CONSTRAINT fk_prior_switch_clinic_id FOREIGN KEY(clinic_id) REFERENCES clinic (id)
);

CREATE INDEX ix_trial_patient_id_status_kept ON trial (patient_id, status, kept);

CREATE INDEX ix_trial_counted ON trial (clinic_id, patient_id, floorplan, path, run_id) WHERE kept = 1 AND status = 'done' AND measures != 'null';

CREATE TABLE moment_comment (
	id INTEGER NOT NULL, 
	clinic_id INTEGER NOT NULL, 
	trial_id INTEGER NOT NULL, 
	person_id INTEGER, 
	author VARCHAR(80), 
	t FLOAT NOT NULL, 
	withdrawn DATETIME, 
	CONSTRAINT pk_moment_comment PRIMARY KEY (id), 
	CONSTRAINT fk_moment_comment_clinic_id FOREIGN KEY(clinic_id) REFERENCES clinic (id), 
	CONSTRAINT fk_moment_comment_trial_id FOREIGN KEY(trial_id) REFERENCES trial (id), 
	CONSTRAINT fk_moment_comment_person_id FOREIGN KEY(person_id) REFERENCES person (id)
);

CREATE INDEX ix_moment_comment_trial_id ON moment_comment (trial_id);

CREATE TABLE comment_revision (
	id INTEGER NOT NULL, 
	comment_id INTEGER NOT NULL, 
	text VARCHAR(2000) NOT NULL, 
	written DATETIME NOT NULL, 
	CONSTRAINT pk_comment_revision PRIMARY KEY (id), 
	CONSTRAINT fk_comment_revision_comment_id FOREIGN KEY(comment_id) REFERENCES moment_comment (id)
);

CREATE INDEX ix_comment_revision_comment_id ON comment_revision (comment_id);

CREATE TABLE comment_reading (
	comment_id INTEGER NOT NULL, 
	person_id INTEGER NOT NULL, 
	revision_id INTEGER NOT NULL, 
	CONSTRAINT pk_comment_reading PRIMARY KEY (comment_id, person_id), 
	CONSTRAINT fk_comment_reading_comment_id FOREIGN KEY(comment_id) REFERENCES moment_comment (id), 
	CONSTRAINT fk_comment_reading_person_id FOREIGN KEY(person_id) REFERENCES person (id), 
	CONSTRAINT fk_comment_reading_revision_id FOREIGN KEY(revision_id) REFERENCES comment_revision (id)
);

CREATE INDEX ix_auth_session_person_id ON auth_session (person_id);

CREATE INDEX ix_calibration_step_run_id ON calibration_step (run_id);

CREATE INDEX ix_comment_reading_person_id ON comment_reading (person_id);

CREATE INDEX ix_comment_reading_revision_id ON comment_reading (revision_id);

CREATE INDEX ix_drive_session_id ON drive (session_id);

CREATE INDEX ix_drive_run_id ON drive (run_id);

CREATE INDEX ix_drive_chair_id ON drive (chair_id);

CREATE INDEX ix_drive_parameters_id ON drive (parameters_id);

CREATE INDEX ix_imported_session_import_id ON imported_session (import_id);

CREATE INDEX ix_incident_patient_patient_id ON incident_patient (patient_id);

CREATE INDEX ix_interface_test_parameters_id ON interface_test (parameters_id);

CREATE INDEX ix_interface_test_run_id ON interface_test (run_id);

CREATE INDEX ix_moment_comment_person_id ON moment_comment (person_id);

CREATE INDEX ix_profile_session_id ON profile (session_id);

CREATE INDEX ix_share_link_session_id ON share_link (session_id);

CREATE INDEX ix_trial_session_id ON trial (session_id);

CREATE INDEX ix_trial_parameters_id ON trial (parameters_id);

CREATE INDEX ix_trial_run_id ON trial (run_id);

CREATE INDEX ix_trial_patient_id_floorplan_path_status ON trial (patient_id, floorplan, path, status);

CREATE INDEX ix_trial_clinic_id_end_started ON trial (clinic_id, "end", started);

CREATE TABLE passed_time (
	id INTEGER NOT NULL, 
	wall DATETIME NOT NULL, 
	count FLOAT NOT NULL, 
	boot VARCHAR(80) NOT NULL, 
	jumps JSON NOT NULL, 
	CONSTRAINT pk_passed_time PRIMARY KEY (id)
);

INSERT INTO alembic_version (version_num) VALUES ('0020')
