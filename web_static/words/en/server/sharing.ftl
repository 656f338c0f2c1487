### Texts about share links, by which a person outside of the clinic reads the records of one patient.

sharing-no-link = There is no share link { $link }: choose one of the list.
sharing-links-most = { $most } links of this patient can be opened already: revoke one first.
sharing-link-revoked = This link was revoked already.
sharing-wrong-pin = The link or the PIN is wrong, or the link has ended: ask the clinic for a new one.
sharing-no-pin = Give the PIN of this link: it was told to you separately.
