### Refusals of the server: notes, scales and the sign-off of a session, two sessions side by side.

records-most-notes = Una sesión puede tener { $count } notas como máximo: corrija una de ellas.
records-no-note = En esta sesión no hay ninguna nota { $number }: elija una de sus notas.
records-most-scales = Una sesión puede tener { $count } escalas como máximo: quite primero una.
records-no-scale = En esta sesión no hay ninguna escala { $number }: elija una de sus escalas.
records-still-driven = En esta sesión todavía hay una conducción o una prueba en marcha: termínela primero y firme después.
records-not-signed = La sesión { $session } no está firmada: ya se puede cambiar.
records-signed = { $person } firmó la sesión { $session } el { $day } a las { $time }, así que nada de ella se puede cambiar: un administrador puede desbloquearla.
records-other-patient = Estas dos sesiones no son del mismo paciente: elija dos sesiones de la misma lista.
records-same-session = Estas dos sesiones son la misma: elija dos distintas.
