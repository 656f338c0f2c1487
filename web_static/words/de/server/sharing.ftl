### Texts about share links, by which a person outside of the clinic reads the records of one patient.

sharing-no-link = Es gibt keinen geteilten Link { $link }. Wählen Sie einen aus der Liste.
sharing-links-most = Für diesen Patienten lassen sich schon { $most } Links öffnen. Widerrufen Sie zuerst einen.
sharing-link-revoked = Dieser Link wurde schon widerrufen.
sharing-wrong-pin = Der Link oder die PIN ist falsch, oder der Link ist beendet. Bitten Sie die Klinik um einen neuen.
sharing-no-pin = Geben Sie die PIN dieses Links ein. Sie wurde Ihnen getrennt mitgeteilt.
