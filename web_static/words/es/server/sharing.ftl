### Texts about share links, by which a person outside of the clinic reads the records of one patient.

sharing-no-link = No hay ningún enlace compartido { $link }: elija uno de la lista.
sharing-links-most = Ya se pueden abrir { $most } enlaces de este paciente: anule primero uno.
sharing-link-revoked = Este enlace ya se anuló.
sharing-wrong-pin = El enlace o el PIN no es correcto, o el enlace ya no se puede abrir: pida uno nuevo a la clínica.
sharing-no-pin = Escriba el PIN de este enlace: se le comunicó por separado.
